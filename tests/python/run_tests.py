# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs pytest on this folder; exit status 77 if a package is missing."""

import os
import sys

try:
    import numpy  # noqa: F401
    import pytest
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.exit(pytest.main(["-q", "-rs", "-p", "no:cacheprovider", os.path.dirname(os.path.abspath(__file__))]))
