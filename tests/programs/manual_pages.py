#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Manual pages and completion of every program, as man, mandoc, bash and fish take them.

Both are compared with --help: the same options, no more and no fewer. What completion offers for an option must be what
the program accepts. Tools that are not installed are named; bash is needed."""
import argparse
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, run  # noqa: E402

PROGRAMS = ["tetproof-mesh", "tetproof-verify", "tetproof-compare", "tetproof-convert", "tetproof-fuzz"]
FORMATS = "msh41 msh40 msh22 tetgen poly smesh vtu vtk medit stl off obj ply".split()
# The words before the cursor; what must be offered, exactly.
COMPLETIONS = [
    ("tetproof-verify", ["--region", ""], ["inside", "none", "outside"]),
    ("tetproof-verify", ["--region", "=", "o"], ["outside"]),
    ("tetproof-verify", ["--region", "="], ["inside", "none", "outside"]),
    ("tetproof-verify", ["--str"], ["--strict-topology"]),
    ("tetproof-verify", ["--skip", "flat,inv"], ["flat,inverted"]),
    ("tetproof-verify", ["--allow", ""], ["crack", "non-conforming-interface"]),
    ("tetproof-verify", ["--voxels", ""], []),
    ("tetproof-verify", ["--json", ""], ["a b.msh", "dir", "grid.msh"]),
    ("tetproof-verify", ["gr"], ["grid.msh"]),
    ("tetproof-verify", ["grid.msh", ""], ["a b.msh", "dir", "grid.msh"]),
    ("tetproof-convert", ["--to", ""], sorted(FORMATS)),
    ("tetproof-convert", ["a", "--from", "=", "msh4"], ["msh40", "msh41"]),
    ("tetproof-mesh", ["--points", ""], ["0", "auto"]),
    ("tetproof-mesh", ["--improve", "s"], ["solid-angle"]),
    ("tetproof-mesh", ["-o", "g"], ["grid.msh"]),
    ("tetproof-compare", ["a"], ["a b.msh"]),
    ("tetproof-fuzz", ["--out", ""], ["dir"]),
    ("tetproof-fuzz", ["--formats", "msh41,o"], ["msh41,obj", "msh41,off"]),
    ("tetproof-fuzz", [""], []),
    ("tetproof-fuzz", ["--", "bas"], None),  # commands: bash is one
    ("tetproof-fuzz", ["--", "bash", "gr"], ["grid.msh"]),
]
BASH = r"""
source "$1"; shift
function=$1; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
"$function" "${COMP_WORDS[0]}" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
for reply in "${COMPREPLY[@]}"; do printf '%s\n' "$reply"; done
"""


def options_of_help(text):
    """-q, --quiet, ...: each line of an option begins with two blanks and a dash; examples come first."""
    names = []
    for line in text[text.index("\nOptions:"):].splitlines():
        if re.match(r"  -", line):
            names += re.sub(r"\{.*", "", line.split()[0]).split(",")
    return sorted(names)


def options_of_page(page):
    entries = re.findall(r"^\.TP\n(.*)$", page, re.M)
    return sorted(name.replace("\\-", "-") for entry in entries for name in re.findall(r"\\fB(\\-[^ ]*?)\\fR", entry))


def check_page(name, page, path):
    path.write_text(page)
    readers = {"man": ["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", path],
               "mandoc": ["mandoc", "-T", "lint", "-W", "warning", path]}
    for tool, command in readers.items():
        if not shutil.which(tool):
            continue
        said = run(*command, env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
        complaints = said.stderr + (said.stdout if tool == "mandoc" else "")
        # The pages have no date on purpose: the same source gives the same bytes.
        complaints = [line for line in complaints.splitlines() if "missing date" not in line]
        check(not complaints, f"{name}: {tool} complains: {complaints}")


def check_accepted(program, option, words, files):
    """The program complains of the file, which is empty, and not of the word."""
    for word in words:
        said = run(program, option, word, "grid.msh", "sphere", cwd=files)
        check("grid.msh" in said.stderr and option not in said.stderr, f"{program.name} {option} {word}: {said.stderr}")
    said = run(program, option, "nonsense", "grid.msh", "sphere", cwd=files)
    check("nonsense" in said.stderr, f"{program.name} {option} nonsense is accepted: {said.stderr}")


def completed(script, name, words, folder):
    function = "_" + name.replace("-", "_")
    said = run("bash", "--norc", "--noprofile", "-c", BASH, "bash", script, function, name, *words, cwd=folder)
    check(not said.stderr, f"{name} {words}: bash says {said.stderr}")
    return sorted(said.stdout.splitlines())


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    if not shutil.which("bash"):
        print("skipped: bash is not installed")
        sys.exit(77)
    for tool in ("man", "mandoc", "zsh", "fish"):
        if not shutil.which(tool):
            print(f"not checked with {tool}, which is not installed")
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        files, scripts = folder / "files", {}
        (files / "dir").mkdir(parents=True)
        for name in ("a b.msh", "grid.msh"):
            (files / name).write_text("")
        for name in PROGRAMS:
            program = build / name
            wanted = options_of_help(run(program, "--help").stdout)
            check(len(wanted) > 8, f"{name}: --help has options")
            page = run(program, "--help-man").stdout
            check(options_of_page(page) == wanted,
                  f"{name}: options of the page and of --help differ: {set(options_of_page(page)) ^ set(wanted)}")
            check_page(name, page, folder / f"{name}.1")
            for shell in ("bash", "zsh", "fish"):
                path = folder / f"{name}.{shell}"
                path.write_text(run(program, "--completion", shell).stdout)
                scripts[name, shell] = path
                no_run = ["-n"] if shell != "fish" else ["--no-execute"]
                if shutil.which(shell):
                    said = run(shell, *no_run, path)
                    check(said.returncode == 0 and not said.stderr, f"{name}: {shell} does not read its script: {said.stderr}")
            check(completed(scripts[name, "bash"], name, ["-"], files) == wanted, f"{name} -: all options of --help")
            if shutil.which("fish"):
                said = run("fish", "--no-config", "-c", f"source {scripts[name, 'fish']}; complete -C '{name} --'", cwd=files)
                offered = sorted(line.split("\t")[0] for line in said.stdout.splitlines())
                check(offered == [o for o in wanted if o.startswith("--")], f"{name} --: fish offers {offered}")
        for name, words, expected in COMPLETIONS:
            offered = completed(scripts[name, "bash"], name, words, files)
            if expected is None:
                check("bash" in offered, f"{name} {words}: commands")
            else:
                check(offered == expected, f"{name} {' '.join(words)}: offers {offered}, expected {expected}")
        ids = re.findall(r"^[a-z-]+$", run(build / "tetproof-verify", "--list-checks").stdout, re.M)
        offered = completed(scripts["tetproof-verify", "bash"], "tetproof-verify", ["--check", ""], files)
        check(len(ids) > 20 and set(offered) == set(ids), f"--check offers {set(offered) ^ set(ids)} otherwise than --list-checks")
        check_accepted(build / "tetproof-verify", "--region", ["inside", "outside", "none"], files)
        check_accepted(build / "tetproof-verify", "--check", offered[:3], files)
        check_accepted(build / "tetproof-verify", "--allow", ["crack", "non-conforming-interface"], files)
        check_accepted(build / "tetproof-verify", "--from", FORMATS, files)
        if shutil.which("fish"):
            script = scripts["tetproof-verify", "fish"]
            said = run("fish", "--no-config", "-c", f"source {script}; complete -C 'tetproof-verify --region '", cwd=files)
            check(sorted(line.split("\t")[0] for line in said.stdout.splitlines()) == ["inside", "none", "outside"], f"fish: --region offers {said.stdout}")
        said = run(build / "tetproof-verify", "--completion", "csh")
        check(said.returncode == 2 and said.stderr.count("\n") == 1, f"another shell is bad usage: {said.stderr}")
    finish()


if __name__ == "__main__":
    main()
