# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples of the package's page, and that every public name has a docstring."""
import doctest
import inspect

import tetproof
import tetproof.testing


def test_the_examples_of_the_page(corpus, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = doctest.testfile(str(corpus.parent / "verify/python/README.md"), module_relative=False)
    assert found.attempted > 10 and found.failed == 0


def test_every_public_name_says_what_it_is():
    for name in tetproof.__all__:
        thing = getattr(tetproof, name)
        assert inspect.getdoc(thing), name
