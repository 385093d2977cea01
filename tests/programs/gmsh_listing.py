#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists what libgmsh understands of files, one fact a line, to be compared with our own reading.

usage: gmsh_listing.py FILE...          exit code 77: no Gmsh

For each file, in a process of its own: `file NAME`, `says WORDS` for each warning and error, `end CODE` (0: read,
3: refused, -N: crashed by signal N), and between them, sorted:

  node TAG X Y Z                     the bits of three doubles
  node TAG in DIM ENTITY
  element TAG TYPE in DIM ENTITY: NODES
  entity DIM TAG                     in the file, or made by Gmsh for elements
  groups DIM ENTITY: TAGS            physical groups, sorted; Gmsh drops their signs
  boundary DIM ENTITY: TAGS          signed, sorted, of entities of one dimension less
  partitions DIM ENTITY (PARENT): PARTITIONS
  name DIM TAG NAME
  periodic DIM ENTITY MASTER AFFINE: PAIRS
  data NAME STEP TIME COMPONENTS TAG: VALUES
"""
import ctypes as c
import ctypes.util
import os
import struct
import sys


def bits(x):
    return "%016x" % struct.unpack("<Q", struct.pack("<d", x))[0]


def signed(tag):
    return c.c_int64(tag).value


class Gmsh:
    """Gmsh's C interface. Results are pairs of pointer and length; the last argument is an error code."""

    def __init__(self, name):  # "libgmsh.so.4.8" of Debian 12, "libgmsh.so.4.13" of Debian 13
        self.lib = c.CDLL(name)
        self.runs = int(name.rsplit(".", 1)[1]) >= 9  # from 4.9 on gmshInitialize also asks whether to run

    def start(self):
        self.call("gmshInitialize", c.c_int(0), None, c.c_int(0), *([c.c_int(0)] if self.runs else []))
        self.call("gmshOptionSetNumber", b"General.Terminal", c.c_double(0))
        # Partitions of an old file stay with its elements, and do not become entities.
        self.call("gmshOptionSetNumber", b"Mesh.PartitionConvertMsh2", c.c_double(0))
        self.call("gmshLoggerStart")

    def call(self, name, *arguments):
        error = c.c_int(0)
        getattr(self.lib, name)(*arguments, c.byref(error))
        if error.value:
            raise RuntimeError("%s fails: %s" % (name, "; ".join(self.complaints())))

    def array(self, kind):
        return c.POINTER(kind)(), c.c_size_t(0)

    def strings(self, name):
        data, n = self.array(c.c_char_p)
        self.call(name, c.byref(data), c.byref(n))
        return [data[i].decode(errors="replace") for i in range(n.value)]

    def complaints(self):
        data, n = self.array(c.c_char_p)
        error = c.c_int(0)
        self.lib.gmshLoggerGet(c.byref(data), c.byref(n), c.byref(error))
        log = [data[i].decode(errors="replace") for i in range(n.value)]
        return [line for line in log if not line.startswith(("Info", "Debug", "Progress", "Status"))]

    def ints(self, name, *arguments, after=()):
        data, n = self.array(c.c_int)
        self.call(name, *arguments, c.byref(data), c.byref(n), *after)
        return data[: n.value]

    def text(self, name, *arguments):
        data = c.c_char_p()
        self.call(name, *arguments, c.byref(data))
        return data.value.decode("utf-8", "surrogateescape")


def pairs(flat):
    return list(zip(flat[0::2], flat[1::2]))


def list_nodes(gmsh, dim, tag, out):
    tags, n = gmsh.array(c.c_size_t)
    xyz, nxyz = gmsh.array(c.c_double)
    uv, nuv = gmsh.array(c.c_double)
    gmsh.call("gmshModelMeshGetNodes", c.byref(tags), c.byref(n), c.byref(xyz), c.byref(nxyz), c.byref(uv),
              c.byref(nuv), c.c_int(dim), c.c_int(tag), c.c_int(0), c.c_int(0))
    for i in range(n.value):
        out.append("node %d %s" % (tags[i], " ".join(bits(xyz[3 * i + k]) for k in range(3))))
        out.append("node %d in %d %d" % (tags[i], dim, tag))


def list_elements(gmsh, dim, tag, out):
    types, n = gmsh.array(c.c_int)
    tags, ntags = c.POINTER(c.POINTER(c.c_size_t))(), c.POINTER(c.c_size_t)()
    nodes, nnodes = c.POINTER(c.POINTER(c.c_size_t))(), c.POINTER(c.c_size_t)()
    nn, mm = c.c_size_t(0), c.c_size_t(0)
    gmsh.call("gmshModelMeshGetElements", c.byref(types), c.byref(n), c.byref(tags), c.byref(ntags), c.byref(nn),
              c.byref(nodes), c.byref(nnodes), c.byref(mm), c.c_int(dim), c.c_int(tag))
    for t in range(n.value):
        count = ntags[t]
        each = nnodes[t] // count if count else 0
        for e in range(count):
            out.append("element %d %d in %d %d: %s" % (signed(tags[t][e]), types[t], dim, tag,
                                                      " ".join(map(str, nodes[t][each * e: each * (e + 1)]))))


def list_periodic(gmsh, dim, tag, out):
    master = c.c_int(0)
    slaves, n = gmsh.array(c.c_size_t)
    masters, m = gmsh.array(c.c_size_t)
    affine, k = gmsh.array(c.c_double)
    gmsh.call("gmshModelMeshGetPeriodicNodes", c.c_int(dim), c.c_int(tag), c.byref(master), c.byref(slaves),
              c.byref(n), c.byref(masters), c.byref(m), c.byref(affine), c.byref(k), c.c_int(1))
    if master.value != tag:
        out.append("periodic %d %d %d %s: %s" % (
            dim, tag, master.value, " ".join(bits(x) for x in affine[: k.value]),
            " ".join("%d-%d" % p for p in sorted(zip(slaves[: n.value], masters[: m.value])))))


def list_data(gmsh, out):
    for view in gmsh.ints("gmshViewGetTags"):
        error = c.c_int(0)
        index = gmsh.lib.gmshViewGetIndex(c.c_int(view), c.byref(error))
        name = gmsh.text("gmshOptionGetString", b"View[%d].Name" % index)
        steps = c.c_double(0)
        gmsh.call("gmshOptionGetNumber", b"View[%d].NbTimeStep" % index, c.byref(steps))
        for step in range(int(steps.value)):
            kind = c.c_char_p()
            tags, n = gmsh.array(c.c_size_t)
            data, sizes = c.POINTER(c.POINTER(c.c_double))(), c.POINTER(c.c_size_t)()
            nn, time, components = c.c_size_t(0), c.c_double(0), c.c_int(0)
            gmsh.call("gmshViewGetModelData", c.c_int(view), c.c_int(step), c.byref(kind), c.byref(tags), c.byref(n),
                      c.byref(data), c.byref(sizes), c.byref(nn), c.byref(time), c.byref(components))
            for i in range(n.value):
                out.append("data %s %s %d %s %d %d: %s" % (
                    kind.value.decode(), name, step, bits(time.value), components.value, tags[i],
                    " ".join(bits(x) for x in data[i][: sizes[i]])))


def listing(gmsh):
    out = []
    entities = pairs(gmsh.ints("gmshModelGetEntities", after=(c.c_int(-1),)))
    for dim, tag in entities:
        out.append("entity %d %d" % (dim, tag))
        list_nodes(gmsh, dim, tag, out)
        list_elements(gmsh, dim, tag, out)
        list_periodic(gmsh, dim, tag, out)
        groups = gmsh.ints("gmshModelGetPhysicalGroupsForEntity", c.c_int(dim), c.c_int(tag))
        if groups:
            out.append("groups %d %d: %s" % (dim, tag, " ".join(str(abs(g)) for g in sorted(groups, key=abs))))
        one = (c.c_int * 2)(dim, tag)
        boundary = gmsh.ints("gmshModelGetBoundary", one, c.c_size_t(2),
                             after=(c.c_int(0), c.c_int(1), c.c_int(0))) if dim else []
        if boundary:
            out.append("boundary %d %d: %s" % (dim, tag, " ".join(map(str, sorted(b for _, b in pairs(boundary))))))
        partitions = gmsh.ints("gmshModelGetPartitions", c.c_int(dim), c.c_int(tag))
        if partitions:
            parent_dim, parent = c.c_int(0), c.c_int(0)
            gmsh.call("gmshModelGetParent", c.c_int(dim), c.c_int(tag), c.byref(parent_dim), c.byref(parent))
            out.append("partitions %d %d (%d %d): %s" % (dim, tag, parent_dim.value, parent.value,
                                                        " ".join(str(p) for p in sorted(partitions))))
    for dim, tag in pairs(gmsh.ints("gmshModelGetPhysicalGroups", after=(c.c_int(-1),))):
        name = gmsh.text("gmshModelGetPhysicalName", c.c_int(dim), c.c_int(tag))
        if name:
            out.append("name %d %d %s" % (dim, tag, name))
    list_data(gmsh, out)
    return out


def list_file(gmsh, path):
    code = 0
    try:
        gmsh.start()
        gmsh.call("gmshOpen", path.encode())
        lines = sorted(listing(gmsh))
    except RuntimeError as error:
        code, lines = 3, ["says %s" % error]
    complaints = gmsh.complaints()
    if any(line.startswith("Error") for line in complaints):
        code = 3
    lines += ["says " + line for line in complaints]
    sys.stdout.buffer.write(("\n".join(lines) + "\n").encode("utf-8", "surrogateescape"))
    sys.stdout.flush()
    os._exit(code)  # without the message that Gmsh prints at its end


def main():
    name = ctypes.util.find_library("gmsh")
    if not name:
        return 77
    gmsh = Gmsh(name)  # loaded once, because loading takes long, but started for each file
    for path in sys.argv[1:]:
        print("file " + path, flush=True)
        child = os.fork()
        if child == 0:
            list_file(gmsh, path)
        print("end %d" % os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
