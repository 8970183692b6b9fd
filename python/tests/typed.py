"""Uses of the package that mypy reads, and nothing runs."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation  # type: ignore[import-untyped]

import denhart

arm: denhart.Arm = denhart.Arm.from_dh(a=[0.3, 0.2], alpha=np.zeros(2), d=[0, 0], limits=[(-1.0, 1.0), None])
pose: NDArray[np.float64] = arm.forward([0.1, 0.2])
solutions: denhart.Solutions = arm.inverse((0.1, 0.2), near=[0, 0], limits="drop")
arm.inverse((Rotation.identity(), [0.1, 0.2, 0.3]))
arm.inverse(denhart.Target.planar_position(0.1, 0.2))
first: denhart.Solution = solutions[0]
rest: list[denhart.Solution] = solutions[1:]
exact: bool = denhart.Flags.EXACT in first.flags and solutions.status is denhart.Status.REACHABLE
batch: denhart.InverseBatch = arm.inverse_batch(np.zeros((5, 2)), threads=2, out=np.empty((5, 2, 2)))
reached: NDArray[np.bool_] = batch.status == denhart.Status.REACHABLE
for value, found in arm.sweep(pose, 5):
    print(value + 1.0, found.why(), [solution.q for solution in found])
motion: denhart.Motion = arm.follow(np.zeros((2, 2)), 0.01, times=[0, 1], keep="time", max_velocity=[1.0, 1.0])
follower: denhart.Follower = arm.follower([0.1, 0.2], 0.01, max_velocity=np.ones(2), crossing="any")
step: denhart.Step = follower.step([0.2, 0.3])
gone: float = step.q.max() + step.remaining + follower.stop().velocity.max() + step.residual[0]
obstacle: denhart.Obstacle | None = motion.obstacle
farthest: float = motion.off_position.max() + motion.duration + (obstacle.at if obstacle else 0.0)
