#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs corpus/findings/check.py over every finding: none may be refuted, and only crashes and refusals, which a run of
the mesher alone shows, may be left unchecked."""
import json
import pathlib
import subprocess
import sys

FINDINGS = pathlib.Path(__file__).resolve().parents[2] / "corpus" / "findings"
ONLY_A_RUN_SHOWS = {"crashed", "refused-valid", "no-output", "unreadable"}


def main():
    folders = sorted(p.parent for p in FINDINGS.glob("*/finding.json"))
    wrong = [] if folders else ["there are no findings"]
    for folder in folders:
        outcome = json.loads((folder / "finding.json").read_text())["outcome"]
        done = subprocess.run([sys.executable, FINDINGS / "check.py", folder], capture_output=True, text=True)
        if done.returncode != (4 if outcome in ONLY_A_RUN_SHOWS else 0):
            wrong.append(f"{folder.name}: check.py exits {done.returncode}:\n{done.stdout}{done.stderr}")
        if "confirmed    surface.off is closed" not in done.stdout:
            wrong.append(f"{folder.name}: the surface is not confirmed")
    print("\n".join(wrong) if wrong else f"{len(folders)} findings confirmed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
