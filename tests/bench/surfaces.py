# SPDX-License-Identifier: GPL-3.0-or-later
"""The surfaces of the measurements, as files for every program."""
import math
import struct


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    points, triangles = int(words[1]), int(words[2])
    numbers = words[4:]
    vertices = [tuple(map(float, numbers[3 * i:3 * i + 3])) for i in range(points)]
    numbers = numbers[3 * points:]
    return vertices, [tuple(map(int, numbers[4 * i + 1:4 * i + 4])) for i in range(triangles)]


def torus(R, r, around, across):
    """2 * around * across triangles, outward."""
    vertices, triangles = [], []
    for i in range(around):
        a = 2 * math.pi * i / around
        for j in range(across):
            b = 2 * math.pi * j / across
            ring = R + r * math.cos(b)
            vertices.append((ring * math.cos(a), ring * math.sin(a), r * math.sin(b)))
    for i in range(around):
        for j in range(across):
            p, p1 = i * across + j, i * across + (j + 1) % across
            q, q1 = (i + 1) % around * across + j, (i + 1) % around * across + (j + 1) % across
            triangles += [(p, q, q1), (p, q1, p1)]
    return vertices, triangles


def write_all(stem, vertices, triangles):
    """stem.off for us, stem.smesh for TetGen, stem.stl (binary) and stem.geo for Gmsh: its HXT mesher fills the triangles as they are."""
    with open(stem + ".off", "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in vertices)
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
    with open(stem + ".smesh", "w") as file:
        file.write(f"{len(vertices)} 3 0 0\n")
        file.writelines(f"{i} {x!r} {y!r} {z!r}\n" for i, (x, y, z) in enumerate(vertices))
        file.write(f"{len(triangles)} 0\n")
        file.writelines(f"3 {a} {b} {c}\n" for a, b, c in triangles)
        file.write("0\n0\n")
    with open(stem + ".stl", "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(triangles)))
        for corners in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *(c for v in corners for c in vertices[v]), 0))
    with open(stem + ".geo", "w") as file:
        name = stem.rsplit("/", 1)[-1]
        file.write(f'Merge "{name}.stl";\nSurface Loop(1) = {{1}};\nVolume(1) = {{1}};\nMesh.Algorithm3D = 10; // HXT\n')
