"""Calls whose memory must not grow: run by hand, `python tests/leaks.py [millions of calls]`."""

import resource
import sys

import numpy as np

import denhart

arm = denhart.Arm.preset("ur5")
q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
pose = arm.forward(q)
bad = np.eye(3)


def resident():
    return int(open("/proc/self/statm").read().split()[1]) * resource.getpagesize() // 1024


def calls(count):
    for _ in range(count):
        arm.forward(q)
        solutions = arm.inverse(pose)
        solutions[0].q
        arm.inverse(pose, near=q).q
        arm.jacobian(q)
        try:
            arm.inverse(bad)
        except ValueError:
            pass


calls(10_000)
before = resident()
total = int(float(sys.argv[1]) * 1e6 / 5) if len(sys.argv) > 1 else 200_000
calls(total)
print(f"{5 * total} calls: {resident() - before} KiB more")
