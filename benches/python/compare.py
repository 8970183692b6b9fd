"""denhart beside other packages on a UR5, in one process: times of single calls and batches, and the solutions found.

    pip install ./python -r benches/python/requirements.txt
    python benches/python/compare.py

Packages that are not installed are left out. Each time is the least of several runs that take turns, so that a busy
machine troubles all alike. Prints the tables of docs/python.md.
"""

import datetime
import importlib.metadata
import os
import platform
import time

import numpy as np

import denhart

A = np.array([0, -0.425, -0.39225, 0, 0, 0])
ALPHA = np.array([np.pi / 2, 0, 0, np.pi / 2, -np.pi / 2, 0])
D = np.array([0.089159, 0, 0, 0.10915, 0.09465, 0.0823])
ROUNDS = 15
# One round of a package takes about so long, s.
ROUND = 0.02
SOLVED = 500
BATCH = 100_000
# The batches of packages that loop in Python are smaller: the time is one of a pose.
SMALL_BATCH = 1_000


class Denhart:
    package = "denhart"

    def __init__(self):
        self.arm = denhart.Arm.from_dh(a=A, alpha=ALPHA, d=D, name="ur5")
        self.forward = self.arm.forward

    def inverse(self, pose):
        return self.arm.inverse(pose).q

    def batch(self, poses):
        out = np.empty((len(poses), self.arm.max_solutions, self.arm.dof))
        return BATCH, lambda: self.arm.inverse_batch(poses, threads=1, out=out)


class Eaik:
    package = "eaik"

    def __init__(self):
        from eaik.IK_DH import DhRobot

        self.robot = DhRobot(ALPHA, A, D)
        self.forward = self.robot.fwdKin

    def inverse(self, pose):
        return self.robot.IK(pose).Q

    def batch(self, poses):
        return BATCH, lambda: self.robot.IK_batched(poses, num_worker_threads=1)


class Ssik:
    package = "ssik"

    def __init__(self):
        import ssik

        # The solver that is made for this arm before; that of a table takes milliseconds. Its base and flange are turned.
        self.arm = ssik.Manipulator.from_prebuilt("ur5")
        self.base = np.diag([-1.0, -1.0, 1.0, 1.0])
        self.tool = np.eye(4)
        self.tool[:3, :3] = [[0, -1, 0], [0, 0, -1], [1, 0, 0]]

    def forward(self, q):
        return self.base @ self.arm.fk(q) @ self.tool.T

    def solve(self, pose):
        # Turns by 2 pi are no solutions of their own elsewhere.
        found = self.arm.solve(self.base @ pose @ self.tool, respect_limits=False, enumerate_windings=False)
        return [solution.q for solution in found]

    inverse = solve

    def batch(self, poses):
        return SMALL_BATCH, lambda: [self.solve(pose) for pose in poses]


class IkGeo:
    package = "py-ikgeo-kinematics"

    def __init__(self):
        from py_ikgeo_kinematics import KinematicModel, Robot
        from scipy.spatial.transform import RigidTransform

        self.transform = RigidTransform.from_matrix
        # Axes and the points between them at joint values of zero; the model's flange is not turned there.
        frame, axes, points = np.eye(4), [], [np.zeros(3)]
        for a, alpha, d in zip(A, ALPHA, D):
            axes.append(frame[:3, 2])
            cos, sin = np.cos(alpha), np.sin(alpha)
            frame = frame @ [[1, 0, 0, a], [0, cos, -sin, 0], [0, sin, cos, d], [0, 0, 0, 1]]
            points.append(frame[:3, 3])
        # The first point lies on the first axis at the base.
        offsets = np.diff(np.array(points), axis=0)
        offsets = np.vstack([np.zeros(3), offsets])
        self.robot = Robot(KinematicModel(np.array(axes).T, offsets.T), degrees=False)
        self.tool = np.eye(4)
        self.tool[:3, :3] = frame[:3, :3]

    def forward(self, q):
        return self.robot.forward(q).as_matrix() @ self.tool

    def inverse(self, pose):
        return self.robot.inverse(self.transform(pose @ self.tool.T))

    def batch(self, poses):
        turned = self.transform(poses @ self.tool.T)
        return BATCH, lambda: self.robot.batch_inverse(turned)


class Toolbox:
    package = "roboticstoolbox-python"

    def __init__(self):
        from roboticstoolbox import DHRobot, RevoluteDH
        # Its part in C.
        self.robot = DHRobot([RevoluteDH(a=a, alpha=alpha, d=d) for a, alpha, d in zip(A, ALPHA, D)]).ets()
        self.forward = self.robot.eval

    def inverse(self, pose):
        # By iteration: one solution.
        found = self.robot.ik_LM(pose, tol=1e-14)
        return [found.q] if found.success else []

    def batch(self, poses):
        return SMALL_BATCH, lambda: [self.inverse(pose) for pose in poses]


def least(calls):
    """The least time of each call, s. They take turns, each as often as fits into a round."""
    best, often = dict.fromkeys(calls, np.inf), dict.fromkeys(calls, 1)
    for _ in range(ROUNDS):
        for name, call in calls.items():
            start = time.perf_counter()
            for _ in range(often[name]):
                call()
            best[name] = min(best[name], (time.perf_counter() - start) / often[name])
            often[name] = max(1, round(ROUND / best[name]))
    return best


def found(package, poses, arm):
    """Solutions that stand alone and reach their pose, and poses with any solution.

    At a singular pose a solution is one of infinitely many, and packages list any number of them.
    """
    alone, solved = 0, 0
    for pose in poses:
        reached = [q for q in map(np.asarray, package.inverse(pose)) if np.abs(arm.forward(q) - pose).max() < 1e-6]
        solved += len(reached) > 0
        alone += sum(np.linalg.svd(arm.jacobian(q), compute_uv=False)[-1] > 1e-6 for q in reached)
    return f"{alone} ({solved})"


def installed():
    for kind in [Denhart, Eaik, Ssik, IkGeo, Toolbox]:
        try:
            yield kind()
        except ImportError as error:
            print(f"left out: {kind.package}: {error}")


def main():
    packages = list(installed())
    forward = packages[0].forward
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    pose = forward(q)
    for package in packages:
        assert np.abs(package.forward(q) - pose).max() < 1e-9, package.package
    rng = np.random.default_rng(0)
    families = [
        ("random", rng.uniform(-np.pi, np.pi, (SOLVED, 6))),
        ("30 degrees", np.deg2rad(30) * rng.integers(-5, 7, (SOLVED, 6))),
    ]
    columns = []
    times = least({package: lambda package=package: package.forward(q) for package in packages})
    columns.append(("`forward`", {package: f"{time * 1e6:.2f} us" for package, time in times.items()}))
    times = least({package: lambda package=package: package.inverse(pose) for package in packages})
    columns.append(("every solution", {package: f"{time * 1e6:.2f} us" for package, time in times.items()}))
    cells = {}
    for package in packages:
        poses = forward(rng.uniform(-np.pi, np.pi, (BATCH, 6)))
        count, _ = package.batch(poses[:1])
        _, call = package.batch(poses[:count])
        cells[package] = f"{min(timed(call) for _ in range(3)) / count * 1e6:.2f} us"
    columns.append(("batch, a pose", cells))
    for title, vectors in families:
        poses = [forward(q) for q in vectors]
        columns.append((f"found, {title}", {package: found(package, poses, packages[0].arm) for package in packages}))

    print(f"\n{datetime.date.today()}, {processor()}, Python {platform.python_version()}, numpy {np.__version__}\n")
    print("| package |", *(f"{title} |" for title, _ in columns))
    print("|---|" + "---|" * len(columns))
    for package in packages:
        version = importlib.metadata.version(package.package)
        print(f"| {package.package} {version} |", *(f"{cells[package]} |" for _, cells in columns))
    threads(packages[0].arm, forward(rng.uniform(-np.pi, np.pi, (BATCH, 6))))


def threads(arm, poses):
    """Batches on one thread and on two."""
    out = np.empty((len(poses), arm.max_solutions, arm.dof))
    times = least({count: lambda count=count: arm.inverse_batch(poses, threads=count, out=out) for count in (1, 2)})
    print(f"\nbatch of {len(poses)}: two threads {times[1] / times[2]:.2f} x as fast as one, {os.cpu_count()} processors")


def timed(call):
    start = time.perf_counter()
    call()
    return time.perf_counter() - start


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor()


if __name__ == "__main__":
    main()
