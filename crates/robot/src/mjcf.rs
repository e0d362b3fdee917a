//! MJCF for `MuJoCo`: a body to attach to a robot.
//!
//! `principalpixel` has the sign that `MuJoCo`'s renderer has since version 3.6: "20 0" moves the optical axis 20 pixels to the left of the
//! centre, so the principal point (cx, cy) from the upper left border is written as (W/2 − cx, H/2 − cy).

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_imu::ChannelNoise;

use crate::description::{CameraFrame, Description, IMU_RATE};
use crate::xml::{XmlElement, number, numbers};
use crate::{Housing, RobotFiles};

/// The axes of `MuJoCo`'s cameras (x right, y up, z backward) in an optical frame.
pub(crate) const OPTICAL_FROM_OPENGL: DMat3 = DMat3::from_cols(DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z);

pub(crate) fn export(of: &Description) -> RobotFiles {
    let mut export = RobotFiles::with_visuals(of).with_collider(of);
    export.text(format!("{}.xml", of.name), model(of).document());
    export
}

fn model(of: &Description) -> XmlElement {
    let mut assets = XmlElement::new("asset");
    for visual in &of.housing.visuals {
        let [r, g, b] = visual.color.map(f64::from);
        assets = assets
            .with(
                XmlElement::new("mesh")
                    .set("name", format!("{}_{}", of.name, visual.name))
                    .set("file", of.visual_file(visual))
                    // The housing is a shell of closed parts that overlap.
                    .set("inertia", "shell"),
            )
            .with(
                XmlElement::new("material")
                    .set("name", format!("{}_{}", of.name, visual.name))
                    .set("rgba", numbers([r, g, b, 1.0])),
            );
    }
    let assets = assets.with(
        XmlElement::new("mesh")
            .set("name", format!("{}_collider", of.name))
            .set("file", of.collider_file()),
    );
    let mut sensors = XmlElement::new("sensor");
    let site = format!("{}_imu", of.name);
    if let Some(imu) = &of.imu {
        sensors = sensors
            .with(inertial_sensor(
                "accelerometer",
                "accel",
                &site,
                imu.accelerometer.as_ref(),
            ))
            .with(inertial_sensor("gyro", "gyro", &site, imu.gyroscope.as_ref()));
    }
    let model = XmlElement::new("mujoco")
        .set("model", &of.name)
        .commented(format!(
            "{}, for MuJoCo 3.6 and newer: older versions read principalpixel with the opposite sign.",
            of.title
        ))
        .with(
            XmlElement::new("compiler")
                .set("meshdir", "meshes")
                .set("angle", "radian"),
        )
        .with(offscreen(of))
        .with(assets)
        .with(XmlElement::new("worldbody").with(carried(of, body(of, &site))));
    if of.imu.is_some() {
        model.with(sensors)
    } else {
        model
    }
}

/// The buffer of `MuJoCo`'s renderer, as large as the largest image: by default it has 640 × 480 pixels.
fn offscreen(of: &Description) -> XmlElement {
    let largest = of.all_cameras().fold([0.0_f64; 2], |[w, h], camera| {
        let (width, height) = camera.size();
        [w.max(width), h.max(height)]
    });
    let [width, height] = largest.map(number);
    XmlElement::new("visual").with(
        XmlElement::new("global")
            .set("offwidth", width)
            .set("offheight", height),
    )
}

/// Returns the body below the link that carries it, if there is one.
fn carried(of: &Description, body: XmlElement) -> XmlElement {
    match &of.parent {
        Some(parent) => XmlElement::new("body").set("name", parent).with(body),
        None => body,
    }
}

fn body(of: &Description, imu_site: &str) -> XmlElement {
    let Housing {
        visuals,
        centre,
        mass,
        inertia,
        ..
    } = &of.housing;
    let geom = |name: &str| {
        XmlElement::new("geom")
            .set("type", "mesh")
            .set("mesh", format!("{}_{name}", of.name))
    };
    let body = placed(
        XmlElement::new("body").set("name", &of.name),
        &of.parent_from_body,
    )
    .with(
        XmlElement::new("inertial")
            .commented("A solid cuboid with the dimensions and the mass of the device.")
            .set("pos", numbers(centre.to_array()))
            .set("mass", number(*mass))
            .set(
                "diaginertia",
                inertia.to_array().map(|x| format!("{x:e}")).join(" "),
            ),
    )
    .with_all(visuals.iter().map(|visual| {
        geom(visual.name)
            .set("material", format!("{}_{}", of.name, visual.name))
            .set("contype", "0")
            .set("conaffinity", "0")
            .set("group", "2")
    }))
    .with(
        geom("collider")
            .set("name", format!("{}_collider", of.name))
            .set("group", "3"),
    )
    .with_all(of.all_cameras().map(|camera| self::camera(of, camera)));
    match &of.imu {
        Some(imu) => body.with(placed(
            XmlElement::new("site").set("name", imu_site).set("size", "0.001"),
            &imu.body_from_imu,
        )),
        None => body,
    }
}

fn camera(of: &Description, camera: &CameraFrame) -> XmlElement {
    let at = &camera.body_from_optical;
    let pose = RigidTransform::new(at.rotation * OPTICAL_FROM_OPENGL, at.translation);
    let (width, height) = camera.size();
    let (cx, cy) = camera.centre();
    placed(
        XmlElement::new("camera").set("name", format!("{}_{}", of.name, camera.role)),
        &pose,
    )
    .set("resolution", numbers([width, height]))
    .set(
        "sensorsize",
        numbers([width * camera.pitch, height * camera.pitch]),
    )
    .set(
        "focalpixel",
        numbers([camera.intrinsics.fx, camera.intrinsics.fy]),
    )
    .set("principalpixel", numbers([width / 2.0 - cx, height / 2.0 - cy]))
}

fn inertial_sensor(kind: &'static str, name: &str, site: &str, noise: Option<&ChannelNoise>) -> XmlElement {
    let sensor = XmlElement::new(kind)
        .set("name", format!("{site}_{name}"))
        .set("site", site);
    match noise {
        // For information: MuJoCo adds no noise.
        Some(noise) => {
            let mean = noise.density.element_sum() / 3.0;
            sensor.set("noise", format!("{:e}", mean * IMU_RATE.sqrt()))
        }
        None => sensor,
    }
}

fn placed(element: XmlElement, at: &RigidTransform) -> XmlElement {
    let turn = DQuat::from_mat3(&at.rotation);
    element
        .set("pos", numbers(at.translation.to_array()))
        .set("quat", numbers([turn.w, turn.x, turn.y, turn.z]))
}
