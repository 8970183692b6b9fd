"""Motions along a path: the path or its times kept, obstacles, and what is refused."""

import json
import os
import pickle
import signal
import subprocess
import threading

import numpy as np
import pytest

import denhart
from conftest import SPECS

COMMAND = os.environ.get("DENHART")
VELOCITY = np.full(6, np.pi)
ACCELERATION = np.full(6, 5 * np.pi)
RATES = {"max_velocity": VELOCITY, "max_acceleration": ACCELERATION}
TIMES = np.arange(9) * 0.25


def line(far=0.0):
    """A line of 0.4 m before the base; with `far` it leads out of reach."""
    poses = np.tile(np.diag([1.0, -1.0, -1.0, 1.0]), (9, 1, 1))
    poses[:, 0, 3] = 0.3 + far * np.arange(9)
    poses[:, 1, 3] = 0.05 * np.arange(9) - 0.2
    poses[:, 2, 3] = 0.4
    return poses


def check_rates(motion, dt):
    steps = np.diff(motion.q[:-1], axis=0) / dt
    assert (np.abs(steps) <= 1.001 * VELOCITY).all()
    assert (np.abs(np.diff(steps, axis=0) / dt) <= 1.05 * ACCELERATION).all()


def test_the_path_is_kept_within_the_rates(ur5):
    poses = line()
    motion = ur5.follow(poses, 0.002, **RATES)
    rows = len(motion)
    assert motion.keep == "path" and motion.obstacle is None and set(motion.tracking) == {"kept"}
    for array, shape in [
        (motion.t, (rows,)),
        (motion.q, (rows, 6)),
        (motion.velocity, (rows, 6)),
        (motion.at, (rows,)),
        (motion.off_position, (rows,)),
        (motion.off_orientation, (rows,)),
    ]:
        assert array.shape == shape and array.dtype == np.float64
    assert len(motion.branch) == len(motion.tracking) == rows
    # Without times the path has its length, and the arm goes as fast as it can.
    assert motion.at[0] == 0.0 and abs(motion.at[-1] - 0.4) < 1e-9 and (np.diff(motion.at) > 0).all()
    assert motion.duration == motion.t[-1] < 1.0
    assert motion.t[1] == 0.002 and motion.t[30] == 0.06
    check_rates(motion, 0.002)
    found = ur5.forward(motion.q)
    np.testing.assert_allclose(found[[0, -1]], poses[[0, -1]], atol=2e-5)
    np.testing.assert_allclose(found[:, [0, 2], 3], np.tile([0.3, 0.4], (rows, 1)), atol=2e-5)
    assert motion.off_position.max() < 2e-5 and motion.off_orientation.max() < 2e-5
    assert motion.branch[0] in {solution.branch for solution in ur5.inverse(poses[0])}
    assert repr(motion) == f"<Motion keeps path: q ({rows}, 6), {motion.duration:.6f} s>"


def test_the_arm_is_never_ahead_of_times(ur5):
    motion = ur5.follow(line(), 0.004, times=TIMES, **RATES)
    assert motion.at[-1] == 2.0 and 2.0 <= motion.duration < 2.1
    assert (motion.at <= motion.t + 1e-12).all()
    start = motion.q[0]
    again = ur5.follow(line(), 0.004, times=TIMES, start=start, **RATES)
    np.testing.assert_array_equal(again.q[0], start)


def test_times_are_kept_by_a_tool_that_deviates(ur5):
    motion = ur5.follow(line(), 0.004, times=TIMES, keep="time", **RATES)
    assert motion.keep == "time" and motion.t.shape == (501,) and motion.t[-1] == 2.0 == motion.at[-1]
    assert motion.obstacle is None and motion.tracking[-1] == "exact"
    # From rest to the speed of the path the tool lags.
    assert motion.tracking[1] == "rates" and motion.off_position[1] > 0.0
    assert (np.abs(np.diff(motion.q, axis=0)) <= 0.004 * VELOCITY * 1.000001).all()
    away = np.array([tracking != "exact" for tracking in motion.tracking])
    assert (motion.off_position[1:][~away[1:]] == 0.0).all()


@pytest.mark.parametrize("keep", ["path", "time"])
def test_an_obstacle_is_told(ur5, keep):
    motion = ur5.follow(line(0.12), 0.01, times=TIMES, keep=keep, **RATES)
    obstacle = motion.obstacle
    assert isinstance(obstacle, denhart.Obstacle) and "reach" in obstacle.reason
    if keep == "path":
        assert len(motion) == 0 and motion.q.shape == (0, 6) and motion.duration == 0.0 and motion.branch == ()
        assert 0.0 < obstacle.at < 2.0
    else:
        assert motion.t[-1] == 2.0 and motion.tracking[-1] == "reach" and motion.off_position[-1] > 0.1
    assert repr(obstacle) in repr(motion) and f"{obstacle.at:.6f}" in repr(obstacle)


def test_a_path_that_begins_out_of_reach_has_no_rows(ur5):
    poses = line()
    poses[:, 0, 3] += 3.0
    for keep in ["path", "time"]:
        motion = ur5.follow(poses, times=TIMES, keep=keep, **RATES)
        assert len(motion) == 0 and motion.obstacle.at == 0.0


def test_other_tasks_and_redundant_joints(panda):
    elbow = denhart.Arm.preset("planar2r")
    rates = {"max_velocity": [1.0, 1.0]}
    targets = np.array([elbow.target_at(q).values for q in [(0.2, 1.0), (0.5, 0.8), (0.9, 0.7)]])
    motion = elbow.follow(targets, 0.01, **rates)
    np.testing.assert_allclose(elbow.forward(motion.q[-1])[:2, 3], targets[-1][:2], atol=1e-4)
    q = np.array([0.1, -0.4, 0.2, -1.9, 0.3, 1.8, 0.6])
    poses = np.tile(panda.forward(q), (2, 1, 1))
    poses[1, 2, 3] -= 0.05
    rates = {"max_velocity": np.full(7, 2.0), "max_acceleration": np.full(7, 10.0)}
    held = panda.follow(poses, 0.01, start=q, **rates)
    # The solution at the first pose, which `start` is next to.
    np.testing.assert_allclose(held.q[0], q, atol=1e-12)
    np.testing.assert_allclose(held.q[:, 6], 0.6, atol=1e-4)
    each = panda.follow(poses, 0.01, given=[0.6, 0.7], **rates)
    assert abs(each.q[0, 6] - 0.6) < 1e-4 and abs(each.q[-1, 6] - 0.7) < 1e-4
    with pytest.raises(ValueError, match="given: the target leaves q7 to choose: .* or start= with joint values"):
        panda.follow(poses, **rates)
    with pytest.raises(ValueError, match=r"given: expected the values of q7, found shape \(3,\)"):
        panda.follow(poses, given=[0.1, 0.2, 0.3], **rates)
    with pytest.raises(ValueError, match=r"targets\[1\]: expected finite numbers, in given= too"):
        panda.follow(poses, given=[0.1, np.nan], **rates)


def test_rates_of_the_arm_file(ur5):
    text = ur5.to_yaml()
    assert "max_velocity" not in text or np.isfinite(ur5.max_velocity).all()
    fast = denhart.Arm.from_yaml(
        "name: elbow\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n"
        "  - {a: 0.3, alpha: 0, d: 0, theta: 0, max_velocity: 90}\n"
        "  - {a: 0.2, alpha: 0, d: 0, theta: 0, max_velocity: 90}\n"
    )
    motion = fast.follow([[0.3, -0.1], [0.3, 0.1]], 0.01)
    assert (np.abs(np.diff(motion.q, axis=0)) <= 0.01 * np.pi / 2 * 1.001).all() and motion.obstacle is None


def test_one_number_is_the_rate_of_every_joint(ur5):
    one = ur5.follow(line(), max_velocity=2.0, max_acceleration=np.inf)
    each = ur5.follow(line(), max_velocity=np.full(6, 2.0), max_acceleration=np.full(6, np.inf))
    np.testing.assert_array_equal(one.q, each.q)


@pytest.mark.parametrize("keep", ["path", "time", "follower"])
def test_rates_may_be_those_of_linked_motors(keep):
    row = "  - {a: 0.3, alpha: 0, d: 0, theta: 0, max_velocity: 30, max_acceleration: 300}\n"
    head = "name: elbow\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n"
    arm = denhart.Arm.from_yaml(f"{head}{row}{row}coupling: {{q2: {{q1: 1, q2: 1}}}}\n")
    most = np.pi / 6 * (1 + 1e-9)
    joints = {}
    for motor_rates in [False, True]:
        if keep == "follower":
            follower = arm.follower([-1.0, 2.0], 0.001, motor_rates=motor_rates)
            velocity = np.array([follower.step([0.3, 0.4]).velocity for _ in range(3000)])
        else:
            velocity = arm.follow([[0.4, -0.2], [0.4, 0.2]], times=[0, 1], keep=keep, motor_rates=motor_rates).velocity
        driven = np.stack([velocity[:, 0], velocity.sum(axis=1)], axis=1) if motor_rates else velocity
        assert 0.5 * most < np.abs(driven).max() <= most
        joints[motor_rates] = velocity
    assert len(joints[True]) != len(joints[False]) or np.abs(joints[True] - joints[False]).max() > 0.05 * most


def edited(poses, index, value):
    poses = poses.copy()
    poses[index] = value
    return poses


BAD = [
    ({"targets": line()[:1]}, "targets: expected two targets at least that differ"),
    ({"targets": np.tile(line()[0], (3, 1, 1))}, "targets: expected two targets at least that differ"),
    ({"targets": np.empty((0, 4, 4))}, "targets: expected two targets at least that differ"),
    ({"targets": line()[0]}, r"targets: .* expected shape \(N, 4, 4\), found \(4, 4\)"),
    ({"targets": np.zeros((5, 6))}, r"targets: .* expected shape \(N, 4, 4\), found \(5, 6\)"),
    ({"targets": edited(line(), (3, 0, 3), np.nan)}, r"targets\[3\]: expected finite numbers"),
    ({"targets": edited(line(), (2, 3), [0, 0, 1, 1])}, r"targets\[2\]: the last row of a pose is"),
    ({"targets": edited(line(), (0, 0, 0), 2.0)}, r"targets\[0\]: expected finite numbers, and a 3 x 3 matrix that is a rotation"),
    ({"dt": 0.0}, "dt: expected a finite time above 0 in s, found 0"),
    ({"dt": np.nan}, "dt: expected a finite time above 0"),
    ({"dt": -0.001}, "dt: expected a finite time above 0"),
    ({"dt": 1e-9}, "dt: .* rows for .* expected a longer one"),
    ({"keep": "tool"}, 'keep: expected "path" .* or "time" .* found "tool"'),
    ({"keep": "time"}, 'times: keep="time" needs the time of each target'),
    ({"times": TIMES[:8]}, r"times: expected shape \(9,\), one for each target, found \(8,\)"),
    ({"times": TIMES[::-1]}, r"times\[1\]: expected finite times that rise, found 1.75 after 2"),
    ({"times": edited(TIMES, 4, TIMES[3])}, r"times\[4\]: expected finite times that rise, found 0.75 after 0.75"),
    ({"times": edited(TIMES, 5, np.nan)}, r"times\[5\]: expected finite times that rise, found NaN"),
    ({"start": np.zeros(5)}, r"start: expected shape \(6,\), found \(5,\)"),
    ({"start": np.zeros(6)}, "start: these joint values are not at the first target; the nearest solution there is"),
    ({"start": np.full(6, np.nan)}, "start: expected finite joint values, found NaN"),
    ({"given": 0.3}, "given: this arm's inverse takes no value beside the target"),
    ({"tolerance": 0.0}, "tolerance: expected a length above 0 in m, found 0"),
    ({"tolerance": np.nan}, "tolerance: expected a length above 0"),
    ({"max_velocity": None}, "max_velocity: the arm file has no velocity of q1, .*q6: write max_velocity="),
    ({"max_velocity": np.zeros(6)}, "max_velocity: expected a rate above 0 for each joint, found 0 of q1"),
    ({"max_velocity": edited(VELOCITY, 3, np.nan)}, "max_velocity: expected a rate above 0 .* found NaN of q4"),
    ({"max_velocity": edited(VELOCITY, 3, np.inf)}, "max_velocity: expected a finite rate for each joint, found inf of q4"),
    ({"max_velocity": [3.0]}, r"max_velocity: expected shape \(6,\), found \(1,\)"),
    ({"max_velocity": -3.0}, "max_velocity: expected a rate above 0 for each joint, found -3 of q1"),
    ({"max_acceleration": -ACCELERATION}, "max_acceleration: expected a rate above 0 for each joint, found -"),
]


@pytest.mark.parametrize(("wrong", "message"), BAD, ids=range(len(BAD)))
def test_bad_input_names_the_argument(ur5, wrong, message):
    with pytest.raises(ValueError, match=message):
        ur5.follow(**{"targets": line(), **RATES, **wrong})


def test_bad_input_of_another_task():
    arm = denhart.Arm.preset("planar3r")
    rates = {"max_velocity": np.ones(3)}
    assert arm.task == "planar_pose"
    with pytest.raises(TypeError):
        arm.follow()
    with pytest.raises(TypeError, match="targets: expected real numbers"):
        arm.follow("line", **rates)
    with pytest.raises(ValueError, match=r"targets\[1\]: expected finite numbers$"):
        arm.follow([[0.3, 0.2, 0.1], [0.3, np.inf, 0.1]], **rates)
    with pytest.raises(ValueError, match=r"targets: .*expected shape \(N, 4, 4\), or \(N, 3\)"):
        arm.follow(np.zeros((2, 2)), **rates)


def test_an_arm_without_inverse_is_an_arm_error():
    arm = next(arm for arm in map(denhart.Arm.preset, denhart.Arm.presets()) if arm.task is None)
    with pytest.raises(denhart.ArmError, match="no inverse"):
        arm.follow(line())


def test_a_motion_pickles(ur5):
    for motion in [ur5.follow(line(), 0.01, **RATES), ur5.follow(line(0.12), 0.01, **RATES)]:
        copy = pickle.loads(pickle.dumps(motion))
        assert repr(copy) == repr(motion) and copy.branch == motion.branch and copy.tracking == motion.tracking
        for name in ["t", "q", "velocity", "at", "off_position", "off_orientation"]:
            np.testing.assert_array_equal(getattr(copy, name), getattr(motion, name))
    with pytest.raises(AttributeError):
        motion.keep = "time"


def test_ctrl_c_ends_it(ur5):
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(1000):
            ur5.follow(line(), 0.001, times=np.arange(9) * 20.0, keep="time", **RATES)


@pytest.mark.skipif(not COMMAND, reason="DENHART names no command")
@pytest.mark.parametrize("keep", ["path", "time"])
@pytest.mark.parametrize("far", [0.0, 0.12])
def test_motions_are_those_of_the_command(ur5, tmp_path, keep, far):
    poses = line(far)
    rows = [f"{t!r},{x!r},{y!r},{z!r},180,0,0\n" for t, (x, y, z) in zip(TIMES.tolist(), poses[:, :3, 3].tolist())]
    path = tmp_path / "path.csv"
    path.write_text("t,x,y,z,roll,pitch,yaw\n" + "".join(rows))
    degrees = " ".join(["180"] * 6), " ".join(["900"] * 6)
    options = ["--max-velocity", degrees[0], "--max-acceleration", degrees[1], "--period", "0.01", "--json"]
    ran = subprocess.run(
        [COMMAND, "follow", SPECS / "ur5.yaml", "--path", path, "--keep", keep, *options],
        capture_output=True,
        text=True,
        check=False,
    )
    answer = json.loads(ran.stdout)
    motion = denhart.Arm.from_file(SPECS / "ur5.yaml").follow(poses, 0.01, times=TIMES, keep=keep, **RATES)
    assert len(answer["rows"]) == len(motion)
    assert (answer["obstacle"] is None) == (motion.obstacle is None)
    if motion.obstacle:
        for name in ["at", "branch", "reason"]:
            assert answer["obstacle"][name] == pytest.approx(getattr(motion.obstacle, name))
    # The command reads and prints degrees, whose rounding is not that of rad.
    q = np.deg2rad([row["q"] for row in answer["rows"]]).reshape(-1, 6)
    np.testing.assert_allclose(motion.q, q, atol=1e-7)
    assert motion.branch == tuple(row["branch"] for row in answer["rows"])
    assert motion.tracking == tuple(row["tracking"] for row in answer["rows"])
