# SPDX-License-Identifier: GPL-3.0-or-later
"""For tests that are programs and go on after a failure: what does not hold is printed and counted."""
import subprocess
import sys

failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("FAIL", what)


def run(*command, **options):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=200, **options)


def finish(more=""):
    """Ends the program: exit code 1 if anything failed."""
    print(f"{len(failures)} failures{more}")
    sys.exit(1 if failures else 0)
