# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fuzz campaign costs beside its mesher, in CPU time: surfaces, cases of a mesher that does nothing, verdicts; and
the seconds a case of real meshers, from which the cost of a million cases follows; and how long the shrinker takes."""
import glob
import json
import os
import shutil
import statistics
import sys

from measure import Command

SURFACES = 500
CASES = 100
PRESETS = ["tetgen,pq", "gmsh,delaunay", "hxt"]
A_MILLION = 10**6
# Findings on surfaces of more than 120 triangles, with the meshers of Debian 12, each of another kind.
LARGE = [("tetgen,pY", "101:103"), ("tetgen,pY", "101:6"), ("tetgen,pY", "101:164"), ("tetgen,pY", "101:47"), ("tetgen,pq", "102:249"),
         ("tetgen,p", "105:28"), ("gmsh,delaunay", "201:57"), ("gmsh,delaunay", "201:269"), ("gmsh,raw", "203:337"), ("hxt,1-raw", "304:146")]
SMALL, PATIENCE = 60, 120  # triangles, seconds


def fuzz(bench):
    print("  the parts alone", file=sys.stderr)
    parts = parts_alone(bench)
    print(f"### A fuzz campaign, CPU time\n\n| | each, ms | a second, on one core |\n|---|---|---|")
    for what, seconds in parts.items():
        print(f"| {what} | {1e3 * seconds:.2f} | {1 / seconds:,.0f} |")
    print(f"\n### A case of tetproof-fuzz: the first {CASES} of seed 1\n\n"
          "| mesher | mesher, CPU s | verdict, s | the rest, CPU s | sound | a million cases, CPU hours |\n|---|---|---|---|---|---|")
    campaigns = [("a copy of the surface (`cp`)", ["--name", "cp", "--", "cp", "{surface}", "{mesh}"])]
    campaigns += [(preset, ["--mesher", preset]) for preset in PRESETS]
    for name, words in campaigns:
        row = campaign(bench, name, words)
        if row:
            print(f"| {name} | {row['mesher']:.4f} | {row['verdict']:.4f} | {row['rest']:.4f} | {row['sound']} | {row['whole'] * A_MILLION / 3600:,.0f} |", flush=True)
    print()
    shrinking(bench)


def shrinking(bench):
    """Runs of the mesher and seconds until a finding has few triangles."""
    print(f"### Shrinking to {SMALL} triangles, at most {PATIENCE} s\n\n"
          "| mesher | finding | triangles | left | runs of the mesher | wall s |\n|---|---|---|---|---|---|")
    for mesher, case in LARGE:
        command = bench.command(f"shrink {mesher} {case}", bench.ours("tests/bench/shrink_rates"), SMALL, PATIENCE, bench.path("shrink-rates"), mesher, case)
        print(f"  shrinking {mesher} {case}", file=sys.stderr)
        command.run(bench.cores)
        with open(command.log) as file:
            row = json.loads(file.readline())
        bench.record.setdefault("shrinking", []).append(row)
        print(f"| {mesher} | {row['outcome']}: {row['signature']} | {row['triangles']} | {row['left']}{'' if row['reached'] else ', not reached'} "
              f"| {row['calls']} | {row['seconds']:.1f} |", flush=True)
    print()


def parts_alone(bench):
    """Seconds for each of the parts, the median of the runs."""
    folder, runs = bench.path("fuzz-rates"), []
    command = bench.command("fuzz_rates", bench.ours("tests/bench/fuzz_rates"), SURFACES, folder)
    for _ in range(bench.runs):
        shutil.rmtree(folder, ignore_errors=True)
        command.run(bench.cores)
        with open(command.log) as file:
            runs.append(json.load(file))
    bench.record.setdefault("fuzz", {})["parts"] = runs

    def each(seconds, count):
        return statistics.median(run[seconds] / run[count] for run in runs)
    return {"a surface, made and certified (as the generator does)": each("making_s", "surfaces"),
            "a surface, judged": each("judging_s", "surfaces"),
            "a case with an empty C++ mesher, all but mesher and verdict, journal included": each("empty_cases_s", "surfaces"),
            f"a verdict on {runs[0]['tets']:,} sound tetrahedra, both passes": each("verdicts_s", "verdicts")}


def campaign(bench, name, words):
    """Seconds a case: of the mesher by its own processes, of verdicts (wall, as the journal has it), and what is left of all
    CPU time. None if the mesher is not installed."""
    folder = bench.path("fuzz-campaign")
    shutil.rmtree(folder, ignore_errors=True)
    command = Command(f"fuzz {name}", [bench.ours("tetproof-fuzz"), "--cases", CASES, "--threads", 1, "--quiet", "--out", folder, *words],
                      bench.out, accept=(0, 1, 2, 4))
    print(f"  {name}", file=sys.stderr)
    command.run(bench.cores)
    cases = []
    for path in glob.glob(f"{folder}/journal-*.jsonl"):
        with open(path) as file:
            cases += [line for line in map(json.loads, file) if "case" in line and "outcome" in line]
    if not cases:
        with open(command.log) as file:
            print(f"| {name}: {file.readline().strip()} | | | | | |")
        return None
    whole = command.cpu / len(cases)
    mesher = sum(case["cpu_s"] for case in cases) / len(cases)
    verdict = sum(case["judge_s"] for case in cases) / len(cases)
    row = {"cases": len(cases), "whole": whole, "mesher": mesher, "verdict": verdict, "rest": whole - mesher - verdict,
           "sound": f"{sum(case['outcome'] == 'sound' for case in cases)} of {len(cases)}"}
    bench.record.setdefault("fuzz", {})[name] = row
    return row
