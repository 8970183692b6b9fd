"""Random arms: forward kinematics as numpy has them from the table, and an inverse that comes back."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

import denhart
from denhart import Flags

QUARTER = np.pi / 2


@st.composite
def tables(draw):
    rows = draw(st.integers(1, 6))
    length = st.one_of(st.just(0.0), st.floats(-1, 1).map(lambda x: round(x, 3)))
    # An arm file takes no angle below 1e-30 but 0.
    round_angle = st.floats(-3, 3).map(lambda x: round(x, 6))
    angle = st.one_of(st.sampled_from([0.0, QUARTER, -QUARTER, np.pi, np.pi / 3]), round_angle)

    def column(entry):
        return draw(st.lists(entry, min_size=rows, max_size=rows))

    return {
        "a": column(length),
        "alpha": column(angle),
        "d": column(length),
        "theta": column(angle),
        "kinds": column(st.sampled_from(["revolute", "revolute", "revolute", "prismatic"])),
        "convention": draw(st.sampled_from(["standard", "modified"])),
    }


def turn(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    matrix = np.eye(4)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    matrix[[first, first, second, second], [first, second, first, second]] = [c, -s, s, c]
    return matrix


def shift(axis, length):
    matrix = np.eye(4)
    matrix[axis, 3] = length
    return matrix


def forward(table, q):
    pose = np.eye(4)
    rows = zip(*(table[key] for key in ["a", "alpha", "d", "theta", "kinds"]), q, strict=True)
    for a, alpha, d, theta, kind, value in rows:
        d, theta = (d + value, theta) if kind == "prismatic" else (d, theta + value)
        about_z = turn(2, theta) @ shift(2, d)
        about_x = shift(0, a) @ turn(0, alpha)
        pose = pose @ (about_z @ about_x if table["convention"] == "standard" else about_x @ about_z)
    return pose


@settings(max_examples=150, deadline=None)
@given(tables(), st.lists(st.floats(-3, 3), min_size=6, max_size=6))
def test_forward_is_the_product_of_the_rows(table, q):
    arm = denhart.Arm.from_dh(**table)
    q = np.array(q[: arm.dof])
    np.testing.assert_allclose(arm.forward(q), forward(table, q), atol=1e-13)
    step = 1e-6
    jacobian = arm.jacobian(q)
    for joint in range(arm.dof):
        e = step * np.eye(arm.dof)[joint]
        plus, minus = forward(table, q + e), forward(table, q - e)
        np.testing.assert_allclose(jacobian[:3, joint], (plus - minus)[:3, 3] / (2 * step), atol=1e-8)


@settings(max_examples=100, deadline=None)
@given(tables(), st.lists(st.floats(-3, 3), min_size=6, max_size=6))
def test_what_is_exact_reaches_the_target(table, q):
    arm = denhart.Arm.from_dh(**table)
    if arm.task is None or arm.given:
        return
    q = np.array(q[: arm.dof])
    target = arm.target_at(q)
    solutions = arm.inverse(target)
    batch = arm.inverse_batch(target.values[None])
    np.testing.assert_array_equal(batch.q[0, : batch.count[0]], solutions.q)
    for solution in solutions:
        if Flags.EXACT in solution.flags and arm.task == "pose":
            np.testing.assert_allclose(forward(table, solution.q), target.values, atol=1e-8)
