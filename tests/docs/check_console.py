#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the commands on a page and compares their output with that on the page.

    check_console.py PAGE FOLDER [--update | --any-numbers]

Blocks marked `console` hold commands behind "$ ", each followed by its standard output. A block marked `json` is first
written to the file that the text before it names last. Commands run in FOLDER, which is emptied first. Lines are counted and
numbers compared, within 1 % as the last digits depend on the processor; words may differ. With --update the outputs are
written into the page. With --any-numbers they are only counted: other compilers and CGAL 6 generate other shapes.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

BLOCK = re.compile(r"```(console|json)\n(.*?)```", re.DOTALL)


def run(command, folder):
    """Returns the standard output of a command; exits if it fails."""
    result = subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(f"{command}: exit status {result.returncode}\n{result.stderr}")
    return result.stdout


def numbers(text):
    """Returns the numbers in a text."""
    words = (word.strip("[],+") for word in text.split())
    return [float(word) for word in words if re.fullmatch(r"-?[0-9.]*[0-9](e[-+]?[0-9]+)?", word)]


def same(shown, printed):
    """Returns whether two outputs have equally many lines and nearly equal numbers."""
    pairs = list(zip(numbers(shown), numbers(printed)))
    complete = len(numbers(shown)) == len(numbers(printed)) and shown.count("\n") == printed.count("\n")
    close = all(abs(one - other) <= 0.01 * max(abs(one), abs(other)) for one, other in pairs)
    return complete and (close or "--any-numbers" in sys.argv)


def main():
    page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    os.environ["SHAPEGAUGE_CACHE"] = str(folder.resolve() / "cache")
    text = page.read_text(encoding="utf-8")
    differing = commands = 0

    def replay(match):
        nonlocal differing, commands
        kind, body = match.groups()
        if kind == "json":
            name = re.findall(r"`([\w.]+\.json)`", text[:match.start()])[-1]
            (folder / name).write_text(body, encoding="utf-8")
            return match.group(0)
        printed = ""
        for command, shown in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", body, re.MULTILINE):
            commands += 1
            output = run(command, folder)
            printed += f"$ {command}\n{output}"
            if not same(shown, output):
                differing += 1
                print(f"{page}: $ {command}\nshown:\n{shown}\nprinted:\n{output}", file=sys.stderr)
        return f"```console\n{printed}```"

    replayed = BLOCK.sub(replay, text)
    print(f"{commands} commands, {differing} with another output than {page} shows")
    if "--update" in sys.argv:
        page.write_text(replayed, encoding="utf-8")
        return 0
    return 0 if commands > 0 and differing == 0 else 1


sys.exit(main())
