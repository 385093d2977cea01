# SPDX-License-Identifier: GPL-3.0-or-later
"""Files: reading, writing, converting, losses; grids, surfaces and comparisons as the programs give them."""
import json
import os
import warnings

import numpy as np
import pytest
import tetproof


def test_a_document_shows_what_a_file_has(corpus):
    document = tetproof.read(corpus / "formats/meshes/two_41_text.msh")
    assert document.format == "msh41" and document.points.shape == (5, 3)
    assert document.group_names == {(2, 5): "skin", (3, 7): "steel part"}
    skin, part, point = document.blocks
    assert (part.name, part.dim, part.nodes.tolist(), part.groups) == (
        "tetrahedra", 3, [[0, 1, 2, 3], [1, 4, 2, 3]], (7,))
    assert document.tets.tolist() == part.nodes.tolist()
    assert [(name, len(nodes)) for name, nodes in document.cells] == [
        ("triangle", 2), ("tetra", 2), ("vertex", 1)]
    assert document.dropped == [] and "2 tetrahedra" in repr(document)
    with pytest.raises(ValueError):
        part.nodes[0, 0] = 1


def test_files_are_written_as_the_program_writes_them(corpus, program, tmp_path):
    source = corpus / "formats/meshes/two_41_text.msh"
    for name in ("a.msh", "a.1.node", "a.vtu", "a.mesh", "a.stl"):
        code, _, said = program("tetproof-convert", source, tmp_path / ("program-" + name),
                                "--json", tmp_path / "all.json")
        assert code == 0, said
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            losses = tetproof.convert(source, tmp_path / name)
        told = json.loads((tmp_path / "all.json").read_text())
        lists = {"losses": losses, "kept_aside": losses.kept_aside, "dropped": losses.dropped}
        for key, found in lists.items():
            assert [{"item": x.item, "count": x.count, "example": x.example} for x in found] == told[key]
        for file in losses.files:
            of_program = tmp_path / file.replace("/a.", "/program-a.")
            assert (tmp_path / file).read_bytes() == of_program.read_bytes()
    assert len(losses) > 0 and tetproof.read(source).losses(".stl") == losses


def test_strict(corpus, tmp_path):
    source = corpus / "formats/meshes/two_41_text.msh"
    with pytest.raises(tetproof.LossError, match="not written") as caught:
        tetproof.write(tmp_path / "a.stl", tetproof.read(source), strict=True)
    assert caught.value.losses and not (tmp_path / "a.stl").exists()
    assert tetproof.convert(source, tmp_path / "a.msh", strict_native=True) == []
    assert (tmp_path / "a.msh").exists()


def test_bad_files(tmp_path):
    (tmp_path / "bad.msh").write_text("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\nx\n")
    with pytest.raises(tetproof.InputError, match="bad.msh:5"):
        tetproof.read(tmp_path / "bad.msh")
    for act in (lambda: tetproof.read(tmp_path / "none.msh"), lambda: tetproof.read(tmp_path, "no-format"),
                lambda: tetproof.write(tmp_path / "a.xyz", ([[0, 0, 0]], [[0, 0, 0, 0]])),
                lambda: tetproof.write(tmp_path / "none/a.msh", ([[0, 0, 0]], [[0, 0, 0, 0]]))):
        with pytest.raises(tetproof.InputError):
            act()


def test_a_file_is_not_written_over_its_source(corpus, tmp_path):
    file = tmp_path / "a.msh"
    file.write_bytes((corpus / "formats/meshes/two_41_text.msh").read_bytes())
    with pytest.raises(tetproof.InputError, match="is read, and would be written"):
        tetproof.convert(file, tmp_path / "." / "a.msh", format="msh22")
    assert file.read_bytes() == (corpus / "formats/meshes/two_41_text.msh").read_bytes()


def test_names_that_are_no_utf8(two_tets):
    name = os.fsdecode(b"gr\xfc\xdfe.msh")
    tetproof.write(name, two_tets)
    assert len(tetproof.read(name).tets) == 2
    assert tetproof.verify(name).sound
    os.remove(name)
    with pytest.raises(tetproof.InputError, match="gr"):
        tetproof.read(name)


def test_arrays_are_written_as_they_are(two_tets, tmp_path):
    points, tets = two_tets
    tetproof.write(tmp_path / "a.msh", (points, tets))
    tetproof.write(tmp_path / "a.off", tetproof.generate("sphere:r=1,n=500"))
    back = tetproof.read(tmp_path / "a.msh")
    assert (back.points == points).all() and (back.tets == tets).all()
    assert back.point_numbers.tolist() == [1, 2, 3, 4, 5]
    assert tetproof.as_surface(tmp_path / "a.off").triangles.shape == (512, 3)
    tets[1, 3] = 2**40
    with pytest.warns(tetproof.LossWarning, match="other programs"):
        losses = tetproof.write(tmp_path / "b.msh", (points, tets))
    assert losses.dangling and tetproof.read(tmp_path / "b.msh").unknown == [2**40 + 1]


def test_what_a_reader_does_not_take_is_said(tmp_path, two_tets):
    tetproof.write(tmp_path / "a.vtk", two_tets, binary=False)
    text = (tmp_path / "a.vtk").read_text().replace("CELL_TYPES 2\n10\n10", "CELL_TYPES 2\n10\n64")
    (tmp_path / "a.vtk").write_text(text)
    with pytest.warns(tetproof.FileWarning, match="not read: cells of type 64"):
        report = tetproof.verify(tmp_path / "a.vtk")
    assert report.verdict == "incomplete" and "64" in report.not_judged[0].what
    assert tetproof.read(tmp_path / "a.vtk").dropped[0].elements


def test_the_reference_makes_the_programs_grid(program, tmp_path):
    code, _, _ = program("tetproof-mesh", "torus:R=1,r=0.4,n=1000", "-o", tmp_path / "a.msh", "--cells", 9,
                         "--points", 20, "--v0", "abs:0.001", "--region", "outside")
    assert code == 0
    grid = tetproof.mesh("torus:R=1,r=0.4,n=1000", 9, "outside", 20, v0="abs:0.001")
    tetproof.write(tmp_path / "b.msh", grid)
    assert (tmp_path / "b.msh").read_bytes() == (tmp_path / "a.msh").read_bytes()


@pytest.mark.parametrize("options, said", [
    ({"cells": 0}, "cells"), ({"cells": (1, 2)}, "cells"), ({"points": -1}, "points"), ({"v0": "x"}, "v0"),
    ({"region": "up"}, "'up'"), ({"engine": "slow"}, "engine"), ({"p": -1}, "p"), ({"box_scale": 0.5}, "box"),
    ({"surface": ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])}, "open"),
    ({"surface": "block:z=1e-9", "cells": 3}, "block"),
])
def test_bad_options_of_the_reference(options, said):
    with pytest.raises(tetproof.InputError, match=said):
        tetproof.mesh(**{"surface": "sphere:r=1,n=500", "cells": 6, **options})


def test_surfaces():
    surface = tetproof.fuzz(7, 12)
    assert surface.name.startswith("fuzz:") and surface.fault == ""
    again = tetproof.generate(surface.name)
    assert (again.points == surface.points).all() and (again.triangles == surface.triangles).all()
    assert tetproof.fuzz(7, 12).points.tobytes() == tetproof.generate("fuzz:seed=7,case=12").points.tobytes()
    with pytest.raises(tetproof.InputError, match="no-such-kind"):
        tetproof.fuzz(1, 0, kinds=["no-such-kind"])
    for seed, index in ((-1, 0), (1, 2**64), ("x", 0)):
        with pytest.raises(tetproof.InputError, match="expected a number from 0"):
            tetproof.fuzz(seed, index)
    with pytest.raises(tetproof.InputError, match="list_surfaces"):
        tetproof.generate("part.stl")


def test_comparisons(corpus, two_tets, tmp_path, program):
    points, tets = two_tets
    order = np.array([3, 1, 4, 0, 2])
    moved = np.empty_like(points)
    moved[order] = points
    assert tetproof.compare((moved, order[tets[::-1]]), (points, tets)).equal
    differs = tetproof.compare((points, tets[:1]), (points, tets))
    assert differs.verdict == "diverges" and not differs.equal and "only in reference" in str(differs)
    assert tetproof.compare((points + 1e-6, tets), (points, tets), tolerance=1e-3).equal
    trace = next((corpus / "vectors").rglob("*.jsonl"))
    same = tetproof.compare(trace, trace)
    assert same.verdict == "equal" and same.to_dict()["verdict"] == "equal"
    with pytest.raises(tetproof.InputError, match="two traces or two grids"):
        tetproof.compare(trace, two_tets)
    tetproof.write(tmp_path / "a.msh", (points, tets[:1]))
    tetproof.write(tmp_path / "b.msh", (points, tets))
    code, out, _ = program("tetproof-compare", tmp_path / "a.msh", tmp_path / "b.msh", "--json", "-")
    assert code == 1 and tetproof.compare(tmp_path / "a.msh", tmp_path / "b.msh").to_json() == out
