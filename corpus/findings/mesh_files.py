# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the files of a finding: surfaces as OFF, meshes as .node and .ele, .msh 2.2 and 4.1, and .mesh. For check.py."""
import collections
import struct

Mesh = collections.namedtuple("Mesh", "points tets")  # by their numbers in the file


class NotCheckable(Exception):
    """The statement cannot be decided here; the text says why."""


def lines_of(path):
    with open(path) as file:
        return [words for line in file if (words := line.split("#")[0].split())]


def by_number(pairs, what):
    table = {}
    for number, value in pairs:
        if number in table:
            raise NotCheckable(f"the file has two {what} with the number {number}")
        table[number] = value
    return table


def read_off(path):
    words = [word for line in lines_of(path) for word in line]
    vertices, triangles = int(words[1]), int(words[2])
    points = [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(vertices)]
    at = 4 + 3 * vertices
    if any(words[at + 4 * i] != "3" for i in range(triangles)):
        raise NotCheckable(f"{path.name} has faces that are no triangles")
    return points, [tuple(map(int, words[at + 4 * i + 1:at + 4 * i + 4])) for i in range(triangles)]


def read_tetgen(path):
    nodes, tets = lines_of(path.with_suffix(".node")), lines_of(path.with_suffix(".ele"))
    return Mesh(by_number(((int(w[0]), tuple(map(float, w[1:4]))) for w in nodes[1:int(nodes[0][0]) + 1]), "nodes"),
                by_number(((int(w[0]), tuple(map(int, w[1:5]))) for w in tets[1:int(tets[0][0]) + 1]), "tetrahedra"))


def read_medit(path):
    words = iter(word for line in lines_of(path) for word in line)
    lists = {"Vertices": [], "Tetrahedra": []}
    for word in words:
        if word in lists:
            for _ in range(int(next(words))):
                lists[word].append([next(words) for _ in range(4 if word == "Vertices" else 5)])
    return Mesh({i: tuple(map(float, w[:3])) for i, w in enumerate(lists["Vertices"], 1)},
                {i: tuple(map(int, w[:4])) for i, w in enumerate(lists["Tetrahedra"], 1)})


class Numbers:
    """The numbers of a section of a .msh file, text or binary, one after the other."""

    def __init__(self, body, order):
        self.order, self.body, self.at = order, body, 0
        self.words = None if order else iter(body.split())

    def take(self, codes):
        """One number for each letter: i int, q size, d double."""
        if self.words:
            return [(float if code == "d" else int)(next(self.words)) for code in codes]
        values = struct.unpack_from(self.order + codes, self.body, self.at)
        self.at += struct.calcsize(self.order + codes)
        return list(values)


def read_msh(path):
    data = path.read_bytes()

    def section(name):
        start = data.index(b"$" + name + b"\n") + len(name) + 2
        return data[start:data.rindex(b"$End" + name)]

    version, binary, _ = section(b"MeshFormat").split()[:3]
    order = ""
    if binary != b"0":
        one = section(b"MeshFormat").split(b"\n", 1)[1][:4]
        order = "<" if one == struct.pack("<i", 1) else ">"
    if version not in (b"2.2", b"4.1"):
        raise NotCheckable(f"{path.name} is a .msh of version {version.decode()}; 2.2 and 4.1 can be read")
    corners = {1: 2, 2: 3, 3: 4, 4: 4, 5: 8, 6: 6, 7: 5, 15: 1}
    nodes, tets = [], []

    def element(kind, number, vertices):
        if kind == 4:
            tets.append((number, tuple(vertices)))

    def nodes_of(kind):
        if kind not in corners:
            raise NotCheckable(f"{path.name} has elements of type {kind}")
        return corners[kind]

    if version == b"2.2":
        count, body = section(b"Nodes").split(b"\n", 1)
        numbers = Numbers(body, order)
        for _ in range(int(count)):
            number, *point = numbers.take("iddd")
            nodes.append((number, tuple(point)))
        count, body = section(b"Elements").split(b"\n", 1)
        numbers, left = Numbers(body, order), int(count)
        while left > 0:
            if order:
                kind, several, tags = numbers.take("iii")
            for _ in range(several if order else 1):
                if order:
                    number, *_ = numbers.take("i" + "i" * tags)
                else:
                    number, kind, tags = numbers.take("iii")
                    numbers.take("i" * tags)
                element(kind, number, numbers.take("i" * nodes_of(kind)))
                left -= 1
    else:
        numbers = Numbers(section(b"Nodes"), order)
        for _ in range(numbers.take("qqqq")[0]):
            dim, _, parametric, count = numbers.take("iiiq")
            tags = [numbers.take("q")[0] for _ in range(count)]
            for tag in tags:
                nodes.append((tag, tuple(numbers.take("d" * (3 + dim * parametric))[:3])))
        numbers = Numbers(section(b"Elements"), order)
        for _ in range(numbers.take("qqqq")[0]):
            _, _, kind, count = numbers.take("iiiq")
            for _ in range(count):
                number, *vertices = numbers.take("q" * (1 + nodes_of(kind)))
                element(kind, number, vertices)
    return Mesh(by_number(nodes, "nodes"), by_number(tets, "tetrahedra"))


READERS = {".ele": read_tetgen, ".node": read_tetgen, ".msh": read_msh, ".mesh": read_medit}
