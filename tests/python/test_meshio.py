# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio's meshes: judged as the same mesh in a file is, and the way there and back loses nothing."""
import types
import warnings

import meshio
import numpy as np
import pytest
import tetproof


def samples(corpus):
    for path in sorted((corpus / "formats/meshes").iterdir()):
        try:
            yield path, tetproof.read(path)
        except tetproof.InputError:  # a part of a set, or a text about the files
            continue


def test_every_sample_is_the_same_as_through_a_vtu_file(corpus, tmp_path):
    count = 0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for path, document in samples(corpus):
            mesh = document.to_meshio()
            tetproof.write(tmp_path / "a.vtu", document)
            expected = tetproof.read(tmp_path / "a.vtu")
            found = tetproof.as_document(mesh)
            assert found.points.tobytes() == expected.points.tobytes(), path
            assert [(b.type, b.nodes.tolist(), b.entity, b.groups) for b in found.blocks] == [
                (b.type, b.nodes.tolist(), b.entity, b.groups) for b in expected.blocks], path
            assert found.group_names == expected.group_names, path
            assert tetproof.verify(mesh).to_json() == tetproof.verify(expected).to_json(), path
            count += 1
    assert count > 20


def test_what_meshio_reads_is_judged_as_the_file(corpus, judged_by_program, tmp_path):
    for name in ("inverted-inside", "hanging-in-face", "pinched-edge"):
        file = corpus / "bad-meshes" / f"{name}.msh"
        mesh = meshio.read(file)
        mesh.write(tmp_path / "a.vtu")
        assert tetproof.verify(mesh).to_dict() == judged_by_program(tmp_path / "a.vtu")
        found, of_file = tetproof.verify(mesh), tetproof.verify(file)
        assert [f.rows for f in found.findings] == [f.rows for f in of_file.findings]


def test_names_and_groups_go_there_and_back(corpus, tmp_path):
    document = tetproof.read(corpus / "formats/meshes/two_22_text.msh")
    with pytest.warns(tetproof.LossWarning):  # partitions and the like
        mesh = document.to_meshio()
    assert mesh.field_data["steel part"].tolist() == [7, 3] and set(mesh.cells_dict) >= {"tetra", "triangle"}
    tetproof.write(tmp_path / "a.msh", mesh, format="msh22")
    assert tetproof.read(tmp_path / "a.msh").group_names == document.group_names
    assert meshio.read(tmp_path / "a.msh").field_data["steel part"].tolist() == [7, 3]


# An element of each shape, in meshio's order of nodes, of volume 1/6 or 1/2 or 1.
X = {"tetra": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
     "pyramid": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]],
     "wedge": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]],
     "hexahedron": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]]}


@pytest.mark.parametrize("name", X)
def test_the_nodes_of_each_shape_stay_in_their_order(name, tmp_path):
    mesh = meshio.Mesh(np.array(X[name], float), [(name, [list(range(len(X[name])))])])
    document = tetproof.as_document(mesh)
    back = document.to_meshio()
    assert back.cells[0].type == name and back.cells[0].data.tolist() == mesh.cells[0].data.tolist()
    meshio.write(tmp_path / "a.msh", mesh, file_format="gmsh22")  # Gmsh's order, by meshio
    assert tetproof.read(tmp_path / "a.msh").blocks[0].nodes.tolist() == document.blocks[0].nodes.tolist()


@pytest.mark.parametrize("name, nodes", [("tetra10", 10), ("hexahedron20", 20), ("hexahedron27", 27),
                                         ("tetra20", 20), ("triangle10", 10), ("line4", 4), ("quad9", 9)])
def test_elements_of_higher_order_are_those_of_the_file_that_meshio_writes(name, nodes, tmp_path):
    mesh = meshio.Mesh(np.random.default_rng(1).random((nodes, 3)), [(name, [list(range(nodes))])])
    meshio.write(tmp_path / "a.msh", mesh, file_format="gmsh22", binary=False)
    expected, = tetproof.read(tmp_path / "a.msh").blocks
    assert tetproof.as_document(mesh).blocks[0].nodes.tolist() == expected.nodes.tolist()


def test_polyhedra_and_polygons(tmp_path):
    faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    mesh = meshio.Mesh(np.array(X["hexahedron"], float), [("polyhedron8", [[np.array(f) for f in faces]]),
                                                          ("polygon", [[0, 1, 2, 3, 7]])])
    document = tetproof.as_document(mesh)
    assert [block.name for block in document.blocks] == ["polyhedra", "polygons"]
    back = document.to_meshio()
    assert back.cells[0].type == "polyhedron8" and [f.tolist() for f in back.cells[0].data[0]] == faces
    assert tetproof.verify(mesh).not_judged[0].what == "polyhedra"


def test_what_is_not_taken_is_listed(two_tets):
    points, tets = two_tets
    mesh = meshio.Mesh(points, [("tetra", tets), ("hexahedron64", [[0] * 64])],
                       cell_data={"a": [np.array([1 + 1j, 2]), np.array([0j])]}, point_sets={"fixed": [0, 1]})
    dropped = {loss.item: loss for loss in tetproof.as_document(mesh).dropped}
    assert dropped["meshio's point_sets"].count == 1
    assert dropped["cells of type 72 (Lagrange hexahedron)"].elements
    assert dropped["data of cells that are neither numbers nor texts"].example == "'a', complex128"
    assert tetproof.verify(mesh).verdict == "incomplete"


def test_types_that_this_meshio_does_not_have_are_said(tmp_path):
    points = np.random.default_rng(1).random((15, 3))
    grid = types.SimpleNamespace(points=points, cells=np.r_[15, range(15), 4, range(4)],
                                 celltypes=np.array([26, 10]), cell_data={"a": np.array([1.0, 2.0])})
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        mesh = tetproof.as_document(grid).to_meshio()
    if "wedge15" in mesh.cells_dict:
        assert not said and len(mesh.cells) == 2
    else:
        assert [str(w.message) for w in said] == [
            "lost: elements of a type that this meshio does not have: 1 (wedge15)"]
        assert mesh.cell_data["a"][0].tolist() == [2.0]


def test_what_a_vtu_does_not_hold_is_said(corpus):
    document = tetproof.read(corpus / "formats/meshes/two_41_text.msh")
    lost = document.losses(".vtu")
    assert lost
    with pytest.warns(tetproof.LossWarning) as said:
        document.to_meshio()
    assert [str(w.message) for w in said] == [f"lost: {loss}" for loss in lost]
