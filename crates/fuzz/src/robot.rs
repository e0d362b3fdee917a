//! Robots: their files, and the positions of their joints.

use std::path::Path;

use oaktwin::robot::{JointPositions, PlacedRobot, Robot};
use oaktwin_scene::Scene;

use crate::{file, scene};

/// A robot, a zero byte, and the positions of its joints. The first byte selects the format.
pub(crate) fn check(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else {
        return;
    };
    let at = rest.iter().position(|&byte| byte == 0);
    let (robot, table) = rest.split_at(at.unwrap_or(rest.len()));
    let name = if first % 2 == 0 { "x.urdf" } else { "x.xml" };
    match file::with(name, robot, |path| Robot::open(path, &[])) {
        Ok(robot) => moved(robot, table.get(1..).unwrap_or_default()),
        Err(error) => assert!(error.to_string().contains(name), "{error}"),
    }
}

/// Moves a robot to the positions of a table. Its links stay at finite places.
fn moved(robot: Robot, table: &[u8]) {
    let positions = match JointPositions::parse(Path::new("joints.csv"), table, &robot) {
        Ok(positions) => positions,
        Err(error) => {
            assert!(error.to_string().contains("joints.csv"), "{error}");
            JointPositions::rest(&robot)
        }
    };
    let mut empty = Scene::default();
    let Ok((placed, _)) = PlacedRobot::new(robot, &mut empty, None) else {
        return;
    };
    for positions in &positions.positions {
        for pose in placed.world_from_links(positions) {
            assert!(
                pose.rotation.is_finite() && pose.translation.is_finite(),
                "{pose:?}"
            );
        }
    }
    scene::check(&empty);
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let urdf = br#"<robot name="r">
  <material name="m"><color rgba="1 0 0 1"/></material>
  <link name="a"><visual><origin xyz="0 0 1" rpy="0 0.5 0"/><geometry><box size="1 2 3"/></geometry><material name="m"/></visual></link>
  <link name="b"><visual><geometry><cylinder radius="0.1" length="1"/></geometry></visual></link>
  <link name="c"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="-1" upper="2"/></joint>
  <joint name="k" type="prismatic"><parent link="b"/><child link="c"/><limit lower="0" upper="1"/><mimic joint="j" multiplier="2" offset="1"/></joint>
</robot>"#;
    let mjcf = br#"<mujoco model="r"><compiler angle="radian"/>
  <default><geom rgba="1 0 0 1"/><default class="d"><joint axis="0 1 0" range="-1 1"/></default></default>
  <worldbody><geom type="plane" size="1 1 1"/>
    <body name="a" pos="0 0 1" euler="0 0 1"><joint name="j" class="d"/><geom type="capsule" fromto="0 0 0 1 0 0" size="0.1"/>
      <body name="b" quat="1 0 0 1"><joint name="k" type="slide" range="0 1"/><geom type="ellipsoid" size="1 2 3"/></body></body></worldbody></mujoco>"#;
    [(0, &urdf[..]), (1, &mjcf[..])]
        .map(|(kind, text)| [&[kind], text, b"\0time,j\n0,0.5\n1,-0.5\n"].concat())
        .into()
}
