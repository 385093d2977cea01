# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks vector.schema.json and trace.schema.json with another validator: they accept every shipped vector file and every line of
every shipped trace, and refuse what deviates.

usage: check_schemas.py FOLDER    FOLDER: corpus/vectors. Prints each fault, then how much was checked. Exit code 0: no fault; 1: faults;
                                  77: Python's jsonschema is not installed"""
import copy
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

OPTIONAL = {"mended", "kappa", "kappa_min", "kappa_max", "centroid_inside", "triangles", "tolerance", "relative", "absolute"}


def validator(path):
    schema = json.loads(path.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def places(value, at=()):
    """Every place in a value, as a path of keys; of a list only its first entry."""
    yield at
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from places(inner, at + (key,))
    elif isinstance(value, list) and value:
        yield from places(value[0], at + (0,))


def mutants(whole, closed):
    """Broken copies: a key left out, a value of another type, a list that is too short, and, if the objects are closed, a key too many."""
    def changed(at, how):
        broken = copy.deepcopy(whole)
        target = broken
        for key in at[:-1]:
            target = target[key]
        how(target, at[-1])
        return broken

    for at in places(whole):
        value = whole
        for key in at:
            value = value[key]
        if closed and isinstance(value, dict) and at and at[-1] not in ("flags", "applied"):
            yield "a key too many", at, changed(at, lambda t, k: t[k].update({"no such key": 1}))
        if not at:
            continue
        if isinstance(at[-1], str) and at[-1] not in OPTIONAL and at[0] != "flags" and "applied" not in at[:-1]:
            yield "left out", at, changed(at, lambda t, k: t.pop(k))
        other = {"a": [1]} if isinstance(value, (str, list)) else "a text"
        yield "of another type", at, changed(at, lambda t, k: t.__setitem__(k, other))
        if isinstance(value, list) and len(value) in (3, 6, 8) and all(isinstance(x, (int, float, str)) for x in value) and at[-1] in (
                "point", "from", "to", "face", "cells", "vertex", "cell", 0) and at[-2:-1] != ("pieces",):
            yield "one entry short", at, changed(at, lambda t, k: t[k].pop())


def main(folder):
    faults, files, lines, broken = [], 0, 0, 0
    vectors, traces = validator(folder / "vector.schema.json"), validator(folder / "trace.schema.json")
    for path in sorted(folder.glob("*.json")):
        if path.name.endswith(".schema.json"):
            continue
        content = json.loads(path.read_text(encoding="utf-8"))
        files += 1
        faults += [f"{path.name}: {error.json_path}: {error.message[:200]}" for error in vectors.iter_errors(content)]
        shapes = {}  # one case of each shape is broken, in all ways
        for case in content["cases"]:
            shapes.setdefault(json.dumps([sorted(case["input"]), [type(x).__name__ for x in case["expected"].values()]]), case)
        for case in shapes.values():
            for how, at, mutant in mutants({**content, "cases": [case]}, True):
                broken += 1
                if vectors.is_valid(mutant):
                    faults.append(f"{path.name}: accepted: {'/'.join(map(str, at))} {how}")
    seen = {}
    for path in sorted((folder / "traces").glob("*.jsonl")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            record = json.loads(line)
            lines += 1
            faults += [f"{path.name}:{number}: {error.json_path}: {error.message[:200]}" for error in traces.iter_errors(record)]
            seen.setdefault((record["record"], "kappa" in record or "kappa_min" in record), record)
    for (kind, _), record in seen.items():
        for how, at, mutant in mutants(record, False):
            if at == ("record",) or (kind == "settings" and how == "left out"):
                continue
            broken += 1
            if traces.is_valid(mutant):
                faults.append(f"{kind}: accepted: {'/'.join(map(str, at))} {how}")
    for fault in faults:
        print(fault)
    print(f"{files} files of vectors, {lines} lines of traces, {broken} broken ones")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
