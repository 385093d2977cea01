#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks who includes whom: the folders' rule, the page's rule, and that no rooms of a folder form a circle.

usage: includes.py [--root FOLDER] [--graph] [--self-test]
  --graph       also prints which room includes which
  --self-test   checks that planted breaches are found

A room is a folder inside io/, reference/, verify/ or corpus/; a room inside a room belongs to the outer one. A header
or source that stands in the folder itself is part of the folder's front door and counts as a room of its own.
Exit code 0: all is well; 1: each breach is printed.
"""
import argparse
import collections
import pathlib
import re
import sys
import tempfile

# Each folder's libraries may include only these folders besides their own. Programs (FOLDER/program/) and interfaces to other
# languages may include all.
MAY_INCLUDE = {"io": set(), "reference": {"io"}, "verify": {"io"}, "corpus": {"io", "verify"}}
INTERFACES = {"verify/c", "verify/python"}
# The page stands beside the paper alone: these files and folders of the project, these libraries, and the standard library.
PAGE, ENGINE = "reference/paper/", "reference/engine/"
PAGE_MAY_INCLUDE = (PAGE, "io/", "reference/tables.hpp", "reference/equations.hpp", "reference/options.hpp", "reference/trace/")
PAGE_LIBRARIES = ("Eigen/", "boost/multiprecision/")
# Known debts: an include that closes a circle between rooms, to be removed. An entry that no longer exists is a breach.
DEBTS = set()
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
LIBRARY = re.compile(r"^\s*#\s*include\s*<([^>]+)>", re.M)


def room(path):
    """The room of a path that starts with a folder's name: "io/vtk", or the file itself at the front door."""
    parts = path.split("/")
    return "/".join(parts[:2])


def circles(graph):
    """The strongly connected components of more than one room, each sorted (Tarjan's algorithm)."""
    order, low, stack, found = {}, {}, [], []

    def visit(node):
        order[node] = low[node] = len(order)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in order:
                visit(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == order[node]:
            component = []
            while not component or component[-1] != node:
                component.append(stack.pop())
            if len(component) > 1:
                found.append(sorted(component))

    for node in sorted(graph):
        if node not in order:
            visit(node)
    return found


def breaches_of_the_page(name, targets, libraries):
    """The breaches of a file: the page and the engine stay strangers, and the page needs little else."""
    if name.startswith(ENGINE):
        return [f"{name}: includes {target}, but the engine must not know the page" for target in targets if target.startswith(PAGE)]
    if not name.startswith(PAGE):
        return []
    breaches = [f"{name}: includes {target}, but the page may include {', '.join(PAGE_MAY_INCLUDE)} only"
                for target in targets if not target.startswith(PAGE_MAY_INCLUDE)]
    return breaches + [f"{name}: includes <{library}>, but the page may use {', '.join(PAGE_LIBRARIES)} and the standard library only"
                       for library in libraries if ("/" in library or "." in library) and not library.startswith(PAGE_LIBRARIES)]


def breaches_of(root, debts, show_graph=False):
    """Every breach below `root`, one text each."""
    breaches = []
    graph = collections.defaultdict(set)
    example = {}
    files = 0
    for folder, allowed in MAY_INCLUDE.items():
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            files += 1
            name = path.relative_to(root).as_posix()
            text = path.read_text(encoding="utf-8")
            breaches += breaches_of_the_page(name, INCLUDE.findall(text), LIBRARY.findall(text))
            for target in INCLUDE.findall(text):
                other = target.split("/")[0]
                if not (root / target).is_file():
                    breaches.append(f'{name}: includes "{target}": there is no such file below the project\'s folder')
                elif other == folder and room(name) != room(target):
                    graph[room(name)].add(room(target))
                    graph[room(target)]
                    example.setdefault((room(name), room(target)), f"{name} includes {target}")
                elif other != folder and other not in allowed and room(name) not in {folder + "/program", *INTERFACES}:
                    may = " and ".join(sorted(allowed)) or "no other folder"
                    breaches.append(f"{name}: includes {target}, but {folder} may include {may} only")
    if not files:
        sys.exit(f"includes.py: no sources below {root}")
    if show_graph:
        for node in sorted(graph):
            print(f"{node}: {' '.join(sorted(graph[node]))}")
    for source, target in sorted(debts):
        if target in graph[source]:
            graph[source].remove(target)
        else:
            breaches.append(f"{source} no longer includes {target}: remove the pair from DEBTS in includes.py")
    for circle in circles(graph):
        ways = [f"\n    {example[source, target]}" for source in circle for target in circle if target in graph[source]]
        breaches.append("rooms in a circle: " + ", ".join(circle) + "".join(ways))
    print(f"{files} files, {len(breaches)} breaches, {len(debts)} known debts")
    return breaches


def self_test():
    """Plants one breach of each kind in a small tree; returns what was not found, or found wrongly."""
    sound = {"io/a/a.hpp": "", "io/front.hpp": "io/a/a.hpp", "verify/b/b.cpp": "io/front.hpp",
             "corpus/c.cpp": "verify/v.hpp", "verify/v.hpp": "", "reference/program/main.cpp": "verify/v.hpp",
             "verify/python/p.cpp": "corpus/c.hpp", "verify/c/c.cpp": "corpus/c.hpp", "corpus/c.hpp": "",
             "reference/tables.hpp": "", "reference/x.hpp": "", "reference/engine/e.hpp": "reference/tables.hpp",
             "reference/paper/p.hpp": "reference/tables.hpp", "reference/paper/q.hpp": "<Eigen/Geometry>",
             "reference/paper/r.hpp": "io/front.hpp", "reference/by_page.cpp": "reference/paper/p.hpp"}
    planted = {
        "may include": {"io/a/a.hpp": "verify/v.hpp"},
        "reference may include io only": {"reference/x.cpp": "verify/v.hpp"},
        "verify may include io only": {"verify/d/d.cpp": "corpus/c.hpp"},
        "there is no such file": {"verify/b/b.cpp": "io/missing.hpp"},
        "the engine must not know the page": {"reference/engine/e.hpp": "reference/paper/p.hpp"},
        "reference/engine/e.hpp, but the page may include": {"reference/paper/p.hpp": "reference/engine/e.hpp"},
        "reference/x.hpp, but the page may include": {"reference/paper/q.hpp": "reference/x.hpp"},
        "<CGAL/Kernel.h>, but the page may use": {"reference/paper/p.hpp": "<CGAL/Kernel.h>"},
        "<tbb/parallel_for.h>, but the page may use": {"reference/paper/q.hpp": "<tbb/parallel_for.h>"},
        "<boost/graph.hpp>, but the page may use": {"reference/paper/q.hpp": "<boost/graph.hpp>"},
        "<unistd.h>, but the page may use": {"reference/paper/q.hpp": "<unistd.h>"},
        "rooms in a circle: io/a, io/front.hpp": {"io/a/a.hpp": "io/front.hpp"},
        "rooms in a circle: io/p, io/q, io/r": {"io/p/p.hpp": "io/q/q.hpp", "io/q/q.hpp": "io/r/r.hpp", "io/r/r.cpp": "io/p/p.hpp",
                                               "io/r/r.hpp": ""},
    }
    wrong = []
    for expected, files in [(None, {}), *planted.items()]:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, target in {**sound, **files}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                include = f"#include {target}" if target.startswith("<") else f'#include "{target}"'
                (root / name).write_text(f"#include <vector>\n{include}\n" if target else "")
            found = breaches_of(root, set())
        if (expected is None and found) or (expected and not (len(found) == 1 and expected in found[0])):
            wrong.append(f"expected {expected}, found {found}")
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "io").mkdir()
        (pathlib.Path(folder) / "io/x.hpp").write_text("")
        if len(breaches_of(pathlib.Path(folder), {("io/a", "io/b")})) != 1:
            wrong.append("a debt that was paid is not reported")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2])
    parser.add_argument("--graph", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    options = parser.parse_args()
    found = self_test() if options.self_test else breaches_of(options.root, DEBTS, options.graph)
    for breach in found:
        print(breach)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
