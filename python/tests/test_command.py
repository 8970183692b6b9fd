"""Results are those of the command `denhart`, to the bit, on every arm file.

The command is the one that DENHART names; without it the tests are skipped.
"""

import json
import os
import subprocess

import numpy as np
import pytest

import denhart
from conftest import SPECS, joint_vectors

COMMAND = os.environ.get("DENHART")


def run(*arguments):
    ran = subprocess.run([COMMAND, *arguments], capture_output=True, text=True, check=False)
    assert ran.stdout, ran.stderr
    return json.loads(ran.stdout)


@pytest.mark.skipif(not COMMAND, reason="DENHART names no command")
@pytest.mark.parametrize("name", denhart.Arm.presets())
def test_forward_and_inverse(name):
    path = SPECS / f"{name}.yaml"
    arm = denhart.Arm.from_file(path)
    for q in joint_vectors(arm, 3, seed=11):
        text = f"--q={','.join(map(repr, q.tolist()))}"
        pose = run("forward", path, text, "--units", "rad", "--json")["pose"]["matrix"]
        np.testing.assert_array_equal(arm.forward(q), pose)
        if arm.task is None:
            continue
        answer = run("inverse", path, text, "--units", "rad", "--json")
        given = answer["given"]
        solutions = arm.inverse(arm.target_at(q), given=given if arm.given else None)
        np.testing.assert_array_equal(solutions.q, np.reshape([one["q"] for one in answer["solutions"]], (-1, arm.dof)))
        for mine, other in zip(solutions, answer["solutions"], strict=True):
            assert mine.branch == other["branch"]
            assert {flag.name for flag in mine.flags} == set(other["flags"])
            assert [joint + 1 for joint in mine.free] == other["free"]
            assert mine.is_within_limits == other["within_limits"]
