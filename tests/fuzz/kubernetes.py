# SPDX-License-Identifier: GPL-3.0-or-later
"""The manifest of the Kubernetes Job: it follows the schema of what it uses, wrong fields do not, its parts fit together,
and its very command, run once for each index as the cluster would, makes a campaign that merges.

usage: kubernetes.py BUILD     exit code 77: PyYAML or jsonschema is not installed"""
import copy
import json
import os
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"SKIPPED: {missing} (packages python3-yaml, python3-jsonschema)")
    sys.exit(77)

HERE = os.path.dirname(os.path.abspath(__file__))


def change(path, value):
    """A change that sets the value at a path of keys; None removes it."""
    def apply(job):
        for key in path[:-1]:
            job = job[key]
        if value is None:
            del job[path[-1]]
        else:
            job[path[-1]] = value
    return apply


POD = ("spec", "template", "spec")
SHARD = POD + ("containers", 0)
WRONG = {
    "a misspelt field of the Job": change(("spec", "completionmode"), "Indexed"),
    "a misspelt field of a container": change(SHARD + ("volumemounts",), []),
    "a field of the pod in the Job": change(("spec", "restartPolicy"), "OnFailure"),
    "a number as text": change(("spec", "completions"), "8"),
    "no completions": change(("spec", "completions"), None),
    "completions of 0": change(("spec", "completions"), 0),
    "the default mode, which sets no index": change(("spec", "completionMode"), "NonIndexed"),
    "a policy that no Job may have": change(POD + ("restartPolicy",), "Always"),
    "no policy": change(POD + ("restartPolicy",), None),
    "a command that is no list": change(SHARD + ("command",), "tetproof-fuzz"),
    "no image": change(SHARD + ("image",), None),
    "a name with a capital": change(("metadata", "name"), "Tetproof"),
    "memory as a number": change(SHARD + ("resources", "limits", "memory"), 12),
    "memory in words": change(SHARD + ("resources", "limits", "memory"), "12 GB"),
    "a mount at no absolute path": change(SHARD + ("volumeMounts", 0, "mountPath"), "campaign"),
    "another API": change(("apiVersion",), "batch/v1beta1"),
}


def check_schema(job):
    with open(os.path.join(HERE, "kubernetes_job.schema.json")) as file:
        schema = json.load(file)
    jsonschema.Draft202012Validator.check_schema(schema)
    judge = jsonschema.Draft202012Validator(schema)
    for error in judge.iter_errors(job):
        sys.exit(f"FAILED: kubernetes.yaml: {list(error.absolute_path)}: {error.message}")
    for what, apply in WRONG.items():
        wrong = copy.deepcopy(job)
        apply(wrong)
        if judge.is_valid(wrong):
            sys.exit(f"FAILED: the schema accepts {what}")


def check_parts(job):
    """What a schema cannot say."""
    pod = job["spec"]["template"]["spec"]
    shard = pod["containers"][0]
    volumes = {volume["name"] for volume in pod["volumes"]}
    mounts = {mount["mountPath"] for mount in shard["volumeMounts"]}
    assert {mount["name"] for mount in shard["volumeMounts"]} <= volumes, "a mount has no volume"
    command = shard["command"][-1]
    assert int(re.search(r"--shards (\d+)", command)[1]) == job["spec"]["completions"], "--shards is not completions"
    assert re.search(r"--out (\S+)", command)[1] in mounts, "--out is not on the shared volume"
    assert "\n" not in command, "the shell would take a line for a command"


def run(job, build):
    """As the cluster would, but for the number of cases, the mount's place and the mesher."""
    words = job["spec"]["template"]["spec"]["containers"][0]["command"]
    shards = job["spec"]["completions"]
    with tempfile.TemporaryDirectory(prefix="tetproof-kubernetes-") as scratch:
        os.mkdir(f"{scratch}/bin")
        with open(f"{scratch}/bin/my-mesher", "w") as file:   # SURFACE -o MESH
            file.write(f'#!/bin/sh\nexec "{build}/tetproof-faulty-mesher" duplicate "$1" "$3"\n')
        os.chmod(f"{scratch}/bin/my-mesher", 0o755)
        environment = {**os.environ, "PATH": f"{scratch}/bin:{build}:{os.environ['PATH']}"}
        for name in ("GTEST_SHARD_INDEX", "GTEST_TOTAL_SHARDS", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT"):
            environment.pop(name, None)
        command = words[-1]
        for old, new in (("--cases 100000", f"--cases {3 * shards}"), ("--shrink 60", "--shrink 0"), ("/campaign", f"{scratch}/campaign")):
            assert command.count(old) == 1, f"{old} is not in the command once"
            command = command.replace(old, new)
        for index in range(shards):
            done = subprocess.run([*words[:-1], command], env={**environment, "JOB_COMPLETION_INDEX": str(index)},
                                  capture_output=True, text=True, timeout=60)
            if done.returncode != 0:
                sys.exit(f"FAILED: index {index}: exit code {done.returncode}: {done.stderr}")
        merged = subprocess.run([f"{build}/tetproof-fuzz", "--merge", f"{scratch}/campaign", "--json", "-"], env=environment,
                                capture_output=True, text=True, timeout=60)
        report = json.loads(merged.stdout)
        assert report["surfaces"] == 3 * shards and report["missing"] == [], report["summary"]
        assert report["findings"] > 0 and merged.returncode == 1, report["summary"]
        # A failure that is no result is one for Kubernetes, too: a folder that cannot be written.
        bad = subprocess.run([*words[:-1], command.replace(f"{scratch}/campaign", "/dev/null/x")],
                             env={**environment, "JOB_COMPLETION_INDEX": "0"}, capture_output=True, text=True, timeout=60)
        assert bad.returncode == 2, f"exit code {bad.returncode}: {bad.stderr}"
        print(report["summary"])


def main():
    build = os.path.abspath(sys.argv[1])
    with open(os.path.join(HERE, "kubernetes.yaml")) as file:
        job = yaml.safe_load(file)
    check_schema(job)
    check_parts(job)
    run(job, build)
    print(f"{len(WRONG)} wrong manifests are refused")


if __name__ == "__main__":
    main()
