#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the dependencies of libraries against docs/developer/architecture.md.

    check_borders.py ARCHITECTURE.md LIBRARIES COMPILER

LIBRARIES has a line for each library: its name, its headers and the include directories of its sources, between
semicolons; and one without headers for each program. An include of a header of another library must compile where the
page says that the library knows it, by itself or through others, and must not be found where it does not. No header of a
library is found without the prefix shapegauge/.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys


def known_libraries(page):
    """Returns the permitted dependencies of each library, from the table on the page."""
    row = re.compile(r"^\|[^|]*\| `shapegauge::(\w+)` \|[^|]*\|([^|]*)\|$", re.MULTILINE)
    return {name: re.findall(r"\w+", known) for name, known in row.findall(page)}


def closure(name, known):
    """Returns the libraries reachable from one, including itself."""
    reached = {name}
    waiting = [name]
    while waiting:
        for other in known[waiting.pop()]:
            if other not in reached:
                reached.add(other)
                waiting.append(other)
    return reached


def compiles(compiler, header, folders):
    """Returns whether the preprocessor finds the header, regardless of the headers that it includes."""
    command = [compiler, "-x", "c++", "-std=c++20", "-E", "-"]
    command += [f"-I{folder}" for folder in folders]
    program = f"#if !__has_include(<{header}>)\n#error absent\n#endif\n"
    return subprocess.run(command, input=program, text=True, capture_output=True).returncode == 0


def main():
    page, listing, compiler = sys.argv[1:]
    known = known_libraries(pathlib.Path(page).read_text())
    libraries = {}
    folders_of = {}
    for line in pathlib.Path(listing).read_text().splitlines():
        name, headers, folders = line.split("|")
        folders_of[name] = [folder for folder in folders.split(";") if folder]
        if headers:
            libraries[name] = headers.split(";")[0]
    errors = [f"docs/developer/architecture.md has no library {name}" for name in libraries.keys() - known.keys()]
    errors += [f"there is no library {name} of docs/developer/architecture.md" for name in known.keys() - libraries.keys()]
    for name in known:
        errors += [f"{name} knows {other}, which is no library" for other in known[name] if other not in known]
    if errors:
        sys.exit("\n".join(errors))

    def check(name, other):
        allowed = other in closure(name, known)
        found = compiles(compiler, libraries[other], folders_of[name])
        if found == allowed:
            return None
        return f"{name} {'sees' if found else 'does not see'} {libraries[other]} of {other}"

    def check_prefix(name, other):
        header = libraries[other].removeprefix("shapegauge/")
        return f"{name} sees {header} without its prefix" if compiles(compiler, header, folders_of[name]) else None

    pairs = [(name, other) for name in libraries for other in libraries]
    prefixes = [(name, other) for name in folders_of for other in libraries if name == other or name not in libraries]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        wrong = [error for error in pool.map(lambda pair: check(*pair), pairs) if error]
        wrong += [error for error in pool.map(lambda pair: check_prefix(*pair), prefixes) if error]
    forbidden = sum(other not in closure(name, known) for name, other in pairs)
    if not forbidden:
        wrong.append("no include is forbidden: nothing was tested")
    print(f"{len(pairs)} includes tried, of which {forbidden} must not compile")
    sys.exit("\n".join(wrong) if wrong else 0)


main()
