#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares tetproof-convert with other programs that read and write VTK and Medit files.

tetproof-convert must read every mode in which VTK writes as VTK itself does. VTK, meshio and Gmsh must read what
tetproof-convert writes, without a warning and with equal content. Each of them must see the mid-edge nodes of
second-order elements at the midpoints of the edges."""
import argparse
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
try:
    import vtk_common
    from node_orders import faces_look_outwards, orders_of_nodes
    from vtk_content import written_by_vtk
    from vtk_kinds import kinds_of_data
except ImportError as missing:  # of vtk, meshio or numpy
    print(f"skipped: {missing}")
    sys.exit(77)

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True)
    vtk_common.BUILD = pathlib.Path(parser.parse_args().build)
    if not vtk_common.GMSH:
        print("skipped: there is no gmsh")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        written_by_vtk(pathlib.Path(name))
        faces_look_outwards(pathlib.Path(name))
        orders_of_nodes(pathlib.Path(name))
        kinds_of_data(pathlib.Path(name))
    print(f"{len(vtk_common.failures)} failures")
    sys.exit(1 if vtk_common.failures else 0)
