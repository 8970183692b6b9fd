"""Arms from URDFs, and libraries for C."""

import numpy as np
import pytest

import denhart

URDF = """<robot name="elbow">
  <link name="base"/> <link name="upper"/> <link name="lower"/> <link name="flange"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/> <child link="upper"/> <axis xyz="0 0 1"/> <limit lower="-2" upper="2"/>
  </joint>
  <joint name="elbow" type="continuous">
    <parent link="upper"/> <child link="lower"/> <origin xyz="0.3 0 0"/> <axis xyz="0 0 -1"/>
  </joint>
  <joint name="end" type="fixed">
    <parent link="lower"/> <child link="flange"/> <origin xyz="0.2 0 0"/>
  </joint>
</robot>"""


def test_a_urdf(tmp_path):
    path = tmp_path / "elbow.urdf"
    path.write_text(URDF)
    arm = denhart.Arm.from_urdf(path)
    assert (arm.joint_names, arm.length_unit) == (("shoulder", "elbow"), "m")
    np.testing.assert_array_equal(arm.limits[0], [-2, 2])
    # The elbow turns the other way.
    x, y = 0.3 * np.cos(0.4) + 0.2 * np.cos(-0.5), 0.3 * np.sin(0.4) + 0.2 * np.sin(-0.5)
    np.testing.assert_allclose(arm.forward([0.4, 0.9])[:3, 3], [x, y, 0], atol=1e-15)
    one = denhart.Arm.from_urdf(str(path), base="upper", tool="flange")
    assert one.joint_names == ("elbow",)
    with pytest.raises(denhart.ArmError, match="flang") as caught:
        denhart.Arm.from_urdf(path, tool="flang")
    assert "--tool" not in str(caught.value) and "flange" in str(caught.value)
    path.write_text("<robot>")
    with pytest.raises(denhart.ArmError):
        denhart.Arm.from_urdf(path)
    with pytest.raises(FileNotFoundError):
        denhart.Arm.from_urdf(tmp_path / "none.urdf")


def test_a_library_for_c(ur5):
    files = ur5.to_c(scalar="f32", prefix="arm")
    assert {"Cargo.toml", "CMakeLists.txt", "src/lib.rs", "src/arm.rs", "include/arm.h"} == set(files)
    assert "arm_inverse(" in files["include/arm.h"]
    with pytest.raises(ValueError, match='scalar: expected "f64" or "f32", found "double"'):
        ur5.to_c(scalar="double")
    with pytest.raises(denhart.ArmError, match="^prefix: `no name` cannot name a library for C"):
        ur5.to_c(prefix="no name")
