"""Followers, tick by tick: limits in each tick, deviations, redundant joints, threads, and what is refused."""

import pickle
import threading

import numpy as np
import pytest

import denhart

Q = np.array([0.3, -1.2, 1.4, -0.5, 0.9, 0.2])
VELOCITY = np.full(6, 3.0)
ACCELERATION = np.full(6, 24.0)
RATES = {"max_velocity": VELOCITY, "max_acceleration": ACCELERATION}
DT = 0.004


def moved(arm, q, way):
    pose = arm.forward(q)
    pose[:3, 3] += way
    return pose


def run(follower, target, ticks, given=None):
    """Ticks towards one target, each of them within the rates."""
    steps, before = [], follower.q
    for _ in range(ticks):
        step = follower.step(target, given)
        np.testing.assert_array_equal(step.q, follower.q)
        np.testing.assert_allclose(step.velocity, (step.q - before) / DT, atol=1e-9)
        before = step.q
        steps.append(step)
    velocity = np.array([step.velocity for step in steps])
    return steps, velocity


def test_a_target_that_jumps_is_reached_within_the_rates(ur5):
    follower = ur5.follower(Q, DT, **RATES)
    np.testing.assert_array_equal(follower.q, Q)
    assert follower.dt == DT and follower.arm is ur5
    target = moved(ur5, Q, [0.1, 0.05, -0.1])
    steps, velocity = run(follower, target, 300)
    first, last = steps[0], steps[-1]
    assert (np.abs(velocity) <= VELOCITY * (1 + 1e-9)).all()
    assert (np.abs(np.diff(velocity, axis=0, prepend=0.0)) <= DT * ACCELERATION * (1 + 1e-6)).all()
    assert first.tracking == "rates" and not first.is_exact and 0.0 < first.remaining < 1.0
    way = np.abs(ur5.inverse(target, near=Q).q[0] - Q)
    assert first.held == tuple(np.flatnonzero(way > DT * DT * ACCELERATION)) and first.held
    assert first.residual[0] == pytest.approx(np.linalg.norm(first.deviation[:3])) and first.residual[0] > 0.1
    # The twist leads from the tool to the target.
    assert first.deviation[:3] @ (target - ur5.forward(first.q))[:3, 3] > 0.0
    assert last.tracking == "exact" and last.is_exact and last.remaining == 0.0 and last.residual == (0.0, 0.0)
    assert last.crossed is None and last.branch == first.branch != ""
    np.testing.assert_allclose(ur5.forward(last.q), target, atol=1e-9)
    for array, shape in [(last.q, (6,)), (last.velocity, (6,)), (last.deviation, (6,))]:
        assert array.shape == shape and array.dtype == np.float64


def test_a_target_that_is_slow_enough_is_met_in_every_tick(ur5):
    follower = ur5.follower(Q, DT, **RATES)
    for tick in range(1, 251):
        way = 0.1 * np.sin(np.pi * tick * DT) ** 2
        target = moved(ur5, Q, [0.0, way, 0.0])
        step = follower.step(target)
        assert step.tracking == "exact", (tick, step)
        np.testing.assert_allclose(ur5.forward(step.q), target, atol=1e-9)


def test_out_of_reach_the_arm_comes_to_rest(ur5):
    follower = ur5.follower(Q, DT, **RATES)
    steps, velocity = run(follower, moved(ur5, Q, [3.0, 0.0, 0.0]), 1500)
    assert steps[-1].tracking == "reach" and steps[-1].remaining == np.inf and steps[-1].residual[0] > 1.0
    # A creep in a direction that changes the distance little is left, see docs/follow.md.
    assert np.abs(velocity[-1]).max() * DT < 1e-3


def test_limits_hold_the_arm():
    arm = denhart.Arm.from_dh(a=[0.3, 0.2], alpha=[0, 0], d=[0, 0], limits=[(-1.0, 1.0), (0.1, 2.0)])
    follower = arm.follower([0.8, 1.0], DT, max_velocity=[1.0, 1.0], crossing="exact")
    target = [0.3 * np.cos(1.5) + 0.2 * np.cos(2.5), 0.3 * np.sin(1.5) + 0.2 * np.sin(2.5)]
    steps, _ = run(follower, target, 200)
    assert steps[-1].tracking == "limits" and steps[-1].held == (0,)
    assert steps[-1].q[0] == pytest.approx(1.0) and all(step.q[0] <= 1.0 + 1e-12 for step in steps)


def test_bad_targets_and_stops_brake(ur5):
    nan = ur5.forward(Q)
    nan[0, 3] = np.nan
    mirror = np.diag([1.0, 1.0, -1.0, 1.0])
    for brake in [lambda f: f.step(nan), lambda f: f.step(mirror), lambda f: f.stop()]:
        follower = ur5.follower(Q, DT, **RATES)
        _, velocity = run(follower, moved(ur5, Q, [0.1, 0.05, -0.1]), 10)
        speed = np.abs(velocity[-1]).max()
        assert speed > 0.1
        for _ in range(40):
            step = brake(follower)
            assert step.tracking == "target" and np.abs(step.velocity).max() <= speed
            speed = np.abs(step.velocity).max()
        assert speed == 0.0
        # It goes on from there.
        assert run(follower, ur5.forward(Q), 300)[0][-1].is_exact


def test_a_redundant_joint_is_given_or_stays(panda):
    q = np.array([0.1, -0.4, 0.2, -1.9, 0.3, 1.8, 0.6])
    rates = {"max_velocity": np.full(7, 2.0), "max_acceleration": np.full(7, 16.0)}
    pose = panda.forward(q)
    pose[2, 3] -= 0.05
    (last,) = run(panda.follower(q, DT, **rates), pose, 300)[0][-1:]
    assert last.is_exact and abs(last.q[6] - 0.6) < 1e-12
    (last,) = run(panda.follower(q, DT, given=0.7, **rates), pose, 300)[0][-1:]
    assert last.is_exact and abs(last.q[6] - 0.7) < 1e-12
    (last,) = run(panda.follower(q, DT, **rates), pose, 300, given=[0.8])[0][-1:]
    assert last.is_exact and abs(last.q[6] - 0.8) < 1e-12
    follower = panda.follower(q, DT, **rates)
    with pytest.raises(ValueError, match="given: "):
        follower.step(pose, given=[0.1, 0.2])
    assert follower.step(pose, given=np.nan).tracking == "target"
    np.testing.assert_array_equal(follower.q, q)
    with pytest.raises(ValueError, match="given: expected finite values"):
        panda.follower(q, given=np.nan, **rates)


def test_other_tasks_and_slides():
    for name, q in [("planar3r", [0.3, 0.8, -0.6]), ("scara_rrrp_325_275", [0.3, 0.8, -0.6, 0.05])]:
        arm = denhart.Arm.preset(name)
        follower = arm.follower(q, DT, max_velocity=np.full(arm.dof, 2.0))
        goal = np.array(q) + 0.02
        step = run(follower, arm.target_at(goal), 100)[0][-1]
        assert step.is_exact and step.q.shape == (arm.dof,)
        np.testing.assert_allclose(step.q, goal, atol=1e-9)


def test_an_arm_is_sent_to_another_branch(ur5):
    target = ur5.forward(Q)
    follower = ur5.follower(Q, DT, crossing="exact", **RATES)
    start = follower.step(target)
    other = next(s.branch for s in ur5.inverse(target) if "flip" in s.branch and s.branch != start.branch)
    follower.go_to_branch(other)
    steps, _ = run(follower, target, 2000)
    assert steps[-1].is_exact and steps[-1].branch == other
    crossings = [step.crossed for step in steps if step.crossed is not None]
    assert crossings and crossings[0] == start.branch
    with pytest.raises(ValueError, match="branch: 'wrist up'|branch: \"wrist up\""):
        follower.go_to_branch("wrist up")


def test_the_rates_of_the_arm_file_count():
    row = "  - {a: 0.3, alpha: 0, d: 0, theta: 0, max_velocity: 90, max_acceleration: 900}\n"
    text = f"name: elbow\nconvention: standard\nunits: {{length: m, angle: deg}}\njoints:\n{row}{row}"
    arm = denhart.Arm.from_yaml(text)
    follower = arm.follower([0.2, 0.9], DT)
    _, velocity = run(follower, arm.target_at([1.2, 0.4]), 100)
    assert np.pi / 2 * 0.9 < np.abs(velocity).max() <= np.pi / 2 * (1 + 1e-9)


BAD = [
    ({"start": np.zeros(5)}, r"start: expected shape \(6,\), found \(5,\)"),
    ({"start": np.full(6, np.nan)}, "start: expected finite joint values, found NaN"),
    ({"start": np.full(6, 9.0)}, "start: the start is outside the range of joint 1"),
    ({"dt": 0.0}, "dt: expected a finite time above 0 in s, found 0"),
    ({"dt": -1e-3}, "dt: expected a finite time above 0"),
    ({"dt": np.nan}, "dt: expected a finite time above 0"),
    ({"dt": np.inf}, "dt: expected a finite time above 0"),
    ({"max_velocity": None}, "max_velocity: the arm file has no velocity of q1, .*q6: write max_velocity="),
    ({"max_velocity": np.zeros(6)}, "max_velocity: expected a rate above 0 for each joint, found 0 of q1"),
    ({"max_velocity": np.full(6, np.nan)}, "max_velocity: expected a rate above 0 .* found NaN of q1"),
    ({"max_velocity": np.full(6, np.inf)}, "max_velocity: expected a finite rate for each joint, found inf of q1"),
    ({"max_velocity": [3.0]}, r"max_velocity: expected shape \(6,\), found \(1,\)"),
    ({"max_velocity": np.full(6, 1e-320), "dt": 1e-6}, "max_velocity: "),
    ({"max_acceleration": np.zeros(6)}, "max_acceleration: expected a rate above 0"),
    ({"max_acceleration": np.full(7, 1.0)}, r"max_acceleration: expected shape \(6,\), found \(7,\)"),
    ({"given": 0.3}, "given: this arm's inverse takes no value beside the target"),
    ({"length": 0.0}, "length: expected a length above 0 in m, found 0"),
    ({"length": np.nan}, "length: expected a length above 0"),
    ({"crossing": "elbow"}, 'crossing: expected "exact", "wrist" or "any".* found "elbow"'),
]


@pytest.mark.parametrize(("wrong", "message"), BAD, ids=range(len(BAD)))
def test_bad_input_names_the_argument(wrong, message):
    arm = denhart.Arm.preset("puma560")
    q = np.array([0.3, 0.5, -1.2, 0.4, 0.5, 0.2])
    with pytest.raises(ValueError, match=message):
        arm.follower(**{"start": q, **RATES, **wrong})


def test_bad_targets_are_named(ur5):
    follower = ur5.follower(Q, DT, **RATES)
    for target in ["here", [1.0, 2.0], np.zeros((3, 3)), None]:
        with pytest.raises((ValueError, TypeError), match="target: "):
            follower.step(target)
    with pytest.raises(denhart.ArmError, match="`pose`, not `position`"):
        follower.step(denhart.Target.position([0.1, 0.2, 0.3]))
    transposed = ur5.forward(Q).T.copy()
    with pytest.raises(ValueError, match="the last row of a pose"):
        follower.step(transposed)
    np.testing.assert_array_equal(follower.q, Q)


def test_an_arm_without_inverse_is_an_arm_error():
    arm = next(arm for arm in map(denhart.Arm.preset, denhart.Arm.presets()) if arm.task is None)
    with pytest.raises(denhart.ArmError, match="no inverse"):
        arm.follower(np.zeros(arm.dof), max_velocity=np.ones(arm.dof))


def test_threads_take_turns(ur5):
    target = moved(ur5, Q, [0.1, 0.05, -0.1])
    alone = ur5.follower(Q, DT, **RATES)
    run(alone, target, 80)
    shared = ur5.follower(Q, DT, **RATES)
    threads = [threading.Thread(target=lambda: [shared.step(target) for _ in range(20)]) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    np.testing.assert_array_equal(shared.q, alone.q)


def test_steps_pickle_and_followers_do_not(ur5):
    follower = ur5.follower(Q, DT, **RATES)
    for step in [follower.step(moved(ur5, Q, [0.1, 0.0, 0.0])), follower.stop()]:
        copy = pickle.loads(pickle.dumps(step))
        assert repr(copy) == repr(step)
        for name in ["tracking", "branch", "crossed", "held", "remaining", "residual"]:
            assert getattr(copy, name) == getattr(step, name)
        for name in ["q", "velocity", "deviation"]:
            np.testing.assert_array_equal(getattr(copy, name), getattr(step, name))
    with pytest.raises(TypeError):
        pickle.dumps(follower)
    with pytest.raises(AttributeError):
        follower.q = Q
    assert repr(follower).startswith("<Follower of ur5: a tick each 0.004 s, at [17.")
    assert repr(step).startswith("<Step target, ")
