//! Robots of `UsdPhysics`.

use std::f64::consts::FRAC_PI_2;

use oaktwin_base::diagnostic::Level;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_robot::{PlacedRobot, Robot};
use oaktwin_scene::{Scene, Up};

use crate::open;

/// An arm in centimetres that stands upright: 20 to the shoulder, 30 to the elbow, 30 to the tip, whose joint begins at the tip.
const ARM: &str = r#"#usda 1.0
(
    defaultPrim = "Arm"
    metersPerUnit = 0.01
    upAxis = "Z"
)
def Xform "Arm" (prepend apiSchemas = ["PhysicsArticulationRootAPI"])
{
    def Xform "base" (prepend apiSchemas = ["PhysicsRigidBodyAPI"])
    {
        def Cube "shape" { double size = 10 }
    }
    def Xform "upper" (prepend apiSchemas = ["PhysicsRigidBodyAPI"])
    {
        double3 xformOp:translate = (0, 0, 20)
        float3 xformOp:scale = (1, 1, 2)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
        def Xform "visuals" { def Cube "shape" { double size = 2 } }
    }
    def Xform "fore" (prepend apiSchemas = ["PhysicsRigidBodyAPI"])
    {
        double3 xformOp:translate = (0, 0, 50)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
    def Xform "tip" (prepend apiSchemas = ["PhysicsRigidBodyAPI"])
    {
        double3 xformOp:translate = (0, 0, 80)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        def Sphere "ball" { double radius = 1 }
    }
    def Cube "table" { double size = 4 }
    def Scope "joints"
    {
        def PhysicsFixedJoint "root" { rel physics:body1 = </Arm/base> }
        def PhysicsRevoluteJoint "shoulder"
        {
            uniform token physics:axis = "Y"
            rel physics:body0 = </Arm/base>
            rel physics:body1 = </Arm/upper>
            point3f physics:localPos0 = (0, 0, 20)
            float physics:lowerLimit = -90
            float physics:upperLimit = 90
        }
        def PhysicsRevoluteJoint "elbow"
        {
            uniform token physics:axis = "X"
            rel physics:body0 = </Arm/upper>
            rel physics:body1 = </Arm/fore>
            point3f physics:localPos0 = (0, 0, 15)
            quatf physics:localRot0 = (0.70710678, 0, 0, 0.70710678)
            quatf physics:localRot1 = (0.70710678, 0, 0, 0.70710678)
        }
        def PhysicsPrismaticJoint "slide"
        {
            uniform token physics:axis = "Z"
            rel physics:body0 = </Arm/tip>
            rel physics:body1 = </Arm/fore>
            point3f physics:localPos1 = (0, 0, 30)
            float physics:lowerLimit = -10
            float physics:upperLimit = 20
        }
    }
}
"#;

fn usda(text: &str) -> Result<Robot, String> {
    open("a.usda", text)
}

fn codes(robot: &Robot) -> Vec<(&str, Level)> {
    robot.findings.iter().map(|one| (one.code, one.level)).collect()
}

/// The places of upper arm, forearm and tip by trigonometry.
fn places(shoulder: f64, elbow: f64, slide: f64) -> [DVec3; 3] {
    let along = |angle: f64, length: f64| DVec3::new(angle.sin(), 0.0, angle.cos()) * length;
    let upper = DVec3::new(0.0, 0.0, 0.2);
    let fore = upper + along(shoulder, 0.3);
    [upper, fore, fore + along(shoulder + elbow, 0.3 - slide)]
}

#[test]
fn an_arm_of_a_stage_moves() {
    let robot = usda(ARM).unwrap();
    assert_eq!(codes(&robot), []);
    assert_eq!(robot.name, "Arm");
    let links: Vec<_> = robot
        .links
        .iter()
        .map(|link| (link.name.as_str(), link.is_world))
        .collect();
    let expected = [
        ("world", true),
        ("base", false),
        ("upper", false),
        ("fore", false),
        ("tip", false),
    ];
    assert_eq!(links, expected);
    let joints: Vec<_> = robot
        .joints
        .iter()
        .map(|one| (one.name.as_str(), one.limits))
        .collect();
    assert_eq!(joints[0], ("shoulder", Some([-FRAC_PI_2, FRAC_PI_2])));
    assert_eq!(joints[1], ("elbow", None));
    assert_eq!(joints[2].0, "slide");
    assert!(
        joints[2]
            .1
            .unwrap()
            .iter()
            .zip([-0.1, 0.2])
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
    assert_eq!(robot.rest(), [0.0, 0.0, 0.0]);
    for positions in [[0.0, 0.0, 0.0], [0.4, -1.1, 0.13], [-1.5, 2.9, -0.1]] {
        let poses = robot.base_from_links(&positions);
        let [shoulder, elbow, slide] = positions;
        for (pose, place) in poses[2..].iter().zip(places(shoulder, elbow, slide)) {
            assert!(
                pose.translation.abs_diff_eq(place, 1e-7),
                "{positions:?}: {pose:?}, not {place}"
            );
        }
        let turned = DMat3::from_rotation_y(shoulder + elbow);
        assert!(poses[4].rotation.abs_diff_eq(turned, 1e-7));
    }
}

#[test]
fn shapes_follow_their_bodies() {
    let robot = usda(ARM).unwrap();
    let mut scene = Scene {
        up: Up::Y,
        ..Scene::default()
    };
    let (placed, findings) = PlacedRobot::new(robot, &mut scene, None).unwrap();
    assert_eq!(findings, []);
    let paths: Vec<&str> = scene.instances.iter().map(|one| one.path.as_str()).collect();
    assert_eq!(
        paths,
        [
            "/Arm/world/Arm/table",
            "/Arm/base/shape",
            "/Arm/upper/visuals/shape",
            "/Arm/tip/ball"
        ]
    );
    let link_of: Vec<_> = (0..4).map(|at| placed.link_of(at)).collect();
    assert_eq!(link_of, [None, Some(1), Some(2), Some(4)]);
    // Upright in a scene with y up: x stays, z becomes y.
    let positions = [0.7, 0.2, 0.05];
    let links = placed.world_from_links(&positions);
    let poses: Vec<_> = placed.poses(&links).map(|(_, pose)| pose).collect();
    let [_, _, tip] = places(0.7, 0.2, 0.05);
    let expected = DVec3::new(tip.x, tip.z, -tip.y);
    assert!(poses[3].translation.abs_diff_eq(expected, 1e-7), "{:?}", poses[3]);
    // The upper arm's cube is 2 × 2 × 4 cm: the scale of its prim.
    let corner =
        poses[2].transform_vector3(DVec3::Z).length() / poses[2].transform_vector3(DVec3::X).length();
    assert!((corner - 2.0).abs() < 1e-9, "{corner}");
}

#[test]
fn a_stage_with_y_up_stands_upright() {
    let sideways = ARM.replace("upAxis = \"Z\"", "upAxis = \"Y\"");
    let robot = usda(&sideways).unwrap();
    let poses = robot.base_from_links(&robot.rest());
    // Along the stage's z axis, which is the base's −y axis.
    assert!(
        poses[4].translation.abs_diff_eq(DVec3::new(0.0, -0.8, 0.0), 1e-9),
        "{:?}",
        poses[4]
    );
}

#[test]
fn a_posed_stage_rests_in_its_posture() {
    // The forearm and the tip are turned by 30° at the elbow.
    let (sine, cosine) = 30f64.to_radians().sin_cos();
    let turn = "float xformOp:rotateY = 30\n        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateY\"]";
    let order = "uniform token[] xformOpOrder = [\"xformOp:translate\"]";
    let (x, z) = (30.0 * sine, 50.0 + 30.0 * cosine);
    let posed = ARM
        .replace(order, turn)
        .replace("(0, 0, 80)", &format!("({x}, 0, {z})"));
    let robot = usda(&posed).unwrap();
    assert_eq!(codes(&robot), []);
    let rest = robot.rest();
    assert!(
        (rest[1] - 30f64.to_radians()).abs() < 1e-6 && rest[2] == 0.0,
        "{rest:?}"
    );
    for positions in [rest, vec![0.4, -1.1, 0.13]] {
        let poses = robot.base_from_links(&positions);
        let [_, _, tip] = places(positions[0], positions[1], positions[2]);
        assert!(
            poses[4].translation.abs_diff_eq(tip, 1e-6),
            "{positions:?}: {:?}, not {tip}",
            poses[4]
        );
    }
}

#[test]
fn what_is_wrong_with_joints_is_found() {
    let changed = |from: &str, to: &str| {
        assert!(ARM.contains(from), "{from}");
        usda(&ARM.replace(from, to)).unwrap()
    };
    let spherical = changed(
        "PhysicsRevoluteJoint \"elbow\"",
        "PhysicsSphericalJoint \"elbow\"",
    );
    assert_eq!(codes(&spherical), [("usd-joint", Level::Warning)]);
    assert_eq!(spherical.joints.len(), 2);
    assert_eq!(
        spherical.base_from_links(&[0.0, 0.0])[3].translation,
        DVec3::new(0.0, 0.0, 0.5)
    );
    let loop_closed = changed(
        "        def PhysicsPrismaticJoint",
        "        def PhysicsFixedJoint \"closing\" { rel physics:body0 = </Arm/base>\n rel physics:body1 = </Arm/tip> }\n        def PhysicsPrismaticJoint",
    );
    assert_eq!(codes(&loop_closed).last(), Some(&("usd-joint", Level::Warning)));
    let excluded = changed(
        "        def PhysicsPrismaticJoint",
        "        def PhysicsFixedJoint \"closing\" { bool physics:excludeFromArticulation = 1\n rel physics:body0 = </Arm/base>\n rel physics:body1 = </Arm/tip> }\n        def PhysicsPrismaticJoint",
    );
    assert_eq!(codes(&excluded), [("usd-joint", Level::Note)]);
    assert_eq!(
        codes(&changed("</Arm/tip>\n", "</Arm/tap>\n"))[0],
        ("joint-body", Level::Warning)
    );
    assert_eq!(
        codes(&changed("localPos1 = (0, 0, 30)", "localPos1 = (0, 5, 30)")),
        [("usd-joint", Level::Note)]
    );
    assert_eq!(
        codes(&changed("float physics:lowerLimit = -90\n", "")),
        [("usd-joint", Level::Note)]
    );
    assert_eq!(codes(&changed("= -90", "= 100")), [("usd-joint", Level::Warning)]);
    assert_eq!(
        codes(&changed(
            "(0.70710678, 0, 0, 0.70710678)\n            quatf",
            "(0, 0, 0, 0)\n            quatf"
        ))[0],
        ("joint-frame", Level::Warning)
    );
    assert_eq!(
        codes(&changed(
            "token physics:axis = \"Z\"",
            "token physics:axis = \"rotZ\""
        ))[0],
        ("joint-axis", Level::Warning)
    );
    let mimic = changed(
        "float physics:lowerLimit = -10",
        "rel newton:mimicJoint = </Arm/joints/elbow>\n float physics:lowerLimit = -10",
    );
    assert_eq!(codes(&mimic), [("usd-joint", Level::Warning)]);
    // A joint that is off leaves its body where it is.
    let off = changed(
        "uniform token physics:axis = \"Z\"",
        "uniform token physics:axis = \"Z\"\n bool physics:jointEnabled = 0",
    );
    assert_eq!((codes(&off), off.joints.len(), off.links.len()), (vec![], 2, 5));
    assert_eq!(
        off.base_from_links(&[0.3, 0.1])[4],
        RigidTransform::new(DMat3::IDENTITY, DVec3::new(0.0, 0.0, 0.8))
    );
}

#[test]
fn a_stage_without_joints_is_an_error() {
    let error = usda("#usda 1.0\ndef Cube \"a\" {}\n").unwrap_err();
    assert_eq!(
        error,
        "a.usda: stage: has no PhysicsRevoluteJoint or PhysicsPrismaticJoint that moves it; give an animated stage as the scene, and mount the OAK on its prim: --mount /World/Robot/hand"
    );
    let error = usda("#usda 1.0\ndef Cube \"a\" {").unwrap_err();
    assert!(error.starts_with("a.usda: "), "{error}");
}
