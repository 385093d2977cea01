# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other libraries, by their attributes. VTK's own are tested where VTK is installed."""
import types

import numpy as np
import pytest
import tetproof


def pyvista_grid(points, cells, **data):
    """An object with the attributes of pyvista.UnstructuredGrid. `cells`: pairs of VTK's type and points."""
    flat = [number for _, nodes in cells for number in (len(nodes), *nodes)]
    given = {"point_data": {}, "cell_data": {}, "field_data": {}, **data}
    return types.SimpleNamespace(points=points, cells=np.array(flat),
                                 celltypes=np.array([number for number, _ in cells], np.uint8), **given)


def test_a_grid_of_tetrahedra_is_judged_as_its_arrays(two_tets, inverted):
    for points, tets in (two_tets, inverted):
        grid = pyvista_grid(points, [(10, tet) for tet in tets], cell_data={"stress": np.zeros(2)})
        assert tetproof.verify(grid).to_json() == tetproof.verify(points, tets).to_json()
        assert tetproof.verify(grid).to_json() == tetproof.verify(tetproof.as_document(grid)).to_json()


CUBE = np.array([[x, y, z] for z in (0.0, 1) for y in (0, 1) for x in (0, 1)])
HEXAHEDRON = (12, [0, 1, 3, 2, 4, 5, 7, 6])


def test_what_is_no_tetrahedron_is_named_as_not_judged():
    points = np.vstack([CUBE, [[2, 0, 0]]])
    grid = pyvista_grid(points, [HEXAHEDRON, (10, [1, 8, 3, 5]), (5, [1, 8, 3])])
    report = tetproof.verify(grid)
    assert report.verdict == "incomplete"
    assert [(n.what, n.count) for n in report.not_judged] == [("hexahedra", 1)]
    alone = tetproof.verify(grid, only_tets=True)
    assert alone.sound and alone.left_out[0].what == "hexahedra"


def test_numbers_are_those_of_the_cells():
    points = np.vstack([CUBE, [[2, 0, 0]]])
    finding, = tetproof.verify(pyvista_grid(points, [HEXAHEDRON, (10, [8, 1, 3, 5])])).findings
    assert (finding.check, finding.tets, finding.rows) == ("inverted", (1,), (0,))


def test_cells_that_cannot_be_read_make_it_incomplete():
    grid = pyvista_grid(CUBE, [(72, range(8)), (10, [0, 1, 2, 4])])
    document = tetproof.as_document(grid)
    loss, = document.dropped
    assert loss.item == "cells of type 72 (Lagrange hexahedron)" and loss.elements
    assert tetproof.verify(grid).verdict == "incomplete"


def test_cell_data_are_groups_and_regions(two_tets):
    points, tets = two_tets
    grid = pyvista_grid(points, [(10, tet) for tet in tets], cell_data={"gmsh:physical": np.array([3, 4])},
                        field_data={"steel": np.array([3, 3])}, point_data={"t": np.arange(5) / 2})
    document = tetproof.as_document(grid)
    assert [block.groups for block in document.blocks] == [(3,), (4,)]
    assert document.group_names == {(3, 3): "steel"}
    regions = tetproof.verify(grid).to_dict()["regions"]
    assert [(region["tag"], region["name"]) for region in regions] == [(3, "steel"), (4, "")]


@pytest.mark.parametrize("change, said", [
    ({"points": np.zeros((5, 2))}, "three coordinates"), ({"cells": np.array([4, 0, 1])}, "cells: expected"),
    ({"cells": np.array([1.5])}, "integers"),
    ({"celltypes": np.array([10])}, "cells: expected 1 cells, found 2"),
    ({"cell_data": {"a": np.zeros(7)}}, "'a' of cells: expected 2 rows, found 7"),
])
def test_contradictions_are_refused(two_tets, change, said):
    points, tets = two_tets
    grid = pyvista_grid(points, [(10, tet) for tet in tets])
    vars(grid).update(change)
    with pytest.raises(tetproof.InputError, match=said):
        tetproof.verify(grid)


def test_cells_of_different_sizes_that_look_alike():
    # The numbers at every fifth place are 4: only the sizes tell the cells apart.
    points = np.random.default_rng(1).random((9, 3))
    grid = pyvista_grid(points, [(9, [0, 1, 2, 3]), (5, [5, 6, 7]), (7, [4, 5, 6, 7, 8])])
    assert [block.nodes.tolist() for block in tetproof.as_document(grid).blocks] == [
        [[0, 1, 2, 3]], [[5, 6, 7]], [[4, 5, 6, 7, 8]]]


def test_cells_dict_alone(two_tets):
    points, tets = two_tets
    for key in ("tetra", 10):
        assert tetproof.verify(types.SimpleNamespace(points=points, cells_dict={key: tets})).sound


def test_surfaces(two_tets):
    points, tets = two_tets
    # The sides of the two tetrahedra, as PyVista's PolyData and trimesh's meshes have faces.
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 4], [2, 3, 4], [3, 1, 4]])
    poly = types.SimpleNamespace(points=points, faces=np.insert(faces, 0, 3, axis=1).ravel())
    mesh = types.SimpleNamespace(vertices=points, faces=faces)
    for surface in ((points, faces), poly, mesh):
        assert tetproof.verify(points, tets, surface, fidelity=0).sound
        assert tetproof.verify(points, tets[:1], surface).defective
        assert tetproof.as_surface(surface).triangles.tolist() == faces.tolist()


def test_vtk(two_tets):
    vtk = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")
    points, tets = two_tets
    grid, places = vtk.vtkUnstructuredGrid(), core.vtkPoints()
    places.SetDataTypeToDouble()
    for point in np.vstack([points, CUBE + [5, 0, 0]]):
        places.InsertNextPoint(point)
    grid.SetPoints(places)
    for tet in tets:
        grid.InsertNextCell(10, 4, list(map(int, tet)))
    stream = core.vtkIdList()
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    for number in [6, *(n for face in faces for n in (4, *(5 + i for i in face)))]:
        stream.InsertNextId(number)
    grid.InsertNextCell(42, stream)
    groups = core.vtkIntArray()
    groups.SetName("gmsh:physical")
    for group in (3, 4, 5):
        groups.InsertNextValue(group)
    grid.GetCellData().AddArray(groups)
    document = tetproof.as_document(grid)
    assert [(block.name, block.groups) for block in document.blocks] == [
        ("tetrahedra", (3,)), ("tetrahedra", (4,)), ("polyhedra", (5,))]
    report = tetproof.verify(grid)
    assert report.verdict == "incomplete" and [n.what for n in report.not_judged] == ["polyhedra"]
