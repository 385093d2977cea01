# SPDX-License-Identifier: GPL-3.0-or-later
"""What survives on the way from one tool to another, through tetproof-convert: the table in README.

Gmsh makes a mesh of two boxes with named groups. Each tool A reads it in its own format and writes it anew, so that the
file is A's; tetproof-convert brings it to tool B, which reads it and writes it anew as well. What B wrote is compared with
what Gmsh made: tetrahedra, triangles, the groups of both, and their names."""
import argparse
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BEGIN, END = "<!-- made by tests/programs/tool_trips.py -->", "<!-- end -->"
GEO = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Box(2) = {1, 0, 0, 1, 1, 1};
Coherence;
Physical Volume("left", 7) = {1};
Physical Volume("right", 9) = {2};
Physical Surface("wall", 3) = {1 : 10};
Physical Surface("mid", 4) = {11};
Mesh.MeshSizeMax = 0.5;
"""


def run(*command, cwd=None):
    done = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(str(c) for c in command)}: exit code {done.returncode}\n{done.stdout}{done.stderr}")


def gmsh(path):
    new = path.with_name("gmsh-" + path.name)
    run("gmsh", "-v", "1", "-nt", "1", "-save", path, "-o", new, "-format", "msh41")
    return new


def tetgen(path):  # -r reads it and writes it with a new number
    run("tetgen", "-rQ", path.with_suffix(""), cwd=path.parent)
    return path.with_name("mesh.2.node")


def by_meshio(path):
    import meshio
    new = path.with_name("meshio-" + path.name)
    meshio.read(path).write(new)
    return new


def by_vtk(path):
    import vtk
    new = path.with_name("vtk-" + path.name)
    reader, writer = vtk.vtkXMLUnstructuredGridReader(), vtk.vtkXMLUnstructuredGridWriter()
    reader.SetFileName(str(path)), writer.SetFileName(str(new))
    writer.SetInputConnection(reader.GetOutputPort()), writer.Write()
    return new


TOOLS = {  # the file that each is given, and what reads it and writes it anew
    "Gmsh": ("mesh.msh", gmsh),
    "TetGen -r": ("mesh.1.node", tetgen),
    "VTK (.vtu)": ("mesh.vtu", by_vtk),
    "meshio (.vtu)": ("mesh.vtu", by_meshio),
    "Medit (meshio)": ("mesh.mesh", by_meshio),
}


def listing(path):
    """The tetrahedra and triangles of a .msh 2.2 by their group, and the names of groups."""
    text = path.read_text().split("\n")
    elements, names = {}, {}
    at = text.index("$Elements")
    for line in text[at + 2 : at + 2 + int(text[at + 1])]:
        words = [int(w) for w in line.split()]
        if words[1] in (2, 4):
            key = (words[1], words[3] if words[2] > 0 else 0)
            elements[key] = elements.get(key, 0) + 1
    if "$PhysicalNames" in text:
        at = text.index("$PhysicalNames")
        for line in text[at + 2 : at + 2 + int(text[at + 1])]:
            dim, number, name = re.fullmatch(r'(\d+) (\d+) "(.*)"', line).groups()
            names[int(dim), int(number)] = name
    return elements, names


def verdict(before, after):
    """In words: the most that is the same."""
    (elements, names), (others, other_names) = before, after

    def count(listed, kind):
        return sum(n for (one, _), n in listed.items() if one == kind)

    lost = [word for word, kind in (("tetrahedra", 4), ("faces", 2)) if count(elements, kind) != count(others, kind)]
    if lost:
        return "no " + ", no ".join(lost)
    if elements != others:
        return "no groups"
    return "all" if names == other_names else "no names"


def table(convert):
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        (scratch / "two.geo").write_text(GEO)
        run("gmsh", "-v", "1", "-nt", "1", "-3", scratch / "two.geo", "-o", scratch / "two.msh", "-format", "msh41")

        def listed(path):
            run(convert, path, scratch / "listed.msh", "--to", "msh22", "--ascii", "--quiet")
            return listing(scratch / "listed.msh")

        truth = listed(scratch / "two.msh")
        assert sum(truth[0].values()) > 500 and len(truth[1]) == 4, truth
        for from_tool, (name, anew) in TOOLS.items():
            folder = scratch / from_tool.split()[0].strip(",")
            folder.mkdir()
            run(convert, scratch / "two.msh", folder / name, "--quiet")
            mine = anew(folder / name)
            cells = []
            for to_tool, (other_name, other_anew) in TOOLS.items():
                there = folder / to_tool.split()[0].strip(",")
                there.mkdir(exist_ok=True)
                run(convert, mine, there / other_name, "--quiet")
                cells.append(verdict(truth, listed(other_anew(there / other_name))))
            rows.append(f"| {from_tool} | " + " | ".join(cells) + " |")
    head = "| from, to | " + " | ".join(TOOLS) + " |"
    return "\n".join([head, "|---" * (len(TOOLS) + 1) + "|", *rows]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path, help="the folder with tetproof-convert")
    parser.add_argument("--readme", type=pathlib.Path, default=pathlib.Path(__file__).parents[2] / "README.md")
    parser.add_argument("--check", action="store_true", help="compare with README instead of writing there")
    options = parser.parse_args()
    for tool in ("gmsh", "tetgen"):
        if not shutil.which(tool):
            print(f"skipped: there is no {tool}")
            return 77
    for module in ("meshio", "vtk"):
        if not importlib.util.find_spec(module):
            print(f"skipped: Python has no {module}")
            return 77
    made = table(options.build.resolve() / "tetproof-convert")
    text = options.readme.read_text()
    start, end = text.index(BEGIN) + len(BEGIN) + 1, text.index(END)
    if options.check:
        print(made)
        if text[start:end] != made:
            print(f"the table in {options.readme} is another one:\n{text[start:end]}")
            return 1
        return 0
    options.readme.write_text(text[:start] + made + text[end:])
    return 0


if __name__ == "__main__":
    sys.exit(main())
