# SPDX-License-Identifier: GPL-3.0-or-later
"""The fuzz driver against a mesher with planted bugs (faults.cpp): every bug is found, classed, grouped and shrunk, and
the mesher without a bug has no finding. Prints a table.

usage: planted_bugs.py BUILD [--full] [--only BUG,...] [--patient]
  Without --full each bug gets a few dozen cases, about a minute in all; with it 2,000 cases, half an hour.
  --patient   shrinks for 20 s, as --full does: for programs that sanitizers make slow"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field

FULL_CASES = 2000


@dataclass
class Bug:
    """What the driver must find."""
    outcome: str                 # the class of the bug's first group or, where it is no finding, of its cases
    signatures: str              # the groups that may occur, a regular expression for OUTCOME:SIGNATURE
    triangles: int = 0           # the largest surface that the smallest group may be shrunk to; 0: nothing to shrink
    cases: int = 30              # without --full
    quickly: int = 0             # `triangles` without --full, where the few seconds of shrinking do not suffice
    options: list = field(default_factory=list)
    most_cases: int = FULL_CASES  # with --full: where a case takes seconds


# What becomes of vertices that are merged depends on which they are.
MERGED = ("wrong-answer:(duplicate-tet|inverted|overlap|flat|non-conforming.*)|no-tetrahedra:no tetrahedra|"
          "wrong-against-surface:(missing-region|excess-region|topology|volume-surface|boundary-nonmanifold-(vertex|edge)|"
          "off-surface-vertex|surface-to-mesh|mesh-to-surface)")
BUGS = {
    "drop": Bug("wrong-against-surface", "wrong-against-surface:(missing-region|off-surface-vertex|topology|volume-surface|mesh-to-surface)", 8),
    "invert": Bug("wrong-answer", "wrong-answer:inverted", 60, 300, 400),
    "flat": Bug("wrong-answer", "wrong-answer:flat", 8),
    "duplicate": Bug("wrong-answer", "wrong-answer:duplicate-tet", 8),
    "merge": Bug("wrong-answer", MERGED, 20),
    "move": Bug("wrong-against-surface", "wrong-against-surface:(off-surface-vertex|excess-region|missing-region|surface-to-mesh|mesh-to-surface|volume-surface)", 8),
    "crack": Bug("wrong-answer", "wrong-answer:.*", 20, 15, 100, ["--repeat", "10"], 200),
    "nan": Bug("wrong-answer", "wrong-answer:finite-coordinates", 8),
    "shift": Bug("wrong-answer", "wrong-answer:.*", 8),
    "cavity": Bug("wrong-against-surface", "wrong-answer:overlap|wrong-against-surface:(excess-region|topology)", 16, 70),
    "empty": Bug("no-tetrahedra", "no-tetrahedra:no tetrahedra", 8),
    "nothing": Bug("no-output", "no-output:no file", 8),
    "truncate": Bug("unreadable", r"unreadable:mesh\.msh.*", 20),
    "hang": Bug("slow", "", cases=20, options=["--cpu", "0.3"]),
    "assert": Bug("crashed", r"crashed:assert_on_a_sphere: Assertion `!cospherical .*' failed at faults\.cpp:\d+", 8),
    "segv": Bug("crashed", "crashed:SIGSEGV in recover_segment.*", 40, 16, 120, [], 200),
    "throw": Bug("crashed", "crashed:uncaught std::out_of_range: facet # of #", 70, 12, 0, [], 200),
    "abort": Bug("crashed", "crashed:heap corruption", 20, 3, 60, [], 200),
    "leak": Bug("out-of-memory", "", cases=6, options=["--memory", "200"], most_cases=200),
    "refuse": Bug("refused-valid", r"refused-valid:Error: two facets intersect: .* \(facets # and #\)", 60),
    "give-up": Bug("refused", ""),
    "grandchild": Bug("slow", "", cases=4, options=["--wall", "1"], most_cases=100),
    "talk": Bug("sound", "", cases=1, most_cases=20),
}


def campaign(build, bug, cases, options, folder):
    command = [f"{build}/tetproof-fuzz", "--quiet", "--cases", str(cases), *options, "--out", folder,
               "--", f"{build}/tetproof-faulty-mesher", bug, "{surface}", "{mesh}"]
    done = subprocess.run(command, capture_output=True, text=True)
    with open(f"{folder}/report.json") as file:
        return done.returncode, json.load(file)


class Check:
    """What is wrong with one bug's report."""

    def __init__(self, bug, expected, most_triangles, code, report):
        self.wrong = []
        self.row = report["by_mesher"]["tetproof-faulty-mesher"]
        groups = report["groups"]
        for group in groups:
            if not re.fullmatch(expected.signatures, f"{group['outcome']}:{group['signature']}"):
                self.wrong.append(f"an unexpected group: {group['id']}")
        self.first, self.triangles = "", ""
        right = [group for group in groups if group["outcome"] == expected.outcome]
        if expected.signatures:
            self.expect(code == 1, f"exit code {code}")
            self.expect(right, f"no group is {expected.outcome}")
        else:
            self.expect(self.row[expected.outcome] > 0, f"no case is {expected.outcome}")
            self.expect(code == (4 if expected.outcome in ("slow", "out-of-memory") else 0), f"exit code {code}")
            found = [c["case"] for c in report["not_sound"] if c["outcome"] == expected.outcome]
            # The mesher's own refusals are no bug.
            if bug == "give-up":
                found = [c["case"] for c in report["not_sound"] if "facets are not supported" in c["what"]]
                self.expect(found, "the refusals do not say why")
            self.first = min(found) + 1 if found else ""
        if right:
            self.first = min(c["case"] for group in right for c in group["cases"]) + 1
            shrunk = [group["shrunk"]["triangles"] for group in right if group["shrunk"]["failed"] > 0]
            self.expect(shrunk, "no shrunk surface still fails")
            self.triangles = min(shrunk, default=0)
            self.expect(self.triangles <= most_triangles, f"shrunk to {self.triangles} triangles, not {most_triangles}")
        self.groups = len(groups)

    def expect(self, holds, what):
        if not holds:
            self.wrong.append(what)


def check_sound(build, cases, scratch):
    """The mesher without a bug."""
    code, report = campaign(build, "none", cases, [], f"{scratch}/none")
    row = report["by_mesher"]["tetproof-faulty-mesher"]
    print(f"| none | no finding | {report['summary']} | | | |")
    return code == 0 and report["findings"] == 0 and row["sound"] > cases / 2 and row["sound"] + row["refused"] == cases


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--patient", action="store_true")
    arguments = parser.parse_args()
    build = os.path.abspath(arguments.build)
    chosen = arguments.only.split(",") if arguments.only else ["none", *BUGS]
    failures = []
    listed = re.findall(r"^  (\S+): ", subprocess.run([f"{build}/tetproof-faulty-mesher"], capture_output=True, text=True).stderr, re.M)
    if sorted(listed) != sorted(["none", *BUGS]):
        sys.exit(f"FAILED: this script and the mesher have different bugs: {sorted(set(listed) ^ {'none', *BUGS})}")
    print("| bug | class | groups | found by case | shrunk to triangles | wall s |\n|---|---|---|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory(prefix="tetproof-planted-") as scratch:
        for bug in chosen:
            start = time.monotonic()
            if bug == "none":
                if not check_sound(build, 500 if arguments.full else 60, scratch):
                    failures.append("none: findings, or too few sound meshes")
                continue
            expected = BUGS[bug]
            cases = min(FULL_CASES, expected.most_cases) if arguments.full else expected.cases
            shrink = ["--shrink", "20" if arguments.full or arguments.patient else "4"] if expected.triangles else []
            most_triangles = expected.triangles if arguments.full else expected.quickly or expected.triangles
            check = Check(bug, expected, most_triangles, *campaign(build, bug, cases, [*expected.options, *shrink], f"{scratch}/{bug}"))
            failures += [f"{bug}: {what}" for what in check.wrong]
            print(f"| {bug} | {expected.outcome} {check.row[expected.outcome]} of {cases} | {check.groups} | {check.first} | "
                  f"{check.triangles} | {time.monotonic() - start:.0f} |", flush=True)
    for failure in failures:
        print(f"FAILED: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
