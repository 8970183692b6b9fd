"""Every kind of array that may come: the right result, or an exception that says what was expected."""

import numpy as np
import pytest

import denhart

Q = np.array([0.3, -1.2, 1.4, 0.2, 0.9, -0.4])


@pytest.mark.parametrize(
    "given",
    [
        Q.tolist(),
        tuple(Q),
        np.asfortranarray(Q),
        np.repeat(Q, 3)[::3],
        Q[::-1].copy()[::-1],
        Q.astype(">f8"),
        Q.astype(np.longdouble),
        np.frombuffer(b"x" + Q.tobytes(), dtype=np.uint8)[1:].view(np.float64),
        np.rec.array([(Q,)], dtype=[("q", float, 6)])["q"][0],
        memoryview(Q),
    ],
    ids=["list", "tuple", "F", "stride", "backward", "endian", "long", "unaligned", "record", "buffer"],
)
def test_the_same_numbers_give_the_same_pose(ur5, given):
    np.testing.assert_array_equal(ur5.forward(given), ur5.forward(Q))
    np.testing.assert_array_equal(ur5.inverse(ur5.forward(Q), near=given).q, ur5.inverse(ur5.forward(Q), near=Q).q)


def test_other_numbers_are_converted(ur5):
    single = Q.astype(np.float32)
    np.testing.assert_array_equal(ur5.forward(single), ur5.forward(single.astype(float)))
    np.testing.assert_array_equal(ur5.forward([1, 0, -1, 2, 0, 1]), ur5.forward([1.0, 0.0, -1.0, 2.0, 0.0, 1.0]))
    np.testing.assert_array_equal(ur5.forward(np.arange(6, dtype=np.uint8)), ur5.forward(np.arange(6.0)))


def test_orders_and_gaps_of_batches(ur5):
    q = np.random.default_rng(2).uniform(-3, 3, (40, 6))
    expected = ur5.inverse_batch(ur5.forward(q)).q
    poses = ur5.forward(q)
    spread = np.zeros((80, 4, 4))
    spread[::2] = poses
    for given in [np.asfortranarray(poses), spread[::2], poses.tolist(), poses[::-1][::-1], list(poses)]:
        np.testing.assert_array_equal(ur5.inverse_batch(given).q, expected)
    np.testing.assert_array_equal(ur5.forward(np.asfortranarray(q)), poses)
    read_only = poses.copy()
    read_only.setflags(write=False)
    np.testing.assert_array_equal(ur5.inverse_batch(read_only).q, expected)


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ([0.1, 0.2], ValueError, r"q: expected shape \(6,\) or \(N, 6\), found \(2,\): ur5 has the joints "),
        (0.5, ValueError, r"q: expected shape \(6,\) or \(N, 6\)"),
        (np.zeros((2, 3, 6)), ValueError, r"found \(2, 3, 6\)"),
        (np.zeros((6, 1)), ValueError, r"found \(6, 1\)"),
        ([], ValueError, r"found \(0,\)"),
        ([[0.1], [0.2, 0.3]], ValueError, r"q: expected an array of numbers, found list \[\[0.1\], \[0.2, 0.3\]\]"),
        ("abc", TypeError, "q: expected real numbers, found dtype <U3"),
        (["1"] * 6, TypeError, "q: expected real numbers, found dtype <U1"),
        (None, TypeError, "q: expected an array of numbers, found one of objects: NoneType None"),
        ([None] * 6, TypeError, "q: expected an array of numbers, found one of objects"),
        (np.array([1.0] * 6, dtype=object), TypeError, "found one of objects"),
        ([1j] * 6, TypeError, "q: expected real numbers, found dtype complex128"),
        ([True] * 6, TypeError, "q: expected real numbers, found dtype bool"),
        ({"q": 1}, TypeError, "found one of objects: dict"),
    ],
)
def test_what_are_no_joint_values(ur5, given, error, message):
    for call in [ur5.forward, ur5.jacobian]:
        with pytest.raises(error, match=message):
            call(given)
    with pytest.raises(error, match="^near: "):
        ur5.inverse(np.eye(4), near=given) if given is not None else ur5.inverse(np.eye(4), near=[None])


@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        (3, ValueError, "target: expected a pose: a 4 x 4 array, a SciPy RigidTransform, or .rotation, point., found an array of shape "),
        (np.eye(3), ValueError, r"found an array of shape \(3, 3\)"),
        (np.eye(4)[None], ValueError, r"found an array of shape \(1, 4, 4\)"),
        ([0.1, 0.2, 0.3], ValueError, r"found an array of shape \(3,\)"),
        ((np.eye(3), [1, 2]), ValueError, "found a tuple of 2"),
        ([np.eye(3), [1, 2]], ValueError, "found a tuple of 2"),
        (np.ma.masked_array(np.eye(4), np.eye(4)), TypeError, "target: expected an array without a mask, found a masked one"),
        ("pose", TypeError, "target: expected real numbers, found dtype <U4"),
        (None, TypeError, "target: expected an array of numbers"),
        (denhart.Target.position([1, 2, 3]), denhart.ArmError, "the task of the arm's inverse is `pose`, not `position`"),
    ],
)
def test_what_are_no_poses(ur5, given, error, message):
    with pytest.raises(error, match=message):
        ur5.inverse(given)


def test_a_transposed_pose_is_told(ur5):
    with pytest.raises(ValueError, match="the matrix seems to be transposed: write T.T"):
        ur5.inverse(ur5.forward(Q).T)
    with pytest.raises(ValueError, match=r"the last row of a pose is \[0, 0, 0, 1\], found \[0, 0, 0, 2\]"):
        ur5.inverse(2 * np.eye(4))


def test_targets_of_another_size():
    arm = denhart.Arm.preset("anthro3r")
    with pytest.raises(ValueError, match=r"the task of this arm is position: expected 3 numbers, x, y, z, or a pose"):
        arm.inverse([0.1, 0.2])
    with pytest.raises(ValueError, match=r"expected shape \(N, 4, 4\), or \(N, 3\): x, y, z, found \(5, 2\)"):
        arm.inverse_batch(np.zeros((5, 2)))
    arm = denhart.Arm.preset("al5d")
    if arm.task == "position_angle":
        with pytest.raises(ValueError, match="a pose does not tell its angle"):
            arm.inverse(np.eye(4))


def test_numbers_that_are_not_finite(ur5):
    q = Q.copy()
    for bad in [np.nan, np.inf, 1e308]:
        q[2] = bad
        assert ur5.forward(q).shape == (4, 4)
        target = np.eye(4)
        target[0, 3] = bad
        assert not ur5.inverse(target)
    target = np.eye(4)
    target[3] = np.nan
    assert ur5.inverse(target).status == denhart.Status.BAD_TARGET


def test_options_in_words(ur5):
    with pytest.raises(ValueError, match='limits: expected "mark" .* or "drop" .*, found "no"'):
        ur5.inverse(np.eye(4), limits="no")
    with pytest.raises(ValueError, match='view: expected "front", "side", "top" or "iso", found "left"'):
        ur5.draw(view="left")
    with pytest.raises(ValueError, match='theme: expected "auto"'):
        ur5.draw(theme="blue")
    with pytest.raises(ValueError, match="size: expected width and height from 160 to 4000 px"):
        ur5.draw(size=(1e9, 3))
    with pytest.raises(ValueError, match=r"pictures are SVG: write a name that ends in \.svg"):
        ur5.draw().save("ur5.png")
    with pytest.raises(ValueError, match="expected q or solutions=, found both"):
        ur5.draw(Q, solutions=ur5.inverse(ur5.forward(Q)))
    with pytest.raises(ValueError, match="those of another arm, ur5"):
        denhart.Arm.preset("ur10").draw(solutions=ur5.inverse(ur5.forward(Q)))
    with pytest.raises(ValueError, match="sweep: this arm's inverse takes no value beside the target"):
        ur5.sweep(ur5.forward(Q), 5)
    panda = denhart.Arm.preset("franka_panda")
    with pytest.raises(ValueError, match="sweep: n has 2 of steps, and this arm's inverse takes the values q7: expected 1"):
        panda.sweep(panda.forward(np.zeros(7)), (5, 5))
    for n in [2.5, -1, "5", None]:
        with pytest.raises(TypeError, match="sweep: n: expected a whole number of steps"):
            panda.sweep(panda.forward(np.zeros(7)), n)
    with pytest.raises(ValueError, match="expected up to 1000000 values in all, found 4611686018427387904"):
        panda.sweep(panda.forward(np.zeros(7)), 2**62)
    with pytest.raises(ValueError, match="numeric: expected up to 1000000 iterations in all"):
        panda.numeric(panda.forward(np.zeros(7)), np.zeros(7), max_iterations=10**7, restarts=10**5)
    with pytest.raises(TypeError):
        ur5.inverse()


def test_mistakes_in_a_file_have_a_place(tmp_path):
    text = "name: x\nconvention: standard\nunits: {length: m, angle: deg}\njoints:\n  - {a: 0.3, alpa: 0, d: 0, theta: 0}\n"
    with pytest.raises(denhart.ArmError) as caught:
        denhart.Arm.from_yaml(text, "mine.yaml")
    message = str(caught.value)
    assert message.startswith("mine.yaml:5:14: ") and "\n   |              ^" in message and "help: " in message
    assert isinstance(caught.value, ValueError)
    path = tmp_path / "arm.yaml"
    path.write_text(text)
    with pytest.raises(denhart.ArmError, match="arm.yaml:5:14"):
        denhart.Arm.from_file(path)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(denhart.ArmError):
        denhart.Arm.from_file(path)
    with pytest.raises(FileNotFoundError, match="No such file or directory: .*none.yaml"):
        denhart.Arm.from_file(tmp_path / "none.yaml")
    with pytest.raises(IsADirectoryError):
        denhart.Arm.from_file(tmp_path)
    with pytest.raises(denhart.ArmError, match="brackets nest more than 1000 deep"):
        denhart.Arm.from_yaml("name: " + "[" * 100_000)
    mistakes = "".join(f"x{key}: 1\n" for key in range(5000))
    with pytest.raises(denhart.ArmError, match="the first 50 mistakes are shown") as caught:
        denhart.Arm.from_yaml(mistakes)
    assert str(caught.value).count("unknown key") == 50
    with pytest.raises(ValueError, match="name: expected characters of one line"):
        denhart.Arm.from_dh(a=[1.0], alpha=[0.0], d=[0.0], name="two\nlines")
    with pytest.raises(denhart.ArmError, match="no arm `ur 5`") as caught:
        denhart.Arm.preset("ur 5")
    assert "help: did you mean `ur5`? Arm.presets() lists them" in str(caught.value)


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"alpha": [0.0]}, ValueError, r"alpha: expected 2 numbers as in a, found shape \(1,\)"),
        ({"a": 1.0}, ValueError, "a: expected one number for each row"),
        ({"d": [0.0, np.nan]}, ValueError, r"d\[1\]: expected a finite number, found NaN"),
        ({"angle": "degrees"}, ValueError, 'angle: expected "rad" or "deg", found "degrees"'),
        ({"convention": "craig"}, ValueError, 'convention: expected "standard" or "modified"'),
        ({"length_unit": "ft"}, ValueError, 'length_unit: expected "m", "cm", "mm" or "in", found "ft"'),
        ({"kinds": "R"}, ValueError, "kinds: expected 2 entries as in a, found 1"),
        ({"kinds": "RX"}, ValueError, r'kinds\[1\]: expected "revolute", "prismatic" or "fixed", found "X"'),
        ({"kinds": 7}, TypeError, "kinds: expected a list"),
        ({"limits": [None]}, ValueError, "limits: expected 2 entries as in a, found 1"),
        ({"limits": (-3, 3)}, TypeError, r"limits: expected a pair .low, high. or None for each row, .* found \(-3, 3\)"),
        ({"limits": [None, (np.nan, 1)]}, ValueError, r"limits\[1\]: expected two numbers"),
        ({"limits": [None, (1, -1)]}, denhart.ArmError, "arm.yaml:6"),
        ({"task": "pos"}, denhart.ArmError, "arm.yaml:4"),
        ({"a": [], "alpha": [], "d": []}, denhart.ArmError, "joints"),
    ],
)
def test_wrong_tables(change, error, message):
    table = {"a": [0.3, 0.2], "alpha": [0.0, 0.0], "d": [0.0, 0.0]}
    with pytest.raises(error, match=message):
        denhart.Arm.from_dh(**(table | change))


def test_objects_cannot_be_changed(ur5):
    with pytest.raises(AttributeError):
        ur5.name = "other"
    with pytest.raises(TypeError):
        denhart.Arm()
    with pytest.raises(TypeError):
        denhart.Solutions()
