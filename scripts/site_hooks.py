# SPDX-License-Identifier: GPL-3.0-or-later
"""Hooks of mkdocs: links to files of the repository that are no pages become plain names; the first page leads to the examples
and to the C++ reference that scripts/site adds."""

import posixpath
import re

EXAMPLES = """
## Examples

- <a href="examples/report.html">A report</a>: four methods on generated shapes
- <a href="examples/view.html">A view</a>: two shapes in 3D, with fields and parts
- <a href="cpp/index.html">The C++ reference</a>
"""
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)\s:]+)\)")


def on_page_markdown(markdown, page, **_):
    """The text of a page, in which links that lead out of docs/ are replaced by their texts; the examples on the first page."""
    folder = posixpath.dirname(page.file.src_path)

    def replace(match):
        text, target = match.groups()
        path = posixpath.normpath(posixpath.join(folder, target.partition("#")[0]))
        if not path.startswith(".."):
            return match.group(0)
        return text if "`" in text else f"`{text}`"

    text = LINK.sub(replace, markdown)
    return text + EXAMPLES if page.file.src_path == "index.md" else text
