#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs tests of the Python package by pytest, or says what they lack.

usage: run.py --build FOLDER --needs MODULE,... FILE...
Exit code 77: a module that the tests need is not installed.
"""
import argparse
import importlib.util
import os
import pathlib
import sys
import tempfile


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=pathlib.Path, required=True)
    parser.add_argument("--needs", default="")
    parser.add_argument("files", nargs="+")
    options = parser.parse_args()
    lacking = [name for name in ["pytest", *options.needs.split(",")]
               if name and importlib.util.find_spec(name) is None]
    if lacking:
        packages = ", ".join("python3-" + name for name in lacking)
        print(f"skipped: {packages}: not installed for {sys.executable}")
        return 77
    import pytest

    build = options.build.resolve()
    sys.path.insert(0, str(build / "python"))
    os.environ.update(TETPROOF_BUILD=str(build), PYTHONPATH=str(build / "python"))
    folder = pathlib.Path(__file__).resolve().parent
    files = [str(folder / name) for name in options.files]
    with tempfile.TemporaryDirectory() as scratch:  # examples write files where they run
        os.chdir(scratch)
        return pytest.main(["-q", "-rs", "-p", "no:cacheprovider", "--rootdir", str(folder), *files])


if __name__ == "__main__":
    sys.exit(main())
