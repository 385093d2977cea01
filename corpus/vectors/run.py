#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the conformance vectors against an implementation of the paper's tables and equations.

usage: run.py                            checks the files themselves, in rational arithmetic
       run.py [OPTION...] -- COMMAND...  sends every case to COMMAND and compares its answers
       run.py [OPTION...] --list         lists the cases and their flags

COMMAND reads JSON objects from its standard input, one a line: {"id": ..., "kind": ..., "input": ...}. It writes answers to its
standard output, one a line, in any order: {"id": ..., "result": ...}, or {"id": ..., "skipped": "why"} for a case that it cannot
answer. README.md describes the input and the result of each kind. Exit code: 0 all answers are right, 1 some are wrong, 2 bad usage
or files that cannot be read."""
import argparse
import json
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True
import checks  # noqa: E402
import compare  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent


class Unusable(Exception):
    """Bad usage or bad files: one line for the user."""


def read_files(folder, kinds):
    """The vector files, by kind."""
    files = {}
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        if path.name.endswith(".schema.json"):
            continue
        try:
            content = json.loads(path.read_text())
        except (OSError, ValueError) as error:
            raise Unusable(f"{path}: {error}") from None
        if content.get("format") != "tetproof-vectors 1":
            raise Unusable(f'{path}: expected "format": "tetproof-vectors 1", found {content.get("format")!r}')
        files[content["kind"]] = content
    for kind in kinds or []:
        if kind not in files:
            raise Unusable(f"--kind: expected one of {', '.join(files)}, found {kind}")
    if not files:
        raise Unusable(f"{folder}: no vectors there")
    return {kind: content for kind, content in files.items() if not kinds or kind in kinds}


def select(files, arguments):
    """The selected cases, as (kind, content of the file, case)."""
    known = {flag for content in files.values() for flag in content["flags"]}
    for flag in (arguments.flag or []) + (arguments.skip_flag or []):
        if flag not in known:
            raise Unusable(f"no case has the flag {flag}; there are {', '.join(sorted(known))}")
    chosen = [(kind, content, case) for kind, content in files.items() for case in content["cases"]
              if (not arguments.id or case["id"] in arguments.id)
              and (not arguments.flag or set(arguments.flag) & set(case["flags"]))
              and not set(arguments.skip_flag or []) & set(case["flags"])]
    if not chosen:
        raise Unusable("no case is left to run")
    return chosen


def ask(command, cases, timeout):
    """Runs the command on the cases. Returns the answers by id, and a list of what went wrong."""
    lines = "".join(json.dumps({"id": case["id"], "kind": kind, "input": case["input"]}) + "\n" for kind, _, case in cases)
    troubles = []
    try:
        with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, errors="replace") as run:
            try:
                out, _ = run.communicate(lines, timeout)
            except subprocess.TimeoutExpired:
                run.kill()
                out, _ = run.communicate()
                troubles.append(f"ended after {timeout:g} seconds (--timeout)")
            else:
                if run.returncode:
                    how = f"exit code {run.returncode}" if run.returncode > 0 else f"signal {-run.returncode}"
                    troubles.append(f"the command ended with {how}")
    except OSError as error:
        raise Unusable(f"{command[0]}: {error.strerror}") from None
    answers, asked = {}, {case["id"] for _, _, case in cases}
    for number, line in enumerate(out.splitlines(), 1):
        if not line.strip():
            continue
        try:
            answer = json.loads(line)
            where = answer["id"]
            if not isinstance(answer, dict) or ("result" in answer) == ("skipped" in answer):
                raise KeyError
        except (ValueError, KeyError, TypeError):
            troubles.append(f'line {number} of the answers is no {{"id": ..., "result": ...}}: {line[:120]}')
            continue
        if not isinstance(where, str) or where not in asked:
            troubles.append(f"line {number} of the answers: nobody asked for {where}")
        elif where in answers:
            troubles.append(f"line {number} of the answers: {where} is answered a second time")
        else:
            answers[where] = answer
    return answers, troubles


def short(value, most=600):
    text = json.dumps(value)
    return text if len(text) <= most else text[:most] + f"... ({len(text)} characters)"


def judge(command, cases, arguments):
    answers, troubles = ask(command, cases, arguments.timeout)
    counts = {kind: {"passed": 0, "failed": 0, "skipped": 0} for kind, _, _ in cases}
    failed = []
    for kind, content, case in cases:
        answer = answers.get(case["id"])
        if answer is None:
            fault = "no answer"
        elif "skipped" in answer:
            counts[kind]["skipped"] += 1
            continue
        else:
            fault = compare.difference(kind, case, answer["result"], content["optional"])
        counts[kind]["failed" if fault else "passed"] += 1
        if fault:
            failed.append((kind, content, case, answer, fault))
    for kind, content, case, answer, fault in failed[:arguments.show]:
        print(f"FAIL {case['id']}: {fault}\n  {case['comment']}")
        for flag in case["flags"]:
            print(f"  {flag}: {content['flags'][flag]}")
        print(f"  input     {short(case['input'])}\n  expected  {short(case['expected'])}")
        if answer:
            print(f"  found     {short(answer['result'])}")
    if len(failed) > arguments.show:
        print(f"and {len(failed) - arguments.show} more: " + " ".join(case["id"] for _, _, case, _, _ in failed[arguments.show:]))
    for trouble in troubles:
        print(f"FAIL {trouble}")
    for kind, n in counts.items():
        print(f"{kind:>16}: " + ", ".join(f"{n[what]} {what}" for what in n if n[what] or what == "passed"))
    if not any(n["passed"] for n in counts.values()):
        print("no case passed")
        return 1
    return 1 if failed or troubles else 0


def main(words):
    command = None
    if "--" in words:
        command = words[words.index("--") + 1:]
        words = words[:words.index("--")]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter, usage=argparse.SUPPRESS)
    parser.add_argument("--kind", action="append", help="run only this kind (the name of a file without .json); can be repeated")
    parser.add_argument("--id", action="append", help="run only this case; can be repeated")
    parser.add_argument("--flag", action="append", help="run only cases with this flag; can be repeated")
    parser.add_argument("--skip-flag", action="append", help="run no cases with this flag; can be repeated")
    parser.add_argument("--show", type=int, default=10, help="the number of failures to show in full (10)")
    parser.add_argument("--timeout", type=float, default=600, help="the seconds that COMMAND may take (600)")
    parser.add_argument("--list", action="store_true", help="print the cases and run nothing")
    parser.add_argument("--folder", default=HERE, help="the folder of the vectors (that of this script)")
    arguments = parser.parse_args(words)
    files = read_files(arguments.folder, arguments.kind)
    if command is None and not arguments.list:
        faults = [fault for kind, content in files.items() for fault in checks.faults(kind, content)]
        for fault in faults:
            print(f"FAIL {fault}")
        for kind, content in files.items():
            print(f"{kind:>16}: {len(content['cases'])} cases, {len(content['flags'])} flags")
        return 1 if faults else 0
    cases = select(files, arguments)
    if arguments.list:
        for kind, _, case in cases:
            print(case["id"], ",".join(case["flags"]) or "-", case["comment"], sep="\t")
        return 0
    if not command:
        raise Unusable("expected a command after --")
    return judge(command, cases, arguments)


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Unusable as unusable:
        print(f"run.py: {unusable}", file=sys.stderr)
        sys.exit(2)
