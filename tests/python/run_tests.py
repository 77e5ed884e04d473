# SPDX-License-Identifier: GPL-3.0-or-later
"""run_tests.py MODULE...: runs pytest on these modules of tests; exit status 77 if a package is missing."""

import sys

try:
    import numpy  # noqa: F401
    import pytest
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.exit(pytest.main(["-q", "-rs", "-p", "no:cacheprovider", *sys.argv[1:]]))
