# SPDX-License-Identifier: MIT
"""The package keeps to its types, which editors show."""

import subprocess
import sys

import pytest


def test_mypy_finds_nothing(source, tmp_path):
    pytest.importorskip("mypy", reason="mypy is not installed (Debian: mypy)")
    words = ["--config-file", source / "python/mypy.ini", "--cache-dir", tmp_path, source / "python/talus"]
    done = subprocess.run([sys.executable, "-m", "mypy", *words], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
