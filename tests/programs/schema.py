# SPDX-License-Identifier: GPL-3.0-or-later
"""Validates reports against a JSON schema (draft 2020-12), for verify_schema_test.cpp.

usage: schema.py validate SCHEMA REPORT...    prints each violation; exit code 1 if there is one
       schema.py mutilate SCHEMA REPORT       breaks the report in every place, one at a time; prints the broken reports that the
                                              schema accepts, then the number of broken reports
"""
import copy
import json
import sys

import jsonschema


def validator(path):
    with open(path) as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def load(path):
    with open(path) as file:
        return json.load(file, parse_constant=lambda word: sys.exit(f"{path}: {word} is no JSON"))


def validate(schema, reports):
    judge, violated = validator(schema), False
    for path in reports:
        for error in judge.iter_errors(load(path)):
            violated = True
            print(f"{path}: {error.json_path}: {error.message[:200]}")
    return 1 if violated else 0


def places(value, at=()):
    """Every place in the report, as a path of keys. Of a list, only the first entry and the one with the longest text."""
    yield at
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from places(inner, at + (key,))
    elif isinstance(value, list) and value:
        for i in sorted({0, max(range(len(value)), key=lambda i: len(json.dumps(value[i])))}):
            yield from places(value[i], at + (i,))


def mutants(report):
    """Broken reports: a missing key, an additional key, a value of another type, a negative number."""
    def inner(whole, at):
        for key in at:
            whole = whole[key]
        return whole

    for at in places(report):
        value = inner(report, at)
        if isinstance(value, dict):
            broken = copy.deepcopy(report)
            inner(broken, at)["no such key"] = 1
            yield "a key too many", at, broken
        if not at:
            continue
        wrong = [[True], {"a": 1}] if isinstance(value, str) else ["a text", [[True]], {"a": 1}]
        if isinstance(value, bool):
            wrong.append(1)
        elif isinstance(value, int):
            wrong += [1.5, True]
        for other in wrong:
            broken = copy.deepcopy(report)
            inner(broken, at[:-1])[at[-1]] = other
            yield f"{other!r} for it", at, broken
        if isinstance(at[-1], str):
            broken = copy.deepcopy(report)
            del inner(broken, at[:-1])[at[-1]]
            yield "left out", at, broken
        if at[-1] in ("id", "verdict", "check"):
            broken = copy.deepcopy(report)
            inner(broken, at[:-1])[at[-1]] = "no-such"
            yield "an unknown word", at, broken
        if at[-1] in ("count", "tets", "points", "boundary_faces", "triangles") and isinstance(value, int):
            broken = copy.deepcopy(report)
            inner(broken, at[:-1])[at[-1]] = -1
            yield "below zero", at, broken
        if at[-1] in ("point", "point_exact", "faces") and value:
            broken = copy.deepcopy(report)
            target = inner(broken, at)
            (target[0] if at[-1] == "faces" else target).pop()
            yield "one number short", at, broken
        if at[-1] == "point_exact" and value:
            for text in ("0.5", "1/0", "1", "", "1/2 "):
                broken = copy.deepcopy(report)
                inner(broken, at)[0] = text
                yield f"{text!r} as a rational", at, broken
    for other in {"sound", "defective", "incomplete"} - {report["verdict"]}:
        yield "another verdict", ("verdict",), {**report, "verdict": other}
    for i, check in enumerate(report["checks"]):
        if check["findings"]:
            broken = copy.deepcopy(report)
            broken["checks"][i]["verdict"] = "pass"
            yield "passed with findings", ("checks", i), broken


def mutilate(schema, path):
    judge, report, broken = validator(schema), load(path), 0
    for how, at, mutant in mutants(report):
        broken += 1
        if judge.is_valid(mutant):
            print(f"{'/'.join(map(str, at))}: {how}")
    print(broken)
    return 0


if __name__ == "__main__":
    what, schema, *reports = sys.argv[1:]
    sys.exit(validate(schema, reports) if what == "validate" else mutilate(schema, *reports))
