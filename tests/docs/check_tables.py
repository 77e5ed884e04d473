#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the rows of all Markdown tables have as many cells as their headers: check_tables.py ROOT"""

import pathlib
import re
import sys


def cells(row):
    """Returns the number of cells of a row; escaped bars are text."""
    return len(re.findall(r"(?<!\\)\|", row.strip().strip("|"))) + 1


def broken_rows(page):
    """Returns a message for each row that differs from the header of its table. Code blocks are skipped."""
    lines = page.read_text(encoding="utf-8").splitlines()
    header, is_code, messages = None, False, []
    for number, (line, following) in enumerate(zip(lines, [*lines[1:], ""]), 1):
        is_code ^= line.startswith("```")
        if header is None and not is_code and re.fullmatch(r"\|(:?-+:?\|)+", following):
            header = cells(line)
        elif header is not None and not line.strip():
            header = None
        elif header is not None and cells(line) != header:
            messages.append(f"{page}:{number}: {cells(line)} cells, the header has {header}")
    return messages


root = pathlib.Path(sys.argv[1])
pages = sorted([*root.glob("*.md"), *root.glob("docs/**/*.md")])
broken = [message for page in pages for message in broken_rows(page)]
print("\n".join(broken) or f"the tables of {len(pages)} pages are complete")
sys.exit(1 if broken or not pages else 0)
