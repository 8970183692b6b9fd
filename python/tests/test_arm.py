"""Arms: where they come from, what they are, and their forward kinematics."""

import pickle

import numpy as np
import pytest

import denhart
from conftest import SPECS, joint_vectors

ELBOW = """
name: elbow
convention: standard
units: {length: m, angle: deg}
joints:
  - {a: 0.3, alpha: 0, d: 0, theta: 0, limits: [-90, 90]}
  - {a: 0.2, alpha: 0, d: 0, theta: 0}
"""


def test_an_arm_from_text_from_a_file_and_by_name_is_one(tmp_path):
    preset = denhart.Arm.preset("ur5")
    path = SPECS / "ur5.yaml"
    assert denhart.Arm.from_file(path) == denhart.Arm.from_file(str(path)) == preset
    assert denhart.Arm.from_yaml(path.read_text()) == preset
    assert hash(denhart.Arm.from_file(path)) == hash(preset)
    assert preset.to_yaml() == path.read_text()
    assert preset != denhart.Arm.preset("ur10") and preset != 3


def test_presets_are_the_files_of_the_repository():
    assert denhart.Arm.presets() == sorted(path.stem for path in SPECS.glob("*.yaml"))


def test_facts():
    arm = denhart.Arm.from_yaml(ELBOW)
    assert (arm.name, arm.dof, arm.length_unit) == ("elbow", 2, "m")
    assert (arm.task, arm.max_solutions, arm.given) == ("planar_position", 2, ())
    assert (arm.joint_names, arm.joint_kinds) == (("q1", "q2"), ("revolute", "revolute"))
    np.testing.assert_array_equal(arm.limits, [[-np.pi / 2, np.pi / 2], [-np.inf, np.inf]])
    assert repr(arm) == "<Arm elbow: RR, lengths in m, inverse planar_position, at most 2 solutions>"
    assert denhart.Arm.preset("franka_panda").given == ("q7",)


def test_forward_is_that_of_two_links():
    arm = denhart.Arm.from_yaml(ELBOW)
    pose = arm.forward([0.4, -1.1])
    c1, s1, c12, s12 = np.cos(0.4), np.sin(0.4), np.cos(-0.7), np.sin(-0.7)
    x, y = 0.3 * c1 + 0.2 * c12, 0.3 * s1 + 0.2 * s12
    expected = [[c12, -s12, 0, x], [s12, c12, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]]
    np.testing.assert_allclose(pose, expected, atol=1e-15)
    jacobian = arm.jacobian([0.4, -1.1])
    expected = [[-y, -0.2 * s12], [x, 0.2 * c12], [0, 0], [0, 0], [0, 0], [1, 1]]
    np.testing.assert_allclose(jacobian, expected, atol=1e-15)
    links = arm.link_poses([0.4, -1.1])
    assert links.shape == (2, 4, 4)
    np.testing.assert_allclose(links[0, :3, 3], [0.3 * c1, 0.3 * s1, 0], atol=1e-15)
    np.testing.assert_array_equal(links[1], pose)


def test_many_joint_vectors_are_each_alone(ur5):
    q = joint_vectors(ur5, 200)
    poses, jacobians = ur5.forward(q), ur5.jacobian(q)
    assert poses.shape == (200, 4, 4) and jacobians.shape == (200, 6, 6)
    for row, pose, jacobian in zip(q, poses, jacobians, strict=True):
        np.testing.assert_array_equal(ur5.forward(row), pose)
        np.testing.assert_array_equal(ur5.jacobian(row), jacobian)


def test_motion_is_that_of_differences(ur5):
    q, qd, qdd = joint_vectors(ur5, 3, seed=5) / 3.0
    step = 1e-5

    def velocity(t):
        return ur5.velocity(q + t * qd + t * t / 2 * qdd, qd + t * qdd)

    np.testing.assert_allclose(ur5.velocity(q, qd), ur5.jacobian(q) @ qd, atol=1e-14)
    difference = (velocity(step) - velocity(-step)) / (2 * step)
    np.testing.assert_allclose(ur5.acceleration(q, qd, qdd), difference, atol=1e-8)
    many = ur5.acceleration(np.tile(q, (3, 1)), np.tile(qd, (3, 1)), np.tile(qdd, (3, 1)))
    np.testing.assert_array_equal(many, np.tile(ur5.acceleration(q, qd, qdd), (3, 1)))


def test_manipulability_and_margins(ur5):
    q = joint_vectors(ur5, 1)[0]
    jacobian = ur5.jacobian(q)
    assert np.isclose(ur5.manipulability(q), abs(np.linalg.det(jacobian)), rtol=1e-12)
    linear = np.prod(np.linalg.svd(jacobian[:3], compute_uv=False))
    assert np.isclose(ur5.manipulability(q, counts=(True,) * 3 + (False,) * 3), linear, rtol=1e-12)
    margins = ur5.margins(q)
    assert set(margins) == {"shoulder", "elbow", "wrist"}
    q[4] = 0.0
    assert ur5.margins(q)["wrist"] == 0.0


def test_manipulability_counts_the_motion_of_the_task():
    arm = denhart.Arm.preset("planar3r")
    q = np.array([0.3, 0.7, -0.4])
    x, y, *_, turn = arm.jacobian(q)
    expected = abs(np.linalg.det([x, y, turn])) if arm.task == "planar_pose" else np.sqrt(np.linalg.det(np.array([x, y]) @ np.array([x, y]).T))
    assert np.isclose(arm.manipulability(q), expected, rtol=1e-12)


def test_motors_that_are_linked():
    arm = denhart.Arm.preset("fanuc_lrmate200id")
    q = joint_vectors(arm, 1)[0]
    motor = arm.to_motor(q)
    # The forearm's angle to the horizon, and the way round of the teach pendant.
    assert not np.allclose(motor, q)
    np.testing.assert_allclose(arm.from_motor(motor), q, atol=1e-12)
    free = denhart.Arm.preset("ur5")
    np.testing.assert_array_equal(free.to_motor(q), q)


def test_pulses():
    arm = denhart.Arm.preset("salman_rrr")
    q = np.array([0.1, 0.7, -0.4])
    pulses = arm.to_pulses(q)
    assert all(type(count) is int for count in pulses)
    near = arm.from_pulses(pulses)
    np.testing.assert_allclose(near, q, atol=1e-3)
    assert arm.to_pulses(near) == pulses
    with pytest.raises(ValueError, match="q: no pulse count of 32 bits reaches the value of"):
        arm.to_pulses([1e9, 0, 0])
    with pytest.raises(denhart.ArmError, match="actuator"):
        denhart.Arm.preset("ur5").to_pulses(np.zeros(6))
    with pytest.raises(denhart.ArmError):
        arm.from_pulses([1, 2])


def test_rates():
    rows = "  - {a: 0.5, alpha: 0, d: 0, theta: 0, max_velocity: 90, max_acceleration: 180}\n  - {a: 0.4, alpha: 0, d: 0, theta: 0}\n"
    arm = denhart.Arm.from_yaml("name: two\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n" + rows)
    np.testing.assert_allclose(arm.max_velocity, [np.pi / 2, np.inf])
    np.testing.assert_allclose(arm.max_acceleration, [np.pi, np.inf])


def test_a_table_of_numbers_is_the_arm_of_its_file():
    table = denhart.Arm.from_dh(
        a=[0, -0.425, -0.39225, 0, 0, 0],
        alpha=[np.pi / 2, 0, 0, np.pi / 2, -np.pi / 2, 0],
        d=[0.089159, 0, 0, 0.10915, 0.09465, 0.0823],
    )
    # Exactly 90 degrees: the sine of pi/2 as a double would leave 6e-17 in the table.
    assert "alpha: 90 deg" in table.to_yaml() and "alpha: -90 deg" in table.to_yaml()
    degrees = denhart.Arm.from_dh(
        a=[0, -0.425, -0.39225, 0, 0, 0],
        alpha=[90, 0, 0, 90, -90, 0],
        d=[0.089159, 0, 0, 0.10915, 0.09465, 0.0823],
        angle="deg",
    )
    for q in joint_vectors(table, 20):
        np.testing.assert_array_equal(table.forward(q), degrees.forward(q))
    straight = table.forward(np.zeros(6))
    assert set(np.abs(straight[:3, :3]).flat) == {0.0, 1.0}


@pytest.mark.parametrize("multiple", range(-24, 25))
def test_multiples_of_15_degrees_are_exact(multiple):
    for value, angle in [(multiple * (np.pi / 12), "rad"), (np.deg2rad(multiple * 15.0), "rad"), (multiple * 15.0, "deg")]:
        arm = denhart.Arm.from_dh(a=[1.0, 1.0], alpha=[value, 0.0], d=[0.0, 0.0], angle=angle)
        assert f"alpha: {multiple * 15} deg" in arm.to_yaml()


def test_table_with_slides_limits_and_units():
    arm = denhart.Arm.from_dh(
        a=[325, 275, 0, 0],
        alpha=[0, 180, 0, 0],
        d=[0, 0, 0, 0],
        theta=[0, 0, 0, 0],
        kinds="RRPR",
        limits=[(-150, 150), None, [0, 200.5], np.array([-np.inf, 90])],
        angle="deg",
        length_unit="mm",
        name="my scara: \"1\"",
    )
    assert arm.joint_kinds == ("revolute", "revolute", "prismatic", "revolute")
    limits = [[-np.deg2rad(150), np.deg2rad(150)], [-np.inf, np.inf], [0, 200.5], [-np.inf, np.pi / 2]]
    np.testing.assert_allclose(arm.limits, limits, rtol=1e-15)
    assert (arm.length_unit, arm.name) == ("mm", "my scara: \"1\"")


def test_code_and_report(ur5):
    code = ur5.to_rust("Ur5")
    assert "pub struct Ur5;" in code and "pub fn inverse(" in code
    assert "inverse (task pose): at most 8 solutions" in ur5.report()


def test_pictures(ur5, tmp_path):
    picture = ur5.draw(np.full(6, 0.3), dimensions=True, view="iso")
    assert picture._repr_svg_() == picture.svg and picture.svg.startswith("<svg")
    picture.save(tmp_path / "ur5.svg")
    assert (tmp_path / "ur5.svg").read_text() == picture.svg
    with pytest.raises(FileNotFoundError, match="No such file or directory: .*none/ur5.svg"):
        picture.save(tmp_path / "none" / "ur5.svg")
    solutions = ur5.inverse(ur5.forward(np.full(6, 0.3)))
    assert ur5.draw(solutions=solutions).svg != picture.svg
    one = ur5.inverse_branch(solutions.target, solutions[2].branch)
    assert ur5.draw(solutions=solutions).svg.count("elbow") == 8 and ur5.draw(solutions=one).svg.count("elbow") == 1
    for name in ["planar2r", "kuka_youbot", "cobra600_rrpr", "anthro3r", "al5d"]:
        arm = denhart.Arm.preset(name)
        q = joint_vectors(arm, 1)[0]
        assert arm.draw(solutions=arm.inverse(arm.target_at(q))).svg.startswith("<svg")


@pytest.mark.parametrize("name", denhart.Arm.presets())
def test_pickles(name):
    arm = denhart.Arm.preset(name)
    again = pickle.loads(pickle.dumps(arm))
    assert again == arm and repr(again) == repr(arm)
    if arm.task is None:
        return
    q = joint_vectors(arm, 1)[0]
    target = arm.target_at(q)
    assert pickle.loads(pickle.dumps(target)) == target
    solutions = arm.inverse(target, near=q)
    again = pickle.loads(pickle.dumps(solutions))
    np.testing.assert_array_equal(again.q, solutions.q)
    assert repr(again) == repr(solutions)
    assert repr(pickle.loads(pickle.dumps(solutions[0]))) == repr(solutions[0])
