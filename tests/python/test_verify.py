# SPDX-License-Identifier: GPL-3.0-or-later
"""The judge: the same report as the program's, findings, options, errors; threads and arithmetic."""
import copy
import ctypes
import gc
import json
import multiprocessing
import os
import pathlib
import pickle
import signal
import threading
import warnings
from fractions import Fraction

import numpy as np
import pytest
import tetproof

BAD = ["inverted-inside", "hanging-in-face", "overlap-1e-12", "index-too-high", "nan-inside",
       "crack-along-face", "copied-ball", "nested-component", "inverted-all", "crossed-diagonals"]
NUMBERS = ("tets", "vertices", "faces", "tet_runs")  #: keys of a finding


@pytest.mark.parametrize("name", BAD)
def test_a_file_has_the_programs_report(corpus, judged_by_program, name):
    file = corpus / "bad-meshes" / f"{name}.msh"
    expected = judged_by_program(file)
    report = tetproof.verify(file)
    assert report.to_dict() == expected
    assert report.verdict == expected["verdict"]
    assert tetproof.verify(tetproof.read(file)).to_dict() == expected


@pytest.mark.parametrize("name", BAD)
def test_arrays_have_the_programs_report_with_positions_from_0(corpus, judged_by_program, name, tmp_path):
    document = tetproof.read(corpus / "bad-meshes" / f"{name}.msh")
    tets = document.tets.astype(np.int64)
    for place in np.argwhere(tets < 0):  # what no point has, as the file has it
        tets[tuple(place)] = document.unknown[-1 - tets[tuple(place)]] - 1
    report = tetproof.verify(document.judged_points, tets).to_dict()

    def moved(value, key=""):
        """The program's report of the file, whose numbers count from 1."""
        if isinstance(value, dict):
            return {k: moved(v, k) for k, v in value.items()}
        if isinstance(value, list):
            return [moved(v, key) for v in value]
        return value - 1 if key in NUMBERS and isinstance(value, int) else value

    expected = judged_by_program(corpus / "bad-meshes" / f"{name}.msh")
    for result in (*expected["checks"], *expected.get("if_mended", {"checks": []})["checks"]):
        result["findings"] = moved(result["findings"])
    assert report == expected


def test_against_a_surface(judged_by_program, tmp_path):
    surface = tetproof.generate("sphere:r=1,n=500")
    grid = tetproof.mesh(surface, cells=8)
    tetproof.write(tmp_path / "grid.msh", grid)
    for fidelity in (0.1, 1e-3):
        report = tetproof.verify(grid, surface, fidelity=fidelity)
        expected = judged_by_program(tmp_path / "grid.msh", "sphere:r=1,n=500", "--fidelity", fidelity)
        assert report.verdict == ("sound" if fidelity == 0.1 else "defective")
        assert report.to_dict()["fidelity"] == expected["fidelity"]
        of_file = tetproof.verify(tmp_path / "grid.msh", "sphere:r=1,n=500", fidelity=fidelity)
        assert of_file.to_dict() == expected
    points, triangles = surface
    of_arrays = tetproof.verify(*grid, (points, triangles), fidelity=0.1)
    assert of_arrays.to_json() == tetproof.verify(grid, "sphere:r=1,n=500", fidelity=0.1).to_json()
    document = tetproof.as_document(surface)
    assert of_arrays.to_json() == tetproof.verify(grid, surface=document, fidelity=0.1).to_json()


def test_findings(inverted):
    report = tetproof.verify(*inverted)
    finding, = report.findings
    assert (finding.check, finding.tets, finding.rows) == ("inverted", (1,), (1,))
    assert finding.consequences == {"face-orientation": 1}  # the common face
    assert report.defective and not report.sound and report.certificate is False
    check = report.checks["inverted"]
    assert (check.verdict, check.count, check.exact) == ("fail", 1, True)
    assert list(report.checks)[0] == "index-range"
    assert "tetrahedron 1: negative" in str(report) and "DEFECTIVE" in repr(report)


def test_the_common_point_of_an_overlap_is_a_fraction(corpus):
    exact = [f.point_exact for f in tetproof.verify(corpus / "bad-meshes/overlap-1e-12.msh").findings]
    exact = [point for point in exact if point]
    assert exact and all(isinstance(number, Fraction) for point in exact for number in point)


def test_neither_true_nor_false(two_tets):
    with pytest.raises(TypeError, match="report.sound"):
        bool(tetproof.verify(*two_tets))
    with pytest.raises(TypeError, match="equal"):
        bool(tetproof.compare(two_tets, two_tets))


def test_no_tetrahedra_are_not_sound(two_tets):
    points, _ = two_tets
    empty = np.empty((0, 4), dtype=int)
    assert tetproof.verify(points, empty).verdict == "incomplete"
    assert tetproof.verify(points, empty, "sphere:r=1,n=500").verdict == "defective"


def test_options(two_tets, inverted):
    assert tetproof.verify(*inverted, check="flat,unused-point").verdict == "sound"
    assert tetproof.verify(*inverted, skip=["inverted"]).checks["inverted"].verdict == "skipped"
    assert "quality" not in tetproof.verify(*two_tets, quality=False).to_dict()
    assert "seconds" in tetproof.verify(*two_tets, timings=True).to_dict()
    regions = tetproof.verify(*two_tets, regions=[5, 7]).to_dict()["regions"]
    assert [region["tag"] for region in regions] == [5, 7]
    assert tetproof.verify(points=two_tets[0], tets=two_tets[1]).sound
    crack = two_tets[0][[0, 1, 2, 3, 1, 2, 3, 4]], np.array([[0, 1, 2, 3], [4, 5, 6, 7]])
    assert tetproof.verify(*crack).checks["crack"].verdict == "fail"
    assert tetproof.verify(*crack, allow="crack").sound


@pytest.mark.parametrize("options, said", [
    ({"fidelity": -1}, "fidelity: expected"), ({"fidelity": float("nan")}, "fidelity: expected"),
    ({"voxels": 5000}, "0 to 1024"), ({"region": "inside"}, "needs a surface"), ({"region": "up"}, "'up'"),
    ({"check": ["no-such-check"]}, "no-such-check"), ({"allow": "inverted"}, "inverted"),
    ({"regions": [1]}, r"\(2,\)"), ({"regions": [0.5, 1]}, "integers"), ({"timeout": -1}, "timeout"),
    ({"threads": 0}, "threads"), ({"surface": "sphere:r=-1"}, "sphere"),
    ({"surface": "no-such.stl"}, "no-such"),
    ({"surface": ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])}, "surface: the surface is open"),
    ({"surface": ([[0, 0, 0]], [[0, 1, 2]])}, "point 1"),
])
def test_bad_options(two_tets, options, said):
    with pytest.raises(tetproof.InputError, match=said):
        tetproof.verify(*two_tets, **options)
    assert issubclass(tetproof.InputError, ValueError)


def test_what_is_missing_or_too_much(two_tets):
    for arguments in [(), (two_tets[0],), (object(),), (two_tets, [[0, 1, 2]], "sphere:r=1")]:
        with pytest.raises(tetproof.InputError):
            tetproof.verify(*arguments)
    with pytest.raises(tetproof.InputError, match="no-such-file.msh"):
        tetproof.verify("no-such-file.msh")


def test_html_is_escaped(tmp_path, corpus):
    name = "<script>alert(1)</script>&"
    text = (corpus / "formats/meshes/two_22_text.msh").read_text().replace("steel part", name)
    (tmp_path / "named.msh").write_text(text)
    assert name in tetproof.read(tmp_path / "named.msh").group_names.values()
    with pytest.warns(tetproof.FileWarning, match="is merged"):
        report = tetproof.verify(tmp_path / "named.msh")
    html = report._repr_html_()
    assert html.startswith("<table") and "<script" not in html
    finding = tetproof.Finding("flat", name, (1, 2), (), (), None, None, {}, ())
    check = tetproof.Check("flat", "fail", True, 5, 2, None, None, (finding,), "")
    report._checks = {"flat": check}
    html = report._repr_html_()
    assert "&lt;script&gt;alert(1)&lt;/script&gt;&amp;" in html and "<script" not in html
    assert "tetrahedra 1, 2" in html and "4 more" in html


def test_junit_and_defects(inverted, tmp_path, program):
    report = tetproof.verify(*inverted)
    assert '<testsuite name="mesh"' in report.to_junit() and 'name="inverted"' in report.to_junit("part")
    tetproof.write(tmp_path / "defects.vtu", report.defects())
    assert len(tetproof.read(tmp_path / "defects.vtu").tets) == 2
    assert len(tetproof.verify(*inverted, check="flat").defects().points) == 0


def test_pages_are_those_of_the_program(inverted, tmp_path, corpus, program):
    mesh = corpus / "formats/meshes/two_41_text.msh"
    page = tmp_path / "page.html"
    for against in ([], ["octahedron", "--fidelity", "0.5"]):
        assert program("tetproof-verify", mesh, *against, "--html", page)[0] in (0, 1, 4)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", tetproof.FileWarning)
            report = tetproof.verify(mesh, *against[:1], fidelity=0.5 if against else 1e-3)
        assert report.to_html(str(mesh)) == page.read_text()
    html = tetproof.verify(*inverted).to_html("</script><b>")
    assert "inverted" in html and "</script><b>" not in html and "&lt;/script&gt;&lt;b&gt;" in html


def test_any_number_of_threads(two_tets):
    surface = tetproof.generate("sphere:r=1,n=500")
    grid = tetproof.mesh(surface, cells=8)
    expected = tetproof.verify(grid, "sphere:r=1,n=500", fidelity=0.1, threads=1).to_json()
    found = []

    def judge():
        found.append(tetproof.verify(grid, surface, fidelity=0.1).to_json())

    threads = [threading.Thread(target=judge) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 6


def test_many_verdicts_take_no_more_memory(inverted):
    def resident():
        return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def judge(times):
        for _ in range(times):
            tetproof.verify(*inverted)
        gc.collect()
        return resident()

    judge(100)
    before = resident()
    assert judge(600) - before < 2e6  # 3 kB each


def test_after_a_fork():
    grid = tetproof.mesh("sphere:r=1,n=500", cells=8)
    expected = tetproof.verify(grid).to_json()
    with multiprocessing.get_context("fork").Pool(1) as pool:
        assert pool.apply_async(_json, (grid,)).get(60) == expected


def _json(grid):
    return tetproof.verify(grid).to_json()


@pytest.mark.parametrize("mxcsr", [0x4000, 0x8040], ids=["rounding upwards", "denormals are zero"])
def test_another_librarys_arithmetic_does_not_matter(mxcsr, two_tets):
    if os.uname().machine != "x86_64":
        pytest.skip(f"the control word of {os.uname().machine} is another one")
    libm, usual, changed = ctypes.CDLL("libm.so.6"), (ctypes.c_uint32 * 8)(), (ctypes.c_uint32 * 8)()
    grid = tetproof.mesh("sphere:r=1,n=500", cells=8)
    tiny = two_tets[0] * 5e-310, two_tets[1]

    def judge():
        reports = tetproof.verify(grid, "sphere:r=1,n=500", fidelity=0.1), tetproof.verify(*tiny)
        return [report.to_json() for report in reports]

    expected = judge()
    assert tetproof.verify(*tiny).sound
    libm.fegetenv(usual)
    libm.fegetenv(changed)
    changed[7] |= mxcsr
    libm.fesetenv(changed)
    try:
        found = judge()
        libm.fegetenv(changed)
    finally:
        libm.fesetenv(usual)
    assert found == expected
    assert changed[7] & mxcsr == mxcsr  # it is the other library's again


def test_timeout_and_interrupt():
    grid = tetproof.mesh("sphere:r=1,n=2000", cells=24)
    with pytest.raises(TimeoutError):
        tetproof.verify(grid, "sphere:r=1,n=2000", timeout=0.0)
    threading.Timer(0.02, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        while True:
            tetproof.verify(grid, "sphere:r=1,n=2000", fidelity=0.1)
    assert tetproof.verify(grid, "sphere:r=1,n=2000", fidelity=0.1).sound


def test_lists():
    assert "hanging-node" in tetproof.list_checks() and "torus" in tetproof.list_surfaces()
    assert json.loads(tetproof.verify([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]]).to_json())


@pytest.mark.parametrize("option", [{"voxels": 3.7}, {"voxels": "many"}, {"threads": 2.5}, {"fidelity": "0.1"},
                                    {"timeout": "soon"}, {"fidelity": None}])
def test_options_of_another_kind_are_input_errors(two_tets, option):
    with pytest.raises(tetproof.InputError, match=f"{next(iter(option))}: expected a (whole )?number, found "):
        tetproof.verify(*two_tets, **option)


@pytest.mark.parametrize("option", [{"box_scale": "a"}, {"diagonals": 3}, {"points": 10**30}, {"v0": None}, {"region": None},
                                    {"p": []}, {"engine": b"fast"}])
def test_options_of_the_mesher_are_named(option):
    with pytest.raises(tetproof.InputError, match=f"{next(iter(option))}: expected a "):
        tetproof.mesh("sphere:r=1,n=100", cells=6, **option)


def test_options_of_random_surfaces():
    assert tetproof.fuzz(1, 2, kinds="star").name == tetproof.fuzz(1, 2, kinds=["star"]).name
    for most in (-5, 2.5, 2**40):
        with pytest.raises(tetproof.InputError, match="most_triangles: expected a"):
            tetproof.fuzz(1, 2, most_triangles=most)


def test_more_threads_than_there_are(two_tets, capfd):
    """oneTBB warns of many, and crashes on very many."""
    for threads in (10**6, 2**31 - 1, 10**30, np.int8(2)):
        assert tetproof.verify(*two_tets, threads=threads).sound
    assert capfd.readouterr() == ("", "")


def test_a_report_says_why_it_is_not_pickled(two_tets):
    for take in (pickle.dumps, copy.deepcopy):
        with pytest.raises(TypeError, match="report.to_dict"):
            take(tetproof.verify(*two_tets))


def test_help_tells_of_everything():
    """Each name and each method has a text of its own."""
    for name in tetproof.__all__:
        thing = getattr(tetproof, name)
        assert thing.__doc__ and not thing.__doc__.startswith("Inappropriate argument"), name
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert value.__doc__, f"{name}.{member}"
