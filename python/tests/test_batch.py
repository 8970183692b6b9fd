"""Batches: the results of single calls, whatever the threads, into arrays of the user."""

import multiprocessing
import os
import resource
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import denhart
from conftest import joint_vectors
from denhart import Status


def same_as_single_calls(arm, targets, batch, **options):
    for index, target in enumerate(targets):
        chosen = {key: value[index] if np.ndim(value) > 1 else value for key, value in options.items()}
        solutions = arm.inverse(target, **chosen)
        count = batch.count[index]
        assert count == len(solutions) and batch.status[index] == solutions.status
        np.testing.assert_array_equal(batch.q[index, :count], solutions.q)
        np.testing.assert_array_equal(batch.deviation[index], solutions.deviation)
        assert np.isnan(batch.q[index, count:]).all() and (batch.flags[index, count:] == 0).all()
        assert batch.flags[index, :count].tolist() == [int(solution.flags) for solution in solutions]


@pytest.mark.parametrize("threads", [1, 2, 5, None])
def test_a_batch_is_its_targets_one_by_one(ur5, threads):
    q = joint_vectors(ur5, 333)
    poses = ur5.forward_batch(q, threads=threads)
    np.testing.assert_array_equal(poses, ur5.forward(q))
    np.testing.assert_array_equal(ur5.jacobian_batch(q, threads=threads), ur5.jacobian(q))
    poses[5, 0, 3] += 9.0
    poses[6, 1, 1] = np.nan
    poses[7] = np.nan
    poses[8, :3, :3] *= 1.0 + 1e-5
    batch = ur5.inverse_batch(poses, threads=threads)
    assert batch.q.shape == (333, 8, 6) and batch.q.dtype == np.float64 and len(batch) == 333
    assert (batch.count.dtype, batch.flags.dtype, batch.status.dtype) == (np.int64, np.uint8, np.uint8)
    assert batch.status[4:8].tolist() == [Status.REACHABLE, Status.UNREACHABLE, Status.BAD_TARGET, Status.BAD_TARGET]
    same_as_single_calls(ur5, poses, batch)
    same_as_single_calls(ur5, poses, ur5.inverse_batch(poses, near=q[0], threads=threads), near=q[0])
    same_as_single_calls(ur5, poses, ur5.inverse_batch(poses, near=q, threads=threads), near=q)
    assert 1e-5 < batch.deviation[8] < 2e-5 and batch.deviation[9] < 1e-12
    assert repr(batch) == "<InverseBatch: q (333, 8, 6), 330 of 333 targets reached; count, flags, status, deviation>"


@pytest.mark.parametrize("name", ["anthro3r", "planar2r", "planar3r", "kuka_youbot", "al5d", "scorbot_er5", "kinova_jaco"])
def test_every_task(name):
    arm = denhart.Arm.preset(name)
    q = joint_vectors(arm, 70)
    targets = np.array([arm.target_at(row).values for row in q])
    batch = arm.inverse_batch(targets)
    same_as_single_calls(arm, targets, batch)
    if arm.task not in ("pose", "position_angle"):
        poses = arm.forward(q)
        same_as_single_calls(arm, poses, arm.inverse_batch(poses))


ARMS = ["ur5", "puma560", "franka_panda", "scara_rrrp_325_275", "planar4r_redundant", "stanford", "kinova_jaco", "cylindrical_rpp"]


@pytest.mark.parametrize("name", ARMS)
@pytest.mark.parametrize("rows", [0, 1, 7, 8, 33, 1100])
def test_poses_and_jacobians_of_rows_are_those_one_by_one(name, rows):
    arm = denhart.Arm.preset(name)
    q = joint_vectors(arm, rows)
    if rows:
        q[rows // 2] *= 1e6
        q[-1, -1] = np.nan
    poses = np.array([arm.forward(row) for row in q]).reshape(-1, 4, 4)
    jacobians = np.array([arm.jacobian(row) for row in q]).reshape(-1, 6, arm.dof)
    for found in [arm.forward(q), arm.forward_batch(q), arm.forward_batch(q, threads=2)]:
        assert found.tobytes() == poses.tobytes()
    for found in [arm.jacobian(q), arm.jacobian_batch(q), arm.jacobian_batch(q, threads=2)]:
        assert found.tobytes() == jacobians.tobytes()


def test_targets_that_lanes_doubt(ur5):
    # Singular poses, drifted ones, the edge of reach, and ordinary ones between them, over several jobs of a thread.
    q = joint_vectors(ur5, 1300)
    q[::3] = np.round(q[::3] * 4 / np.pi) * np.pi / 4
    q[1::7, 2] = 0.0
    poses = ur5.forward(q)
    poses[2::11, :3, :3] += 1e-6
    poses[5::40] = np.nan
    poses[6::40, 3, 3] = np.inf
    same_as_single_calls(ur5, poses, ur5.inverse_batch(poses, threads=2))


@pytest.mark.parametrize("name", ["puma560", "abb_irb120", "mecademic_meca500"])
def test_dropped_solutions_leave_no_gap(name):
    arm = denhart.Arm.preset(name)
    targets = np.array([arm.target_at(row).values for row in joint_vectors(arm, 600)])
    batch = arm.inverse_batch(targets, limits="drop")
    assert (batch.count < arm.inverse_batch(targets).count).any()
    same_as_single_calls(arm, targets, batch, limits="drop")


def test_redundant_joints(panda):
    q = joint_vectors(panda, 100)
    poses = panda.forward(q)
    same_as_single_calls(panda, poses, panda.inverse_batch(poses, given=0.3), given=0.3)
    each = panda.inverse_batch(poses, given=q[:, 6])
    same_as_single_calls(panda, poses, each, given=q[:, 6:])
    np.testing.assert_array_equal(panda.inverse_batch(poses, given=q[:, 6:]).q, each.q)
    same_as_single_calls(panda, poses, panda.inverse_batch(poses, near=q), near=q)
    with pytest.raises(ValueError, match="the target leaves q7 to choose"):
        panda.inverse_batch(poses)
    with pytest.raises(ValueError, match="near= has these values already"):
        panda.inverse_batch(poses, near=q, given=0.3)
    with pytest.raises(ValueError, match=r"given: expected the values of q7, found shape \(3,\)"):
        panda.inverse_batch(poses, given=q[:3, 6])


def test_limits_drop():
    arm = denhart.Arm.preset("puma560")
    poses = arm.forward(joint_vectors(arm, 64))
    same_as_single_calls(arm, poses, arm.inverse_batch(poses, limits="drop"), limits="drop")


def test_out(ur5):
    q = joint_vectors(ur5, 100)
    poses = np.full((100, 4, 4), 7.0)
    assert ur5.forward_batch(q, out=poses) is poses
    np.testing.assert_array_equal(poses, ur5.forward(q))
    into = np.empty((100, 8, 6))
    batch = ur5.inverse_batch(poses, out=into)
    assert batch.q is into
    np.testing.assert_array_equal(into, ur5.inverse_batch(poses).q)
    for wrong, message in [
        (np.empty((100, 8, 5)), r"expected .* shape \(100, 8, 6\), found float64 with shape \(100, 8, 5\)"),
        (np.empty((100, 8, 6), np.float32), "found float32"),
        (np.empty((100, 8, 6), order="F"), "another order"),
        (np.empty((100, 16, 6))[:, ::2], "gaps"),
        ([1.0, 2.0], "found list"),
        (into.T, "found float64"),
    ]:
        with pytest.raises(ValueError, match=f"out: .*{message}"):
            ur5.inverse_batch(poses, out=wrong)
    into.setflags(write=False)
    with pytest.raises(ValueError, match="read-only"):
        ur5.inverse_batch(poses, out=into)
    both = np.zeros(100 * 48)
    both[: 100 * 16] = poses.ravel()
    with pytest.raises(ValueError, match="overlaps"):
        ur5.inverse_batch(both[: 100 * 16].reshape(100, 4, 4), out=both.reshape(100, 8, 6))


def test_empty(ur5):
    batch = ur5.inverse_batch(np.empty((0, 4, 4)))
    assert batch.q.shape == (0, 8, 6) and batch.count.shape == (0,) and len(batch) == 0
    assert ur5.forward(np.empty((0, 6))).shape == (0, 4, 4)
    assert ur5.forward_batch(np.empty((0, 6)), threads=3).shape == (0, 4, 4)
    assert ur5.jacobian_batch(np.empty((0, 6))).shape == (0, 6, 6)


def test_wrong_targets(ur5):
    poses = ur5.forward(joint_vectors(ur5, 10))
    poses[3] = poses[3].T
    with pytest.raises(ValueError, match=r"targets\[3\]: the last row of a pose is \[0, 0, 0, 1\]"):
        ur5.inverse_batch(poses)
    with pytest.raises(ValueError, match=r"expected shape \(N, 4, 4\), found \(4, 4\)"):
        ur5.inverse_batch(np.eye(4))
    with pytest.raises(ValueError, match=r"near: expected shape \(6,\) or \(10, 6\), found \(9, 6\)"):
        ur5.inverse_batch(ur5.forward(np.zeros((10, 6))), near=np.zeros((9, 6)))
    for threads in [0, -1]:
        with pytest.raises(ValueError, match=f"threads: expected a number from 1, .*found {threads}"):
            ur5.inverse_batch(np.empty((0, 4, 4)), threads=threads)


def test_other_threads_of_python_go_on(ur5):
    poses = np.tile(ur5.forward(np.full(6, 0.3)), (100_000, 1, 1))
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=tick)
    thread.start()
    start = time.perf_counter()
    ur5.inverse_batch(poses, threads=1)
    end = time.perf_counter()
    done.set()
    thread.join()
    assert sum(start < tick < end for tick in ticks) > 5


def test_a_forked_process_solves_batches(ur5):
    # A pool of threads made before would not live in the child.
    ur5.inverse_batch(ur5.forward(np.full((1000, 6), 0.3)), threads=2)
    child = os.fork()
    if child == 0:
        batch = ur5.inverse_batch(ur5.forward(np.full((1000, 6), 0.3)), threads=2)
        os._exit(0 if (batch.count == 8).all() else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_processes_share_work(ur5):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        batch = pool.apply(ur5.inverse_batch, (np.tile(ur5.forward(np.full(6, 0.3)), (5, 1, 1)),))
    assert (batch.count == 8).all()


@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c(ur5, threads):
    # Seconds of work, which end within a fraction of one.
    poses = np.tile(ur5.forward(np.full(6, 0.3)), (200_000, 1, 1))
    out = np.empty((200_000, 8, 6))
    notes: list[str] = []
    for _ in range(20):
        timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
        start = time.perf_counter()
        timer.start()
        with pytest.raises(KeyboardInterrupt) as caught:
            while time.perf_counter() - start < 5.0:
                ur5.inverse_batch(poses, threads=threads, out=out)
        assert time.perf_counter() - start < 2.0
        notes = getattr(caught.value, "__notes__", [])
        # A signal between two calls finds nothing half written: again.
        if notes:
            break
    assert notes == ["some rows of out= are written, others are not"]
    # The array is free again.
    ur5.inverse_batch(poses[:10], out=out[:10])


SHORT = """
import resource, numpy, denhart
arm = denhart.Arm.preset("ur5")
q = numpy.zeros((300_000, 6))
poses = arm.forward(q[:100_000])
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 20_000_000, resource.RLIM_INFINITY))
for call in [lambda: arm.forward(q), lambda: arm.jacobian_batch(q), lambda: arm.inverse_batch(poses)]:
    try:
        call()
    except MemoryError:
        print("MemoryError")
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="needs RLIMIT_AS")
def test_memory_that_is_short_is_a_memory_error():
    assert resource.getrlimit(resource.RLIMIT_AS)
    ran = subprocess.run([sys.executable, "-c", SHORT], capture_output=True, text=True, check=False)
    assert ran.stdout.split() == ["MemoryError"] * 3, ran.stderr


# Memory for the results, and no more than a little beside it: fewer threads, or MemoryError, but no end of the process.
NEARLY_SHORT = """
import resource
import numpy as np
import denhart
arm = denhart.Arm.preset("ur5")
poses = arm.forward_batch(np.random.default_rng(0).uniform(-3, 3, (20_000, 6)), threads=1)
out = np.empty((20_000, 8, 6))
expected = arm.inverse_batch(poses, threads=1).q
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
for spare in range(0, 24_000, 100):
    resource.setrlimit(resource.RLIMIT_AS, (used + (spare << 10), resource.RLIM_INFINITY))
    try:
        assert np.array_equal(arm.inverse_batch(poses, threads=4, out=out).q, expected, equal_nan=True)
    except MemoryError:
        pass
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
print("alive")
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="RLIMIT_AS and /proc of Linux")
def test_memory_that_is_nearly_short_ends_no_process():
    for _ in range(3):
        ran = subprocess.run([sys.executable, "-c", NEARLY_SHORT], capture_output=True, text=True, check=False)
        assert ran.stdout.split() == ["alive"], (ran.returncode, ran.stderr)


def test_poses_of_scipy_and_transposed_ones(ur5):
    poses = ur5.forward(joint_vectors(ur5, 5))

    class Poses:
        def as_matrix(self):
            return poses

    np.testing.assert_array_equal(ur5.inverse_batch(Poses()).q, ur5.inverse_batch(poses).q)
    transposed = r"targets\[0\]: .*seems to be transposed: write targets.transpose\(0, 2, 1\) if all are"
    with pytest.raises(ValueError, match=transposed):
        ur5.inverse_batch(poses.transpose(0, 2, 1))
