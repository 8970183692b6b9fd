"""The examples of the pages do what the pages say."""

import doctest
import json
import re

import pytest

from conftest import ROOT


@pytest.mark.parametrize("page", ["docs/python.md", "python/README.md"])
def test_examples(page):
    text = (ROOT / page).read_text()
    examples = "\n".join(re.findall(r"^```pycon\n(.*?)^```", text, re.DOTALL | re.MULTILINE))
    assert examples
    test = doctest.DocTestParser().get_doctest(examples, {}, page, page, 0)
    report = []
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    runner.run(test, out=report.append)
    assert not runner.failures, "".join(report)


def test_the_tour(capsys):
    cells = json.loads((ROOT / "python" / "tour.ipynb").read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] == "code":
            exec("".join(cell["source"]), names)
    assert "largest step" in capsys.readouterr().out
