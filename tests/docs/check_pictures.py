# SPDX-License-Identifier: GPL-3.0-or-later
"""check_pictures.py ROOT VERSION: the pictures of pages are of this version and show the figures of README.md."""
import hashlib
import json
import re
import sys
from pathlib import Path

ADVICE = "take the pictures again: scripts/page_pictures"


def faults(root, version):
    images = root / "docs/images"
    record = json.loads((images / "pages.json").read_text(encoding="utf-8"))
    if record["version"] != version:
        yield f"the pictures are of version {record['version']}, not {version}"
    for name, expected in record["sha256"].items():
        if hashlib.sha256((images / name).read_bytes()).hexdigest() != expected:
            yield f"{name} is another picture than the one that was recorded"
    lines = (root / "README.md").read_text(encoding="utf-8").splitlines()
    for method, figures in record["quickstart"].items():
        row = next((line for line in lines if line.startswith(f"{method}  ")), "")
        shown = re.findall(r"\d+\.\d\d", row)
        if shown != figures:
            yield f"report.png shows {figures} for {method}, README.md {shown}"


def main():
    found = list(faults(Path(sys.argv[1]), sys.argv[2]))
    for fault in found:
        print(f"{fault}; {ADVICE}", file=sys.stderr)
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
