"""What the tests share."""

import os
from pathlib import Path

import numpy as np
import pytest

import denhart

# The root of the repository, or what check.sh has copied of it.
ROOT = Path(os.environ.get("DENHART_ROOT", Path(__file__).parents[2]))
SPECS = ROOT / "specs"


@pytest.fixture(scope="session")
def ur5():
    return denhart.Arm.preset("ur5")


@pytest.fixture(scope="session")
def panda():
    return denhart.Arm.preset("franka_panda")


def joint_vectors(arm, count, seed=1):
    """Random joint vectors within the limits, (count, n)."""
    low, high = arm.limits.T
    slides = np.array(arm.joint_kinds) == "prismatic"
    low = np.where(np.isfinite(low), low, np.where(slides, 0.0, -3.0))
    high = np.where(np.isfinite(high), high, np.where(slides, 0.5, 3.0))
    return np.random.default_rng(seed).uniform(low, high, (count, arm.dof))
