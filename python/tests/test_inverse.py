"""The inverse: solutions, targets, branches, redundant joints, iteration."""

import pickle
import threading

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import denhart
from conftest import joint_vectors
from denhart import Flags, Status, Target

PRESETS = denhart.Arm.presets()


def turned(difference, arm):
    """Differences of joint values, less whole turns."""
    slides = np.array(arm.joint_kinds) == "prismatic"
    return np.where(slides, difference, (difference + np.pi) % (2 * np.pi) - np.pi)


@pytest.mark.parametrize("name", PRESETS)
def test_every_preset_comes_back_to_its_joint_values(name):
    arm = denhart.Arm.preset(name)
    if arm.task is None:
        pytest.skip("no inverse")
    for q in joint_vectors(arm, 20, seed=3):
        target = arm.target_at(q)
        solutions = arm.inverse(target, near=q)
        assert solutions.status == Status.REACHABLE
        reach = np.linalg.norm(arm.forward(q)[:3, 3]) + 1.0
        nearest = np.abs(turned(solutions.q - q, arm)).max(axis=1).min()
        assert nearest < 1e-6 * reach, f"{name} at {q.tolist()}"
        for solution in solutions:
            assert solution.flags & (Flags.EXACT | Flags.APPROXIMATE)


def test_solutions_are_a_sequence(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    solutions = ur5.inverse(ur5.forward(q))
    assert len(solutions) == 8 and solutions and solutions.is_complete
    assert solutions.deviation == 0.0
    assert solutions.q.shape == (8, 6)
    assert [solution.branch for solution in solutions] == [solutions[index].branch for index in range(8)]
    np.testing.assert_array_equal(solutions[-1].q, solutions[7].q)
    np.testing.assert_array_equal([solution.q for solution in solutions], solutions.q)
    assert [repr(solution) for solution in solutions[::-3]] == [repr(solutions[index]) for index in (7, 4, 1)]
    assert solutions.why() == "reachable: 8 solutions"
    first = solutions[0]
    assert first.is_exact and first.is_within_limits and first.free == () and first.residual == (0.0, 0.0)
    assert first.flags == Flags.EXACT and first.branch == "shoulder left, elbow up, wrist no-flip"
    assert repr(first).startswith("<Solution [-138.257 deg, ") and repr(first).endswith("wrist no-flip>")
    with pytest.raises(IndexError, match="solution 8 of 8"):
        solutions[8]
    with pytest.raises(IndexError, match="solution -9 of 8"):
        solutions[-9]
    with pytest.raises(AttributeError):
        first.branch = "other"


def test_solutions_are_found_in_their_sequence(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    solutions, again = ur5.inverse(ur5.forward(q)), ur5.inverse(ur5.forward(q))
    assert solutions == again and hash(solutions) == hash(again) and solutions != ur5.inverse(ur5.forward(q + 0.1))
    assert solutions != list(solutions)
    for place, solution in enumerate(again):
        assert solution == solutions[place] and hash(solution) == hash(solutions[place])
        assert solution in solutions and solutions.index(solution) == place and solutions.count(solution) == 1
    assert len(set(solutions) | set(again)) == 8
    assert 1.0 not in solutions and solutions[0] != "x" and solutions.count(None) == 0
    for arguments in [(solutions[3], 4), (solutions[3], 0, 3), (solutions[3], -4), ("x",)]:
        with pytest.raises(ValueError, match="not in the list"):
            solutions.index(*arguments)
    assert solutions.index(solutions[3], -8, -4) == 3


def test_near_sorts_and_unwinds(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4]) + 2 * np.pi
    solutions = ur5.inverse(ur5.forward(q), near=q - 0.01)
    np.testing.assert_allclose(solutions.q[0], q, atol=1e-12)


def test_a_singular_pose_names_its_free_joint(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.0, -0.4])
    solutions = ur5.inverse(ur5.forward(q), near=q)
    first = solutions[0]
    assert Flags.FREE in first.flags and first.free
    np.testing.assert_allclose(first.q, q, atol=1e-9)
    assert "FREE {q" in repr(first)


def test_limits():
    arm = denhart.Arm.preset("puma560")
    target = arm.forward([0.1, 0.2, 0.3, 0.4, 0.5, 0.6])
    marked = arm.inverse(target)
    kept = arm.inverse(target, limits="drop")
    inside = [solution for solution in marked if solution.is_within_limits]
    assert 0 < len(inside) < len(kept) < len(marked)
    assert all(solution in kept for solution in inside)
    assert f"{len(marked) - len(inside)} of them outside the joint limits" in marked.why()


def test_dropped_solutions_are_those_that_no_turn_brings_inside(panda):
    arm = denhart.Arm.preset("abb_irb140")
    q = np.radians([0, 0, -200, 0, 40, 0])
    target = arm.forward(q)
    assert not arm.inverse(target).q[:, 2].min() < -np.pi
    branch = arm.inverse(target, near=q)[0].branch
    for solutions in [arm.inverse(target, limits="drop"), arm.inverse_branch(target, branch, limits="drop")]:
        assert np.abs(solutions.q - q).max(axis=1).min() < 1e-9
    batch = arm.inverse_batch(np.stack([target] * 3), limits="drop")
    np.testing.assert_array_equal(batch.q[1, : batch.count[1]], arm.inverse(target, limits="drop").q)
    for arm, given in [(arm, False), (denhart.Arm.preset("puma560"), False), (panda, True)]:
        low, high = arm.limits.T
        for q in np.random.default_rng(5).uniform(low, high, (200, arm.dof)):
            values = {"given": q[6]} if given else {}
            solutions = arm.inverse(arm.forward(q), limits="drop", **values)
            difference = turned(solutions.q - q, arm)
            assert np.abs(difference).max(axis=1).min() < 1e-6
            assert ((solutions.q >= low - 1e-9) & (solutions.q <= high + 1e-9)).all()
            for solution in solutions:
                assert solution.is_within_limits and np.abs(arm.forward(solution.q) - arm.forward(q)).max() < 1e-9


def test_words_of_status_and_flags():
    assert (str(Status.REACHABLE), f"{Flags.EXACT | Flags.FREE}") == ("Status.REACHABLE", "Flags.EXACT|FREE")


def test_out_of_reach_and_bad_targets(ur5):
    target = ur5.forward(np.full(6, 0.3))
    target[0, 3] += 5.0
    far = ur5.inverse(target)
    assert not far and len(far) == 0 and far.q.shape == (0, 6) and far.status == Status.UNREACHABLE
    assert far.why().startswith("unreachable: the point is out of reach; the closest that iteration finds is ")
    assert repr(far) == "<no solution of ur5: unreachable>"
    target[0, 0] = np.nan
    bad = ur5.inverse(target)
    assert bad.status == Status.BAD_TARGET and bad.why().startswith("bad target: a number is not finite")
    mirrored = np.diag([1.0, 1.0, -1.0, 1.0])
    assert ur5.inverse(mirrored).status == Status.BAD_TARGET
    off = ur5.forward(np.full(6, 0.3))
    off[0, 0] += 1e-5
    assert 1e-6 < ur5.inverse(off).deviation < 1e-4 and len(ur5.inverse(off))
    near = np.full(6, np.nan)
    assert ur5.inverse(ur5.forward(np.full(6, 0.3)), near=near).status == Status.BAD_TARGET


@pytest.mark.parametrize("name, q", [("planar3r", [0.3, 0.8, -0.6]), ("planar2r", [0.3, 0.8]), ("anthro3r", [0.3, 0.8, -0.6])])
def test_a_pose_of_any_form_is_a_target_of_other_tasks(name, q):
    arm = denhart.Arm.preset(name)
    pose = arm.forward(q)
    expected = arm.inverse(pose)
    rotation, point = pose[:3, :3], pose[:3, 3]
    for target in [Target.pose(pose), (Rotation.from_matrix(rotation), point), (rotation, point)]:
        found = arm.inverse(target)
        assert found.target == expected.target
        np.testing.assert_array_equal(found.q, expected.q)
    for target in [(None, point), ("x", point), (point, None)]:
        with pytest.raises((ValueError, TypeError)):
            arm.inverse(target)
    # Columns of an array would be read in another order.
    with pytest.raises(ValueError, match="target: the task of this arm is"):
        arm.inverse(point.reshape(3, 1))


def test_batches_of_five_joints_are_those_of_single_calls():
    arm = denhart.Arm.from_dh(a=[0, 0.2, 0.3, 0.2, 0], alpha=[np.pi / 2, 0, 0, np.pi / 2, 0], d=[0.3, 0.1, 0, 0, 0.2])
    rng = np.random.default_rng(0)
    joints = rng.uniform(-3, 3, (64, 5)) * (rng.uniform(0, 1, (64, 5)) < 0.7)
    joints[::8] = 0.0
    poses = arm.forward_batch(joints)
    batch = arm.inverse_batch(poses)
    for pose, q, count in zip(poses, batch.q, batch.count):
        np.testing.assert_array_equal(q[:count], arm.inverse(pose).q)


class RigidTransform:
    """What SciPy's class of this name has, which versions before 1.16 do not have."""

    def __init__(self, matrix):
        self.matrix = matrix

    def as_matrix(self):
        return self.matrix


def test_every_way_to_write_a_pose(ur5):
    pose = ur5.forward([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    expected = ur5.inverse(pose).q
    rotation = Rotation.from_matrix(pose[:3, :3])
    for target in [pose.tolist(), np.asfortranarray(pose), RigidTransform(pose), (pose[:3, :3], pose[:3, 3]), Target.pose(pose)]:
        np.testing.assert_array_equal(ur5.inverse(target).q, expected)
    for target in [
        (rotation, pose[:3, 3]),
        (rotation, pose[:3, 3].tolist()),
        Target.xyz_rpy(pose[:3, 3], rotation.as_euler("xyz")),
        Target.xyz_rpy_degrees(pose[:3, 3], rotation.as_euler("xyz", degrees=True)),
        pose.astype(np.float32),
    ]:
        np.testing.assert_allclose(ur5.inverse(target).q, expected, atol=1e-5)
    try:
        from scipy.spatial.transform import RigidTransform as Real
    except ImportError:
        return
    np.testing.assert_allclose(ur5.inverse(Real.from_matrix(pose)).q, expected, atol=1e-12)


def test_a_list_of_a_rotation_and_a_point_is_a_pose(ur5):
    pose = ur5.forward([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    pair = [Rotation.from_matrix(pose[:3, :3]), pose[:3, 3]]
    np.testing.assert_array_equal(ur5.inverse(pair).q, ur5.inverse(tuple(pair)).q)
    assert len(ur5.inverse(pair)) == 8 and len(ur5.inverse([pose[:3, :3], pose[:3, 3].tolist()])) == 8


def test_targets_of_the_other_tasks():
    def same(name, q, *targets):
        arm = denhart.Arm.preset(name)
        expected = arm.inverse(arm.target_at(q)).q
        assert len(expected)
        for target in targets:
            np.testing.assert_allclose(arm.inverse(target(arm, arm.forward(q))).q, expected, atol=1e-9)

    same(
        "anthro3r",
        [0.3, 0.4, 0.5],
        lambda arm, pose: pose,
        lambda arm, pose: pose[:3, 3],
        lambda arm, pose: tuple(pose[:3, 3]),
        lambda arm, pose: Target.position(pose[:3, 3]),
    )
    same(
        "planar2r",
        [0.3, 0.4],
        lambda arm, pose: pose,
        lambda arm, pose: tuple(pose[:2, 3]),
        lambda arm, pose: Target.planar_position(*pose[:2, 3]),
    )
    same(
        "planar3r",
        [0.3, 0.4, 0.5],
        lambda arm, pose: pose,
        lambda arm, pose: (*pose[:2, 3], 1.2),
        lambda arm, pose: Target.planar_pose(*pose[:2, 3], 1.2),
        lambda arm, pose: Target.planar_pose_degrees(*pose[:2, 3], np.rad2deg(1.2)),
    )


def test_branches(ur5):
    target = ur5.forward([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    for solution in ur5.inverse(target):
        one = ur5.inverse_branch(target, solution.branch)
        assert len(one) == 1 and one[0].branch == solution.branch
        np.testing.assert_array_equal(one.q[0], solution.q)
    with pytest.raises(ValueError, match="'?\"?elbow top\"? is no part of a branch"):
        ur5.inverse_branch(target, "shoulder left, elbow top")


def test_a_redundant_joint(panda):
    q = joint_vectors(panda, 1)[0]
    target = panda.forward(q)
    given = panda.inverse(target, given=q[6])
    assert any(np.allclose(solution.q, q, atol=1e-8) for solution in given)
    np.testing.assert_array_equal(panda.inverse(target, given=[q[6]]).q, given.q)
    np.testing.assert_allclose(panda.inverse(target, near=q).q[0], q, atol=1e-8)
    with pytest.raises(ValueError, match="given: the target leaves q7 to choose"):
        panda.inverse(target)
    with pytest.raises(ValueError, match="near= has these values already"):
        panda.inverse(target, near=q, given=0.1)
    with pytest.raises(ValueError, match="given: expected the values of q7, found 2 of them"):
        panda.inverse(target, given=[0.1, 0.2])
    swept = panda.sweep(target, 21)
    assert len(swept) == 21
    low, high = panda.limits[6]
    steps = low + (np.arange(21) + 0.5) / 21 * (high - low)
    np.testing.assert_allclose([value for value, _ in swept], steps, atol=1e-12)
    for value, solutions in swept:
        np.testing.assert_array_equal(solutions.q, panda.inverse(target, given=value).q)


def test_several_redundant_joints():
    rows = "".join(f"  - {{a: {a}, alpha: 0, d: 0, theta: 0, limits: [-170, 170]}}\n" for a in (0.5, 0.4, 0.3, 0.2))
    text = "name: four\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n"
    arm = denhart.Arm.from_yaml(f"{text}{rows}inverse: {{task: planar_position, redundant: [q1, q4]}}\n")
    assert arm.given == ("q1", "q4")
    target = arm.target_at([0.3, 0.5, -0.4, 0.2])
    swept = arm.sweep(target, (4, 3))
    assert len(swept) == 12
    low, high = np.deg2rad([-170, 170])
    for index, (values, found) in enumerate(swept):
        expected = [low + (index // 3 + 0.5) / 4 * (high - low), low + (index % 3 + 0.5) / 3 * (high - low)]
        np.testing.assert_allclose(values, expected, atol=1e-12)
        np.testing.assert_array_equal(found.q, arm.inverse(target, given=values).q)
    assert any(len(found) > 0 for _, found in swept)


def test_iteration(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    found = ur5.numeric(ur5.forward(q), start=q + 0.1)
    assert found.converged and found.iterations > 0 and max(found.residual) < 1e-8
    np.testing.assert_allclose(found.q, q, atol=1e-7)
    assert "converged" in repr(found)
    for name in ["kuka_youbot", "planar2r", "planar3r", "anthro3r", "scorbot_er5"]:
        arm = denhart.Arm.preset(name)
        q = 0.5 * joint_vectors(arm, 1)[0]
        if arm.task == "position_angle":
            continue
        found = arm.numeric(arm.target_at(q), start=q + 0.05, limits=False)
        assert found.converged, f"{name}: {found}"


def test_an_iteration_is_pickled(ur5):
    q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])
    found = ur5.numeric(ur5.forward(q), q + 0.1)
    again = pickle.loads(pickle.dumps(found))
    assert repr(again) == repr(found) and again.converged and again.iterations == found.iterations
    assert again.residual == found.residual and again.restarts == found.restarts
    np.testing.assert_array_equal(again.q, found.q)


def test_an_arm_without_inverse_says_so():
    seven = denhart.Arm.from_dh(a=[0.1] * 7, alpha=[0.3, -0.4, 0.5, 0.6, -0.7, 0.8, 0.9], d=[0.1] * 7)
    if seven.task is None:
        with pytest.raises(denhart.ArmError, match="no inverse kinematics: "):
            seven.inverse(np.eye(4))
        q = np.full(7, 0.3)
        assert seven.numeric(seven.forward(q), start=q + 0.05).converged


def test_threads_share_an_arm(ur5):
    q = joint_vectors(ur5, 50)
    expected = [ur5.inverse(pose).q for pose in ur5.forward(q)]
    wrong = []

    def work():
        for row, solutions in zip(q, expected, strict=True):
            if not np.array_equal(ur5.inverse(ur5.forward(row)).q, solutions):
                wrong.append(row)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
