#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the dependencies of libraries against docs/developer/architecture.md.

    check_borders.py ARCHITECTURE.md LIBRARIES COMPILER

LIBRARIES has a line for each library: its name, its headers and the include directories of its sources, between
semicolons; and one without headers for each program. An include of a header of another library must be found where the
page says that the library knows it, by itself or through others, and must not be found where it does not. No header of a
library is found without the prefix shapegauge/. The preprocessor runs once for each library and program.
"""

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


def found_headers(compiler, headers, folders):
    """Returns those of the headers that an include finds in the folders."""
    program = "".join(f"#if __has_include(<{header}>)\n{i}\n#endif\n" for i, header in enumerate(headers))
    command = [compiler, "-x", "c++", "-std=c++20", "-E", "-P", "-", *(f"-I{folder}" for folder in folders)]
    output = subprocess.run(command, input=program, text=True, capture_output=True, check=True).stdout
    return {headers[int(i)] for i in output.split()}


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

    wrong = []
    without_prefix = [header.removeprefix("shapegauge/") for header in libraries.values()]
    for name, folders in folders_of.items():
        found = found_headers(compiler, [*libraries.values(), *without_prefix], folders)
        wrong += [f"{name} sees {header} without its prefix" for header in without_prefix if header in found]
        if name in libraries:
            allowed = closure(name, known)
            wrong += [f"{name} {'sees' if header in found else 'does not see'} {header} of {other}"
                      for other, header in libraries.items() if (header in found) != (other in allowed)]
    pairs = [(name, other) for name in libraries for other in libraries]
    forbidden = sum(other not in closure(name, known) for name, other in pairs)
    if not forbidden:
        wrong.append("no include is forbidden: nothing was tested")
    print(f"{len(pairs)} includes tried, of which {forbidden} must not be found")
    sys.exit("\n".join(wrong) if wrong else 0)


main()
