#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists the findings of this folder in the table of README.md.

usage: list.py [--check]
  without arguments   writes the table into README.md, between its two markers
  --check             exit 1 if README.md does not have the table that it should
"""
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
BEGIN, END = "<!-- made by list.py -->\n", "<!-- end -->\n"
NAMES = {"wrong-answer": "wrong mesh, exit 0", "wrong-against-surface": "mesh of another solid, exit 0",
         "no-output": "no file, exit 0", "no-tetrahedra": "no tetrahedra, exit 0", "unreadable": "unreadable file, exit 0",
         "crashed": "crash", "refused-valid": "valid surface called invalid"}
ORDER = list(NAMES)
LONGEST = 150  # characters of a statement in the table


def facts(folder):
    with open(folder / "finding.json") as file:
        return json.load(file)


def row(folder):
    finding = facts(folder)
    surface = next(s for s in finding["statements"] if s["kind"] == "valid_surface")
    first = next(s for s in finding["statements"] if s is not surface)["text"].replace("|", "\\|")
    if finding["outcome"] in ("crashed", "refused-valid"):
        first = finding["signature"].replace("|", "\\|")  # where it ends, or what it says
    if len(first) > LONGEST:
        first = first[:LONGEST].rsplit(" ", 1)[0] + " ..."
    mesher, variant = (finding["mesher"].split(",") + [""])[:2]
    number = re.search(r"\d+(\.\d+)+", finding["version"])  # of "Version 1.6", "Netgen, libnglib.so.6.2.1905"
    version = number.group() if number else finding["version"]
    often = f", {finding['failed']} of {finding['repeats']} runs" if finding["failed"] < finding["repeats"] else ""
    return (ORDER.index(finding["outcome"]),
            f"| [{folder.name}]({folder.name}/README.md) | {f'{mesher} {version}'.strip()}, {variant} | {NAMES[finding['outcome']]}{often} "
            f"| {surface['triangles']} | {first} |\n")


def table():
    folders = sorted(p.parent for p in HERE.glob("*/finding.json"))
    rows = sorted((row(folder) for folder in folders), key=lambda r: r[0])
    wrong = sum(r[0] <= ORDER.index("unreadable") for r in rows)
    return (f"{len(rows)} findings. In {wrong} of them the mesher exits with 0, and its mesh is wrong or absent.\n\n"
            "| finding | mesher | what | triangles | to see it |\n|---|---|---|---|---|\n" + "".join(text for _, text in rows))


def main():
    page = HERE / "README.md"
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    new = text[:begin] + table() + text[end:]
    if "--check" in sys.argv[1:]:
        if new != text:
            print(f"{page}: the table is not that of the folders; run list.py")
        return int(new != text)
    page.write_text(new)
    return 0


if __name__ == "__main__":
    sys.exit(main())
