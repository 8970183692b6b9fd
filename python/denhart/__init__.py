"""Kinematics of robot arms from Denavit-Hartenberg tables.

    >>> import denhart
    >>> arm = denhart.Arm.preset("ur5")
    >>> arm.forward([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])     # pose of the tool, (4, 4)
    >>> arm.inverse(target)                                # every joint vector that reaches it

Angles are rad where a name does not say degrees; lengths are in `arm.length_unit`. Start with `help(denhart.Arm)`.
"""

from collections.abc import Sequence

from ._denhart import (
    Arm,
    Follower,
    InverseBatch,
    Motion,
    NumericSolution,
    Obstacle,
    Picture,
    Solution,
    Solutions,
    Step,
    Target,
)
from ._names import ArmError, Flags, Status

Sequence.register(Solutions)
del Sequence

__all__ = [
    "Arm",
    "ArmError",
    "Flags",
    "Follower",
    "InverseBatch",
    "Motion",
    "NumericSolution",
    "Obstacle",
    "Picture",
    "Solution",
    "Solutions",
    "Status",
    "Step",
    "Target",
]
