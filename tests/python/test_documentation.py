"""What docs/python.md shows is what one gets."""

import os
import re
import subprocess
import sys


def test_the_example_prints_what_the_page_says():
    page = os.path.join(os.environ["SHAPEGAUGE_CONFIGS"], "..", "docs", "python.md")
    with open(page, encoding="utf-8") as file:
        example, output = re.search(r"```python\n(.*?)```\n\nprints\n\n```\n(.*?)```", file.read(), re.S).groups()
    run = subprocess.run([sys.executable, "-c", example], check=True, capture_output=True, text=True)
    assert run.stdout == output
