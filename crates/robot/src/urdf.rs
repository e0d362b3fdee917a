//! URDF with the frames of the vendor's ROS package (luxonis/depthai-ros, `depthai_descriptions`): `oak`, `oak_left_camera_frame`,
//! `oak_left_camera_optical_frame`, `oak_imu_frame`. Each depth sensor also has a frame, its rectified camera's.

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DMat3;

use crate::description::{CameraFrame, Description, roll_pitch_yaw};
use crate::frame::DeviceFrame;
use crate::xml::{XmlElement, number, numbers};
use crate::{Housing, RobotFiles};

/// The parts of names and paths that differ between the plain file and the macro.
struct Names<'a> {
    device: &'a str,
    meshes: &'a str,
}

pub(crate) fn export(of: &Description) -> RobotFiles {
    let mut export = RobotFiles::with_visuals(of).with_collider(of);
    export.text(format!("{}.urdf", of.name), plain(of));
    export.text(format!("{}.urdf.xacro", of.id), xacro(of));
    export
}

fn plain(of: &Description) -> String {
    let names = Names {
        device: &of.name,
        meshes: "meshes",
    };
    let mut robot = XmlElement::new("robot")
        .set("name", &of.name)
        .commented(&of.title);
    if let Some(parent) = &of.parent {
        robot = robot
            .with(XmlElement::new("link").set("name", parent))
            .with(attached(&names, parent, origin(&of.parent_from_body)));
    }
    robot.with_all(links(of, &names)).document()
}

fn xacro(of: &Description) -> String {
    let names = Names {
        device: "${name}",
        meshes: "${meshes}",
    };
    let macro_of_model = XmlElement::new("xacro:macro")
        .set("name", &of.id)
        .set("params", format!("parent *origin name:={} meshes:=meshes", of.name))
        .commented(format!(
            "{}: the origin is the pose of the camera frame in the parent link; `meshes` is the folder of the meshes, such as \
             package://my_robot/meshes.",
            of.title
        ))
        .with(attached(
            &names,
            "${parent}",
            XmlElement::new("xacro:insert_block").set("name", "origin"),
        ))
        .with_all(links(of, &names));
    XmlElement::new("robot")
        .set("xmlns:xacro", "http://www.ros.org/wiki/xacro")
        .with(macro_of_model)
        .document()
}

/// Returns the joint to the parent.
fn attached(names: &Names<'_>, parent: &str, origin: XmlElement) -> XmlElement {
    joint(
        &format!("{}_center_joint", names.device),
        parent,
        names.device,
        origin,
    )
}

fn links(of: &Description, names: &Names<'_>) -> Vec<XmlElement> {
    let device = names.device;
    let model = format!("{device}_model_origin");
    let mut links = vec![
        XmlElement::new("link").set("name", device),
        housing(of, names).set("name", &model),
        joint(
            &format!("{model}_joint"),
            device,
            &model,
            origin(&RigidTransform::IDENTITY),
        ),
    ];
    for camera in of.all_cameras() {
        links.extend(camera_links(camera, device));
    }
    if let Some(imu) = of.imu_frame(device) {
        links.extend(link(&format!("{device}_imu_joint"), &imu));
    }
    links
}

/// Returns the frames of a camera and of its image.
fn camera_links(camera: &CameraFrame, device: &str) -> [XmlElement; 4] {
    let name = format!("{device}_{}_camera", camera.role);
    let [frame, optical] = camera.frames(device);
    let [link_of_frame, joint_of_frame] = link(&format!("{name}_joint"), &frame);
    let [link_of_optical, joint_of_optical] = link(&format!("{name}_optical_joint"), &optical);
    [link_of_frame, joint_of_frame, link_of_optical, joint_of_optical]
}

/// Returns the link of a frame and the joint to the frame that carries it.
fn link(joint_name: &str, frame: &DeviceFrame) -> [XmlElement; 2] {
    [
        XmlElement::new("link").set("name", &frame.name),
        joint(
            joint_name,
            &frame.parent,
            &frame.name,
            origin(&frame.parent_from_frame),
        ),
    ]
}

/// Returns the link with the meshes and the mass, without a name.
fn housing(of: &Description, names: &Names<'_>) -> XmlElement {
    let Housing {
        visuals,
        centre,
        mass,
        inertia,
        ..
    } = &of.housing;
    let mesh = |file: String| {
        let file = format!("{}/{file}", names.meshes);
        XmlElement::new("geometry").with(XmlElement::new("mesh").set("filename", file))
    };
    let inertial = XmlElement::new("inertial")
        .commented("A solid cuboid with the dimensions and the mass of the device.")
        .with(origin(&RigidTransform::new(DMat3::IDENTITY, *centre)))
        .with(XmlElement::new("mass").set("value", number(*mass)))
        .with(
            XmlElement::new("inertia")
                .set("ixx", format!("{:e}", inertia.x))
                .set("ixy", "0")
                .set("ixz", "0")
                .set("iyy", format!("{:e}", inertia.y))
                .set("iyz", "0")
                .set("izz", format!("{:e}", inertia.z)),
        );
    let visuals = visuals.iter().map(|visual| {
        let [r, g, b] = visual.color.map(f64::from);
        XmlElement::new("visual").with(mesh(of.visual_file(visual))).with(
            XmlElement::new("material")
                .set("name", format!("{}_{}", names.device, visual.name))
                .with(XmlElement::new("color").set("rgba", numbers([r, g, b, 1.0]))),
        )
    });
    XmlElement::new("link")
        .with(inertial)
        .with_all(visuals)
        .with(XmlElement::new("collision").with(mesh(of.collider_file())))
}

fn joint(name: &str, parent: &str, child: &str, origin: XmlElement) -> XmlElement {
    XmlElement::new("joint")
        .set("name", name)
        .set("type", "fixed")
        .with(XmlElement::new("parent").set("link", parent))
        .with(XmlElement::new("child").set("link", child))
        .with(origin)
}

fn origin(pose: &RigidTransform) -> XmlElement {
    XmlElement::new("origin")
        .set("xyz", numbers(pose.translation.to_array()))
        .set("rpy", numbers(roll_pitch_yaw(&pose.rotation).to_array()))
}
