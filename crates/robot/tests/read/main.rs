//! Robots in files of all kinds, and what is wrong with others.

#![expect(clippy::unwrap_used, reason = "a test")]

mod usd;

use std::f64::consts::FRAC_PI_2;
use std::path::Path;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_robot::{JointPositions, PlacedRobot, Robot, RobotFileError, Shape};
use oaktwin_scene::{Scene, Up};

const ARM: &str = include_str!("../../../../examples/robots/gripper.urdf");

/// A folder with a file, and what a reading of it gives.
pub(crate) fn open(name: &str, text: &str) -> Result<Robot, String> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    let shown = |error: RobotFileError| {
        error
            .to_string()
            .replace(&format!("{}/", folder.path().display()), "")
    };
    Robot::open(&path, &[]).map_err(shown)
}

fn urdf(text: &str) -> Result<Robot, String> {
    open("a.urdf", text)
}

fn mjcf(text: &str) -> Result<Robot, String> {
    open("a.xml", text)
}

#[test]
fn an_arm_bends_at_its_joints() {
    let robot = urdf(ARM).unwrap();
    let names: Vec<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "base",
            "turret",
            "upper",
            "fore",
            "hand",
            "left_finger",
            "right_finger"
        ]
    );
    let joints: Vec<&str> = robot.joints.iter().map(|joint| joint.name.as_str()).collect();
    assert_eq!(joints, ["turn", "shoulder", "elbow", "grip", "grip_right"]);
    assert_eq!(robot.rest(), [0.0, 0.0, 0.5 * (0.2 + 2.6), 0.0, 0.001]);

    // The upper arm points up and the forearm forward.
    let positions = robot.followed(vec![0.0, 0.0, FRAC_PI_2, 0.03, 9.0]);
    let links = robot.base_from_links(&positions);
    let near = |pose: &RigidTransform, x, y, z| pose.translation.abs_diff_eq(DVec3::new(x, y, z), 1e-12);
    assert!(near(&links[3], 0.0, 0.0, 0.5), "{:?}", links[3]);
    assert!(near(&links[4], 0.35, 0.0, 0.5), "{:?}", links[4]);
    assert!(
        links[4]
            .rotation
            .abs_diff_eq(DMat3::from_cols(DVec3::NEG_Z, DVec3::Y, DVec3::X), 1e-12)
    );
    // The right finger follows the left one: 0.5 · 0.03 + 0.001.
    assert_eq!(positions[4], 0.016);
    assert!(near(&links[5], 0.43, 0.04, 0.5), "{:?}", links[5]);
    assert!(near(&links[6], 0.43, -0.026, 0.5), "{:?}", links[6]);
}

#[test]
fn a_robot_stands_in_a_scene() {
    let robot = urdf(ARM).unwrap();
    let mut scene = Scene {
        up: Up::Y,
        ..Scene::default()
    };
    let (placed, findings) = PlacedRobot::new(robot.clone(), &mut scene, None).unwrap();
    assert_eq!(findings, []);
    assert_eq!(placed.path(), "/arm");
    let paths: Vec<&str> = scene
        .instances
        .iter()
        .map(|instance| instance.path.as_str())
        .collect();
    assert_eq!(paths[..2], ["/arm/base/visual_0", "/arm/upper/visual_0"]);
    assert_eq!(placed.link_of(1), robot.link("upper"));
    assert_eq!(placed.link_of(99), None);
    // Upright: its z axis is the scene's y axis. The upper arm is 0.3 m long, and its centre 0.35 m above the floor.
    let links = placed.world_from_links(&robot.rest());
    let poses: Vec<_> = placed.poses(&links).collect();
    let centre = poses[1].1.transform_point3(DVec3::ZERO);
    assert!(centre.abs_diff_eq(DVec3::new(0.0, 0.35, 0.0), 1e-9), "{centre}");
    assert_eq!(scene.instances[1].world_from_mesh, poses[1].1);
    // A second robot of the same name.
    let (second, _) = PlacedRobot::new(robot, &mut scene, Some(RigidTransform::IDENTITY)).unwrap();
    assert_eq!(second.path(), "/arm_2");
    assert_eq!(second.link_of(1), None);
    let error = second.mount("uper").unwrap_err().to_string();
    assert!(error.contains("no link 'uper'; did you mean 'upper'?"), "{error}");
}

#[test]
fn packages_are_found_around_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let write = |path: &str, text: &str| {
        let path = folder.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
        path
    };
    write("ws/parts/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let of = |name: &str| {
        format!(
            "<robot><link name='a'><visual><geometry><mesh filename='{name}'/></geometry></visual></link></robot>"
        )
    };
    let robot = write("ws/description/urdf/r.urdf", &of("package://parts/a.obj"));
    let file = |robot: Robot| match &robot.links[0].visuals[0].shape {
        Shape::Mesh { file, .. } => file.clone(),
        other => panic!("{other:?}"),
    };
    let expected = folder.path().join("ws/parts/a.obj");
    assert_eq!(file(Robot::open(&robot, &[]).unwrap()), expected);
    write("ws/description/urdf/r.urdf", &of("../../parts/a.obj"));
    assert_eq!(
        file(Robot::open(&robot, &[]).unwrap()).canonicalize().unwrap(),
        expected.canonicalize().unwrap()
    );
    write("elsewhere/other/a.obj", "");
    write("ws/description/urdf/r.urdf", &of("package://other/a.obj"));
    let error = Robot::open(&robot, &[]).unwrap_err().to_string();
    assert!(
        error.contains("give the folder that contains other with --packages"),
        "{error}"
    );
    let given = [folder.path().join("elsewhere")];
    assert!(file(Robot::open(&robot, &given).unwrap()).ends_with("other/a.obj"));
}

#[test]
fn what_is_not_supported_is_found() {
    let codes = |robot: Robot| -> Vec<&str> { robot.findings.iter().map(|finding| finding.code).collect() };
    let mesh =
        "<robot><link name='a'><visual><geometry><mesh filename='a.3ds'/></geometry></visual></link></robot>";
    assert_eq!(codes(urdf(mesh).unwrap()), ["mesh-format"]);
    assert_eq!(urdf(mesh).unwrap().links[0].visuals, []);
    let with_collision = mesh.replace(
        "</visual>",
        "</visual><collision><geometry><sphere radius='1'/></geometry></collision>",
    );
    let robot = urdf(&with_collision).unwrap();
    assert_eq!(robot.links[0].visuals[0].shape, Shape::Ellipsoid(DVec3::ONE));
    let joint = "<robot><link name='a'/><link name='b'/><joint name='j' type='floating'><parent link='a'/><child link='b'/></joint></robot>";
    assert_eq!(codes(urdf(joint).unwrap()), ["joint-unsupported"]);
    for (inside, expected) in [
        ("<body><joint type='ball'/></body>", "joint-unsupported"),
        ("<body><freejoint/></body>", "free-joint"),
        (
            "<body><geom type='hfield' hfield='a'/></body>",
            "geom-unsupported",
        ),
        ("<body><replicate count='3'/></body>", "mjcf-unsupported"),
        ("<body><geom group='3' size='1'/></body>", "geom-groups"),
    ] {
        let text = format!("<mujoco><worldbody>{inside}</worldbody></mujoco>");
        assert_eq!(codes(mjcf(&text).unwrap()), [expected]);
    }
}

#[test]
#[expect(clippy::too_many_lines, reason = "a table of mistakes")]
fn errors_name_the_file_the_place_and_the_remedy() {
    let joint = |inside: &str| format!("<robot>\n<link name='base'/><link name='tip'/>\n{inside}</robot>");
    let fixed = "<joint name='j' type='fixed'><parent link='base'/><child link='tip'/></joint>";
    let circle = "<joint name='k' type='fixed'><parent link='tip'/><child link='base'/></joint>";
    let geometry = |inside: &str| {
        format!("<robot><link name='a'><visual><geometry>{inside}</geometry></visual></link></robot>")
    };
    let cases = [
        (String::new(), "a.urdf: line 1: there is no element"),
        ("<robot><link name='a'>".to_owned(), "is not closed"),
        (
            "<sdf/>".to_owned(),
            "a robot begins with <robot> or <mujoco>, not with <sdf>",
        ),
        (
            joint(&fixed.replace("base", "bse")),
            "line 3: <joint name=\"j\">: there is no link 'bse'; did you mean 'base'?",
        ),
        (joint(&format!("{fixed}\n{circle}")), "no link is the base"),
        (joint(""), "line 2: <link name=\"tip\">: is a second base"),
        (joint(&format!("{fixed}{fixed}")), "two joints of this name"),
        (
            joint(&format!("{fixed}{}", fixed.replace("'j'", "'k'"))),
            "already the child of the joint 'j'",
        ),
        (joint(&fixed.replace("fixed", "hinge")), "unknown type 'hinge'"),
        (
            joint(
                &fixed
                    .replace("fixed", "revolute")
                    .replace("</joint>", "<axis xyz='0 0 0'/></joint>"),
            ),
            "the axis has no direction",
        ),
        (
            joint(
                &fixed
                    .replace("fixed", "revolute")
                    .replace("</joint>", "<limit lower='2' upper='1'/></joint>"),
            ),
            "the limit 2 is above 1",
        ),
        (
            joint(&fixed.replace("fixed", "revolute").replace(
                "</joint>",
                "<limit lower='0' upper='1'/><mimic joint='j'/></joint>",
            )),
            "follow each other in a circle",
        ),
        (
            joint(&fixed.replace("</joint>", "<origin xyz='0 0 nan'/></joint>")),
            "'nan' is not a finite number",
        ),
        (
            joint(&fixed.replace("</joint>", "<origin xyz='0 0'/></joint>")),
            "xyz has 2 numbers; give 3",
        ),
        (
            geometry("<box size='1 1 0'/>"),
            "size must be three numbers above 0",
        ),
        (
            geometry("<spere radius='1'/>"),
            "unknown shape <spere>; did you mean 'sphere'?",
        ),
        (
            geometry("<mesh filename='meshes/a.stl'/>"),
            "there is no file meshes/a.stl; copy it there",
        ),
        (
            "<robot xmlns:xacro='x'><xacro:arm/></robot>".to_owned(),
            "expand them: xacro FILE > robot.urdf",
        ),
    ];
    for (text, expected) in cases {
        let error = urdf(&text).unwrap_err();
        assert!(
            error.contains(expected) && error.contains("; "),
            "{text}\n{error}"
        );
    }
    let body =
        |inside: &str| format!("<mujoco><worldbody>\n<body name='a'>{inside}</body></worldbody></mujoco>");
    for (text, expected) in [
        (
            body("<geom class='big' size='1'/>"),
            "line 2: <geom>: there is no class 'big'",
        ),
        (body("<geom type='mesh' mesh='hand'/>"), "there is no mesh 'hand'"),
        (
            body("<geom material='red' size='1'/>"),
            "there is no material 'red'",
        ),
        (
            body("<geom type='box' size='1 1'/>"),
            "size 3 of a box must be above 0",
        ),
        (body("<joint axis='0 0 0'/>"), "the axis has no direction"),
        (body("<joint range='2 1'/>"), "range: 2 is above 1"),
        (body("<body name='a'/>"), "two bodies of this name"),
        (
            body("<geom fromto='0 0 0 0 0 0' type='capsule' size='1'/>"),
            "both points are the same",
        ),
        (
            "<mujoco><include file='b.xml'/></mujoco>".to_owned(),
            "there is no file b.xml",
        ),
        (
            "<mujoco><include file='a.xml'/></mujoco>".to_owned(),
            "remove the <include> of a file in itself",
        ),
        (
            "<mujoco><compiler eulerseq='xyw'/></mujoco>".to_owned(),
            "'xyw' is not three of",
        ),
        (
            "<mujoco><compiler angle='grad'/></mujoco>".to_owned(),
            "unknown unit 'grad'",
        ),
    ] {
        let error = mjcf(&text)
            .unwrap_err()
            .replace(&format!("{}/", std::env::temp_dir().display()), "");
        assert!(
            error.contains(expected) || expected.contains("b.xml") && error.contains("b.xml"),
            "{text}\n{error}"
        );
    }
}

#[test]
fn tables_of_positions_are_checked() {
    let robot = urdf(ARM).unwrap();
    let of = |text: &str| {
        JointPositions::parse(Path::new("p.csv"), text.as_bytes(), &robot).map_err(|error| error.to_string())
    };
    let read = of("\u{feff}time, elbow_deg ,turn\n# a comment\n0.5,90,-1\n1.5,45,7\n").unwrap();
    assert_eq!(read.times_s, [Some(0.5), Some(1.5)]);
    assert_eq!(read.positions[0][..3], [-1.0, 0.0, FRAC_PI_2]);
    assert_eq!(read.positions[1][0], 7.0);
    assert_eq!(read.at_rest, ["shoulder", "grip"]);
    for (text, expected) in [
        ("", "p.csv: line 1: there are no positions"),
        ("turn\n", "there are no positions"),
        ("trn\n1\n", "line 1: no joint 'trn' moves; did you mean 'turn'?"),
        ("turn,turn\n1,1\n", "'turn' is there twice"),
        ("elbow,elbow_deg\n1,1\n", "'elbow_deg' is there twice"),
        (
            "grip_right\n0\n",
            "the joint 'grip_right' follows 'grip'; remove the column",
        ),
        ("turn,elbow\n0,1\n1\n", "line 3: 1 values, but 2 columns"),
        ("turn\nnan\n", "line 2: turn: 'nan' is not a finite number"),
        (
            "elbow\n3\n",
            "line 2: elbow is 3 rad, outside its limits; give 0.2 to 2.6 rad",
        ),
        (
            "grip\n0.05\n",
            "grip is 0.05 m, outside its limits; give 0 to 0.04 m",
        ),
    ] {
        let error = of(text).unwrap_err();
        assert!(error.contains(expected), "{text:?}: {error}");
    }
}
