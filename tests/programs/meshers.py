# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes a closed surface with TetGen, Gmsh and CGAL: writes the files that they need, and runs them."""
import os
import subprocess


class NoMesh(Exception):
    """A mesher gave up."""


def run(words, folder, timeout):
    try:
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        raise NoMesh(f"longer than {timeout} s")
    return done


# --- the surface, as files for the meshers

def read_off(path):
    with open(path) as file:
        words = file.read().split()
    points, triangles, numbers = int(words[1]), int(words[2]), words[4:]
    vertices = [tuple(map(float, numbers[3 * i:3 * i + 3])) for i in range(points)]
    numbers = numbers[3 * points:]
    return vertices, [tuple(map(int, numbers[4 * i + 1:4 * i + 4])) for i in range(triangles)]


def components(vertices, triangles):
    """The component of each triangle, from 1, in the order of their first triangles."""
    parent = list(range(len(vertices)))

    def root(i):
        while parent[i] != i:
            parent[i] = parent[parent[i]]
            i = parent[i]
        return i

    for a, b, c in triangles:
        parent[root(b)] = root(a)
        parent[root(c)] = root(a)
    number = {}
    return [number.setdefault(root(t[0]), len(number) + 1) for t in triangles]


def box(vertices):
    low, high = ([f(p[k] for p in vertices) for k in range(3)] for f in (min, max))
    return low, high, sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5


def write_surface(stem, vertices, triangles, nested):
    low, high, _ = box(vertices)
    with open(stem + ".smesh", "w") as file:
        file.write(f"{len(vertices)} 3 0 0\n")
        file.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(vertices))
        file.write(f"{len(triangles)} 0\n")
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
        middle = " ".join(repr((a + b) / 2) for a, b in zip(low, high))
        file.write(f"1\n1 {middle}\n" if nested else "0\n")
    part = components(vertices, triangles)
    with open(stem + ".surface.msh", "w") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(vertices)}\n")
        file.writelines(f"{i + 1} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(vertices))
        file.write(f"$EndNodes\n$Elements\n{len(triangles)}\n")
        file.writelines(f"{i + 1} 2 2 0 {part[i]} {a + 1} {b + 1} {c + 1}\n" for i, (a, b, c) in enumerate(triangles))
        file.write("$EndElements\n")
    parts = range(1, max(part) + 1)
    volumes = [list(parts)] if nested else [[k] for k in parts]
    with open(stem + ".geo", "w") as file:
        file.write(f'Merge "{os.path.basename(stem)}.surface.msh";\n')
        file.writelines(f"Surface Loop({k}) = {{{k}}};\n" for k in parts)
        file.writelines(f"Volume({i + 1}) = {{{', '.join(map(str, loops))}}};\n" for i, loops in enumerate(volumes))


# --- the meshers; each returns the file that it wrote

def tetgen(options):
    def mesh(stem, folder, timeout, build):
        done = run(["tetgen", options, stem + ".smesh"], folder, timeout)
        if done.returncode != 0:
            raise NoMesh(f"exit code {done.returncode}")
        return stem + ".1.ele"
    return mesh


def gmsh(algorithm, threads):
    def mesh(stem, folder, timeout, build):
        # Binary keeps every bit of the coordinates.
        done = run(["gmsh", "-3", "-nt", str(threads), "-setnumber", "Mesh.Algorithm3D", str(algorithm), stem + ".geo",
                    "-o", stem + ".out.msh", "-format", "msh41", "-bin"], folder, timeout)
        if done.returncode != 0:
            errors = [line for line in (done.stdout + done.stderr).splitlines() if "Error" in line]
            raise NoMesh(f"exit code {done.returncode}: {errors[-1] if errors else ''}")
        return stem + ".out.msh"
    return mesh


def cgal(stem, folder, timeout, build):
    diagonal = box(read_off(os.path.join(folder, stem + ".off"))[0])[2]
    done = run([os.path.join(build, "cgal_mesh3"), stem + ".off", stem + ".mesh", repr(diagonal / 20), repr(diagonal * 4e-4)],
               folder, timeout)
    if done.returncode != 0:
        raise NoMesh(f"exit code {done.returncode}")
    with open(os.path.join(folder, stem + ".mesh")) as file:
        words = file.read().split()
    at = words.index("Vertices") + 1
    points, numbers = int(words[at]), words[at + 1:]
    with open(os.path.join(folder, stem + ".node"), "w") as file:
        file.write(f"{points} 3 0 0\n")
        file.writelines(f"{i + 1} {' '.join(numbers[4 * i:4 * i + 3])}\n" for i in range(points))
    at = words.index("Tetrahedra") + 1
    tets, numbers = int(words[at]), words[at + 1:]
    with open(os.path.join(folder, stem + ".ele"), "w") as file:
        file.write(f"{tets} 4 0\n")
        file.writelines(f"{i + 1} {' '.join(numbers[5 * i:5 * i + 4])}\n" for i in range(tets))
    return stem + ".ele"


MESHERS = {"tetgen-pY": tetgen("-pY"), "tetgen-pq": tetgen("-pq"), "gmsh-delaunay": gmsh(1, 1), "gmsh-hxt": gmsh(10, 1),
           "gmsh-hxt-2": gmsh(10, 2), "cgal": cgal}
