# SPDX-License-Identifier: GPL-3.0-or-later
"""What the peers are known to read differently from us, or not at all, with the reasons."""
import re
import struct

from differential_peers import MESHIO

# Samples of other programs that a peer reads differently, or not at all: the file and the reason. No other file may differ.
NO_COMMENTS = "it takes no comments or blank lines there"
UNESCAPED = "VTK leaves < in the names of arrays that it writes as it is, which no reader of XML takes"
NO_TEXTS = "it takes no arrays of texts"
SEPARATE = "it wants as many texture coordinates and normals as points"
KNOWN = {
    "meshio": {
        "two.1.node": "it takes no comment behind the numbers",
        "set.1.node": "it takes no comment behind the numbers",
        "set.1.v.node": "it wants an .ele",
        "c.node": "it takes no comment behind the numbers",
        "q1.node": "it takes no commas",
        "q2.node": "it wants an .ele",
        "q3.node": "it takes no short first line",
        "example_o2.1.node": "it takes no second order from TetGen",
        "example.1.mesh": "it takes Medit's version 1 for 32-bit coordinates, where TetGen wrote 17 digits",
        "two.mesh": "it wants each corner in a line of its own",
        "cells_text.vtu": UNESCAPED,
        "cells_raw.vtu": UNESCAPED,
        "cells_base64_zlib.vtu": UNESCAPED,
        "cells_text.vtk": NO_TEXTS,
        "cells_binary.vtk": NO_TEXTS,
        "cube.obj": "it takes no continued lines",
        "vcol.obj": "it takes colours for coordinates",
        "nancolor.obj": "it takes colours for coordinates",
        "vtvn.obj": SEPARATE,
        "box.obj": SEPARATE,
        "cube_compressed.obj": SEPARATE,
        "joined_tetrahedra.obj": SEPARATE,
        "negative_indices.obj": SEPARATE,
        "cube.off": "it wants OFF in a line of its own",
        "nohead.off": "it wants OFF in a line of its own",
        "whitespace.off": "it wants OFF in a line of its own",
        "comment.off": NO_COMMENTS,
        "comments.off": NO_COMMENTS,
        "color.off": "it takes no colours",
        "tetrahedra.stl": "it takes no exponents with D",
        "asc_noend.stl": "it takes a text without an end for a binary",
        "bin_cnt0.stl": "it believes the count 0, not the size",
        "cube_big_endian.ply": "it takes no elements but vertices and faces",
        "cube_text.ply": "it takes no elements but vertices and faces",
        "points_ascii_with_lists.ply": "it takes no elements but vertices and faces",
        "fuze.ply": "it wants all faces' lists alike long",
        "metadata.ply": "it takes no list but of corners",
        "empty.ply": "it fails where there is no face",
        "ply_empty_ascii.ply": "it fails where there is no face",
    },
    "vtk": {
        "cells_text.vtu": UNESCAPED,
        "cells_raw.vtu": UNESCAPED,
        "cells_base64_zlib.vtu": UNESCAPED,
        "cube.obj": "it takes no continued lines, and no negative numbers",
        "jacked.obj": "it reads nothing of it",
        "polygonfaces.obj": "it takes no `1//` without a number of a normal",
        "fuze.ply": "it doubles points with several texture coordinates",
        "asc_noend.stl": "it takes a text without an end for a binary",
        "cube_big_endian.ply": "it crashes on lists of other elements",
        "metadata.ply": "it crashes on lists of other elements",
    },
}

# The types of elements that a peer reads of a format.
SURFACE, SOLID, FIRST_ORDER = {2, 3, 9, 16, 34}, {4, 5, 6, 7, 11}, {1, 2, 3, 4, 5, 6, 7, 15}
ONLY = {("meshio", "obj"): SURFACE, ("meshio", "tetgen"): SOLID, ("meshio", "medit"): FIRST_ORDER,
        ("meshio", "node"): SOLID, ("vtk", "obj"): SURFACE | {1, 15},
        ("vtk", "ply"): SURFACE}

# Differences in what we write: formats, words of the peer's message, the reason, and a condition that the file must meet.
SECOND_ORDER = {8, 9, 10, 11, 12, 13, 14, 16, 17, 18, 19}
FEW_TAGS = "it wants a group and an entity of each element, and nothing else"


def counts_from_1(text, section):
    """Whether the numbers in a section of a binary file are 1, 2, ...: nodes of .msh 2.2, or values."""
    at = text.find(b"$" + section + b"\n")
    if at < 0 or text.split(b"\n")[1].split()[1] != b"1":
        return True
    lines = text[at:at + 4000].split(b"\n")
    skip, size, rows = 2, 4 + 3 * 8, int(lines[1])
    if section.endswith(b"Data"):
        skip = 1
        for _ in range(3):  # texts, numbers, integers: each count, and so many lines
            skip += 1 + int(lines[skip])
        size, rows = 4 + int(lines[skip - 2]) * 8, int(lines[skip - 1])
    place = at + sum(len(line) + 1 for line in lines[:skip])
    return all(struct.unpack_from("<i", text, place + k * size)[0] == k + 1 for k in range(rows))


KNOWN_WRITTEN = {
    "meshio": [
        ("msh41", "parametric nodes not implemented", "it takes no parametric nodes", None),
        ("msh41", "KeyError: [0-9]+", "it takes no partitioned entities",
         lambda kinds, text: b"$PartitionedEntities" in text),
        ("msh41|msh22", "KeyError", "it knows no such elements", lambda kinds, text: kinds - set(MESHIO.values())),
        ("msh41|msh22", "Incompatible cell data", "it wants groups and values of all elements or of none", None),
        ("msh41|msh22", "MemoryError", "it makes an array as long as the largest number", None),
        ("msh22", "invalid value encountered in cast", "it takes no numbers beyond 32 bits",
         lambda kinds, text: re.search(rb"\b[1-9][0-9]{9,}\b", text)),
        ("msh22", "NoneType|concatenation axis|^ it says: Warning: The file contains tag data", FEW_TAGS, None),
        ("msh22", "only it: ", "it takes node 0 for the last one", lambda kinds, text: re.search(rb"\$Nodes\n\d+\n0 ", text)),
        ("msh22", "Couldn't read file", "it wants numbers 1, 2, ... in binary",
         lambda kinds, text: not (counts_from_1(text, b"Nodes") and counts_from_1(text, b"NodeData") and
                                  counts_from_1(text, b"ElementData"))),
        ("msh41", "Couldn't read file", "it wants numbers 1, 2, ... in binary",
         lambda kinds, text: not (counts_from_1(text, b"NodeData") and counts_from_1(text, b"ElementData"))),
        ("vtk|vtu|msh41|msh22", "KeyError: 'pyramid13'", "it knows no such pyramids", lambda kinds, text: 19 in kinds),
        ("medit", "^ it says: Warning: meshio doesn't know Gmf[A-Za-z]*[PQ]2|Couldn't read file", "it knows no second order of Medit's",
         lambda kinds, text: kinds & SECOND_ORDER),
        ("tetgen", "Couldn't read file", "it takes no second order from TetGen", lambda kinds, text: 11 in kinds),
        ("stl", r"^ it says: \S*/_stl\.py:\d+: RuntimeWarning: overflow encountered in scalar multiply "
         r"if 84 \+ num_triangles \* 50 == filesize_bytes:$",
         "meshio 5.3.5 with NumPy 2 warns while it tries a text as binary", lambda kinds, text: text.startswith(b"solid")),
        ("off", "Can only read triangular faces", "it takes no faces but triangles",
         lambda kinds, text: any(line[:2] != b"3 " for line in text.split(b"\n")
                                 if line.count(b" ") != 2 and line[:1].isdigit())),
        ("ply", "Expected `element vertex`", "it takes no elements but vertices and faces", lambda kinds, text: b"element edge" in text),
        ("ply", "no field of name", "its reader of text drops characters of names", None),
    ],
    "vtk": [
        ("vtk", "Error reading ascii data", "its reader of text takes no nan, which stands where there is no value "
         "(tetproof-convert warns of it)", lambda kinds, text: b"nan" in text),
    ],
}


def known_of_written(peer, format_, kinds, wrong, text):
    for formats, words, reason, is_so in KNOWN_WRITTEN.get(peer, []):
        if re.fullmatch(formats, format_) and re.search(words, wrong) and (is_so is None or is_so(kinds, text)):
            return reason
    return None
