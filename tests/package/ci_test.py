#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The example of a CI job for a mesher's repository (ci/mesher.yml): its form, and its commands.

The step that meshes and judges is run as GitHub runs it, with the programs of this build and a stand-in for the mesher:
on three surfaces all is sound; with one mesh spoilt, and with a mesher that fails on one surface, the job fails, and all
reports are there. What needs the network or the mesher's sources (the steps that install and build) is only parsed."""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish  # noqa: E402

try:
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

HERE = pathlib.Path(__file__).resolve().parent
SURFACES = {"ball": "sphere:r=1,n=2000", "ring": "torus:R=1,r=0.4,n=2000", "box": "box:x0=0,x1=2,y0=0,y1=1,z0=0,z1=1"}
MESHER = """#!/bin/bash
# usage: my-mesher SURFACE -o MESH
tetproof-mesh "$1" -o "$3" --cells 12 --points 0 --quiet >/dev/null || exit
[ "$FAILS" != "$(basename "$1")" ] || exit 3
[ "$SPOILS" != "$(basename "$1")" ] || sed -i 's/^100 \\([0-9]*\\) \\([0-9]*\\) /100 \\2 \\1 /' "$3"
"""


def check_form(workflow):
    # YAML 1.1 takes the key `on` for true.
    check(set(workflow) == {"name", True, "env", "jobs"}, f"keys of the workflow: {set(workflow)}")
    for job in workflow["jobs"].values():
        check({"runs-on", "steps"} <= set(job) <= {"runs-on", "container", "defaults", "steps"}, f"keys of the job: {set(job)}")
        for step in job["steps"]:
            check(("run" in step) != ("uses" in step), f"a step runs commands or uses an action: {step}")
            check(set(step) <= {"name", "run", "uses", "if", "with"}, f"keys of the step: {set(step)}")
            check("uses" not in step or "@v" in step["uses"], f"an action has its version: {step}")
            check("run" not in step or subprocess.run(["bash", "-n"], input=step["run"], text=True).returncode == 0,
                  f"bash reads it: {step}")


def run_job(script, folder, build, fidelity, **faults):
    """As GitHub runs a step with `shell: bash`."""
    environment = {"PATH": f"{build}:{os.environ['PATH']}", "SURFACES": "tests/surfaces/*.stl", "FIDELITY": fidelity,
                   "FAILS": "", "SPOILS": "", **faults}
    (folder / "step.sh").write_text(script)
    for report in (folder / "reports").glob("*"):
        report.unlink()
    return subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "step.sh"], cwd=folder, env=environment,
                          capture_output=True, text=True, timeout=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    workflow = yaml.safe_load((HERE / "ci" / "mesher.yml").read_text())
    check_form(workflow)
    steps = {step.get("name"): step.get("run", "") for step in workflow["jobs"]["judge"]["steps"]}
    script = steps["Mesh the surfaces and judge the meshes"]
    options = subprocess.run([build / "tetproof-verify", "--help"], capture_output=True, text=True).stdout
    html = "--html" in options
    if not html:
        print("tetproof-verify has no --html: left out")
        script = script.replace(' --html "reports/$name.html"', "")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        (folder / "tests" / "surfaces").mkdir(parents=True)
        (folder / "build").mkdir()
        (folder / "build" / "my-mesher").write_text(MESHER)
        (folder / "build" / "my-mesher").chmod(0o755)
        for name, surface in SURFACES.items():
            subprocess.run([build / "tetproof-mesh", surface, "--quiet", "--save-surface",
                            folder / "tests" / "surfaces" / f"{name}.stl"], check=True, capture_output=True)
        expected = {f"{name}.{ending}" for name in SURFACES for ending in ["msh", "xml"] + ["html"] * html}

        def reports():
            return {path.name for path in (folder / "reports").iterdir()}

        def failed_cases(name):
            suite = xml.etree.ElementTree.parse(folder / "reports" / f"{name}.xml").getroot()
            return [case.get("name") for case in suite.iter("testcase") if case.find("failure") is not None]

        sound = run_job(script, folder, build, "0.1")
        check(sound.returncode == 0 and sound.stdout.count(": sound") == 3, f"three sound meshes: {sound}")
        check(reports() == expected, f"the reports: {reports()}")
        spoilt = run_job(script, folder, build, "0.1", SPOILS="ring.stl")
        check(spoilt.returncode == 1 and spoilt.stdout.count(": sound") == 2, f"one is spoilt: {spoilt}")
        check(reports() == expected, f"the reports are all there: {reports()}")
        check("inverted" in failed_cases("ring") and not failed_cases("ball"), f"the reports name it: {failed_cases('ring')}")
        none = run_job(script, folder, build, "0.1", FAILS="box.stl")
        check(none.returncode == 1 and "::error::tests/surfaces/box.stl: no mesh" in none.stdout, f"no mesh: {none}")
        check({"ball.xml", "ring.xml"} <= reports() and "box.xml" not in reports(), f"the others are judged: {reports()}")
        coarse = run_job(script, folder, build, "1e-9")
        check(coarse.returncode == 1, "FIDELITY reaches the judge")
    finish("; the steps that install and build were parsed, not run")


if __name__ == "__main__":
    main()
