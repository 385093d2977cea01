#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The line of progress of every program, on a pseudo-terminal.

The line appears, names its phases, and is gone at the end: what then stands on the screen is what the program prints
where there is no terminal, no more and no less. Without a terminal, on a terminal that cannot remove a line, and with
--quiet there is no line; results are the same bytes. TETPROOF_PROGRESS_AFTER makes the programs show it sooner, and more often."""
import argparse
import os
import pathlib
import pty
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish  # noqa: E402


def on_terminal(command, folder, term="xterm", after="2"):
    """Standard error is a terminal of 80 columns. What it gets, and standard output."""
    master, slave = pty.openpty()
    environment = {**os.environ, "TERM": term}
    environment.pop("TETPROOF_PROGRESS_AFTER", None)
    if after:
        environment["TETPROOF_PROGRESS_AFTER"] = after
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=slave, env=environment)
        os.close(slave)
        seen = b""
        while True:
            try:
                piece = os.read(master, 1 << 16)
            except OSError:  # the program has closed its side
                break
            if not piece:
                break
            seen += piece
        os.close(master)
        code = process.wait(timeout=120)
        out.seek(0)
        return code, out.read(), seen.decode()


def screen(seen):
    """What is left on the screen. The programs use a carriage return, `ESC [ K` and line feeds alone."""
    lines, column = [""], 0
    for token in re.findall(r"\x1b\[K|\r|\n|[^\x1b\r\n]+|\x1b", seen):
        if token == "\r":
            column = 0
        elif token == "\n":
            lines.append("")
            column = 0
        elif token == "\x1b[K":
            lines[-1] = lines[-1][:column]
        else:
            lines[-1] = lines[-1][:column] + token + lines[-1][column + len(token):]
            column += len(token)
    return "\n".join(lines)


def check_program(name, command, phases, folder, same=True):
    plain = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                           env={**os.environ, "TETPROOF_PROGRESS_AFTER": "2", "TERM": "xterm"})
    check(b"\x1b" not in plain.stdout + plain.stderr, f"{name}: no line without a terminal")
    code, out, seen = on_terminal(command, folder)
    shown = re.findall(r"\r\x1b\[K([^\r]+)", seen)
    check(code == plain.returncode, f"{name}: exits {code}, without a terminal {plain.returncode}")
    for phase in phases:
        check(any(re.search(phase, line) for line in shown), f"{name}: no line has '{phase}': {shown}")
    check(all(len(line) < 80 for line in shown), f"{name}: a line is too long for the terminal")
    if same:
        check(out == plain.stdout, f"{name}: the result differs on a terminal")
        check(screen(seen) == plain.stderr.decode(), f"{name}: left on the screen: {screen(seen)!r}, not {plain.stderr.decode()!r}")
    else:
        check("left" not in screen(seen) and "%" not in screen(seen), f"{name}: left on the screen: {screen(seen)!r}")
    quiet = [command[0], "--quiet", *command[1:]]
    check(on_terminal(quiet, folder)[2] == "", f"{name}: --quiet shows something")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    build = parser.parse_args().build.resolve()
    program = {name: str(build / f"tetproof-{name}") for name in ("mesh", "verify", "compare", "convert", "fuzz")}
    with tempfile.TemporaryDirectory() as folder:
        mesh = [program["mesh"], "sphere", "-o", "g.msh", "--cells", "30", "--points", "3000"]
        check_program("tetproof-mesh", mesh, [r"^insertion \d+ %: \d+ s", r"about \d+ s left"], folder)
        surface = [program["mesh"], "sphere", "--save-surface", "s.off"]
        check(subprocess.run(surface, cwd=folder, capture_output=True).returncode == 0, "the surface is written")
        check_program("tetproof-verify", [program["verify"], "g.msh", "s.off", "--fidelity", "0.1"],
                      [r"^(reading|points|tetrahedra|boundary|voxels|distances|missing and excess regions)"], folder)
        check_program("tetproof-convert", [program["convert"], "g.msh", "g.1.node"],
                      [r"^(reading|planning|writing)"], folder)
        check_program("tetproof-compare", [program["compare"], "g.msh", "g.1.node", "--tolerance", "0"],
                      [r"^(reading g\.|comparing)"], folder)
        # Where two traces part, both are replayed.
        for name, more in (("mesh", []), ("mistaken", ["--mistake", "four-pieces"])):
            made = [str(build / f"tetproof-{name}"), "torus:R=1,r=0.4", "--cells", "12", "--trace", f"{name}.jsonl", *more]
            check(subprocess.run(made, cwd=folder, capture_output=True).returncode == 0, f"{name}.jsonl is written")
        check_program("tetproof-compare of traces", [program["compare"], "mistaken.jsonl", "mesh.jsonl"],
                      [r"^replaying mesh\.jsonl( \d+( %)?)?: "], folder)
        fuzz = [program["fuzz"], "--cases", "20", "--threads", "1", "--most-triangles", "100", "--",
                program["mesh"], "{surface}", "-o", "{mesh}", "--cells", "6", "--points", "0"]
        check_program("tetproof-fuzz", fuzz, [r"^\d+ of 20 cases, \d+ findings, about"], folder, same=False)

        convert = [program["convert"], "g.msh", "h.vtu"]
        check(on_terminal(convert, folder, term="dumb")[2] == "", "a dumb terminal gets no line")
        check(on_terminal(convert, folder, after="")[2] == "", "less than two seconds show no line")
    finish()


if __name__ == "__main__":
    main()
