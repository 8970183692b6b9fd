"""Times of denhart beside EAIK on a UR5, in one process: single calls and batches, and how many solutions are found.

    pip install ./python eaik==1.2.2
    python benches/python/compare.py

Each number is the least of several runs that take turns, so that a busy machine troubles all alike.
"""

import time

import numpy as np

import denhart

A = [0, -0.425, -0.39225, 0, 0, 0]
ALPHA = [np.pi / 2, 0, 0, np.pi / 2, -np.pi / 2, 0]
D = [0.089159, 0, 0, 0.10915, 0.09465, 0.0823]
ROUNDS = 15
CALLS = 5_000
POSES = 100_000


def least(calls, times):
    """The least time of each call, us; they take turns."""
    best = dict.fromkeys(calls, np.inf)
    for _ in range(ROUNDS):
        for name, call in calls.items():
            start = time.perf_counter()
            for _ in range(times):
                call()
            best[name] = min(best[name], (time.perf_counter() - start) / times * 1e6)
    return best


def found(inverse, forward, poses):
    """Joint vectors found that reach their pose."""
    return sum(np.abs(forward(q) - pose).max() < 1e-6 for pose in poses for q in inverse(pose))


def main():
    arm = denhart.Arm.from_dh(a=A, alpha=ALPHA, d=D, name="ur5")
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    pose = arm.forward(q)
    forward, inverse = {"denhart": lambda: arm.forward(q)}, {"denhart": lambda: arm.inverse(pose).q}
    solvers = {"denhart": lambda pose: arm.inverse(pose).q}
    try:
        from eaik.IK_DH import DhRobot
    except ImportError:
        print("eaik is not installed")
    else:
        peer = DhRobot(np.array(ALPHA), np.array(A), np.array(D))
        forward["eaik"], inverse["eaik"] = lambda: peer.fwdKin(q), lambda: peer.IK(pose).Q
        solvers["eaik"] = lambda pose: peer.IK(pose).Q

    for title, calls in [("forward", forward), ("inverse", inverse)]:
        times = least(calls, CALLS)
        print(f"{title:8}", *(f"{name} {time:.2f} us" for name, time in times.items()), sep="  ")
    rng = np.random.default_rng(0)
    grid = np.deg2rad(30) * rng.integers(-5, 7, (500, 6))
    for title, vectors in [("random", rng.uniform(-np.pi, np.pi, (500, 6))), ("grid", grid)]:
        poses = arm.forward(vectors)
        counts = {name: found(solve, arm.forward, poses) for name, solve in solvers.items()}
        print(f"{title:8}", *(f"{name} {count} solutions" for name, count in counts.items()), sep="  ")

    poses = arm.forward(rng.uniform(-np.pi, np.pi, (POSES, 6)))
    out = np.empty((POSES, arm.max_solutions, arm.dof))
    batches = {f"{threads} thread(s)": lambda threads=threads: arm.inverse_batch(poses, threads=threads, out=out) for threads in (1, 2)}
    print("batch   ", *(f"{name} {time / POSES:.2f} us a pose" for name, time in least(batches, 1).items()), sep="  ")


if __name__ == "__main__":
    main()
