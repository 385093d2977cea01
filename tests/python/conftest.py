# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests share: the programs of the build, files of the corpus, small meshes."""
import json
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["TETPROOF_BUILD"])


@pytest.fixture
def corpus():
    return SOURCE / "corpus"


@pytest.fixture
def program():
    """Runs a program of the build: exit code, standard output, standard error."""
    def run(name, *arguments):
        done = subprocess.run([str(BUILD / name), *map(str, arguments)], capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr
    return run


@pytest.fixture
def judged_by_program(program):
    """The report of tetproof-verify as a dictionary."""
    def judge(*arguments):
        code, out, error = program("tetproof-verify", *arguments, "--json", "-")
        assert code in (0, 1, 4), error
        return json.loads(out)
    return judge


@pytest.fixture
def said_by_pytest(tmp_path):
    """Runs pytest on a file with this text: exit code, standard output."""
    def run(text):
        (tmp_path / "test_mesher.py").write_text(text)
        done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)],
                              capture_output=True, text=True)
        return done.returncode, done.stdout
    return run


@pytest.fixture
def two_tets():
    """Two tetrahedra with a common face: sound."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    return points, np.array([[0, 1, 2, 3], [1, 2, 3, 4]])


@pytest.fixture
def inverted(two_tets):
    """The same, the second tetrahedron turned inside out."""
    points, tets = two_tets
    return points, np.array([tets[0], tets[1][::-1][[0, 1, 3, 2]]])
