//! A Python script for Blender that adds the housing and the cameras.
//!
//! Blender fits the sensor's width to the image's. A positive `shift_x` moves the image to the left and a positive `shift_y` moves
//! it down, both in units of the image's width.

use std::fmt::Write;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DMat3;

use crate::RobotFiles;
use crate::description::{CameraFrame, Description};
use crate::mjcf::OPTICAL_FROM_OPENGL;
use crate::xml::number;

const HEAD: &str = include_str!("blender.py");

pub(crate) fn export(of: &Description) -> RobotFiles {
    let mut export = RobotFiles::with_visuals(of);
    export.text(format!("{}_blender.py", of.name), script(of));
    export
}

fn script(of: &Description) -> String {
    let mut data = String::new();
    let _ = writeln!(data, "TITLE = {}", quoted(&of.title));
    let _ = writeln!(data, "NAME = {}", quoted(&of.name));
    let parent = of.parent.as_deref().map_or_else(|| "None".to_owned(), quoted);
    let _ = writeln!(data, "PARENT = {parent}");
    let _ = writeln!(data, "PARENT_FROM_BODY = {}", matrix(&of.parent_from_body));
    let _ = writeln!(data, "MESHES = [");
    for visual in &of.housing.visuals {
        let [r, g, b] = visual.color;
        let _ = writeln!(
            data,
            "    (\"meshes/{}\", ({r}, {g}, {b}, 1.0), {}, {}),",
            of.visual_file(visual),
            visual.metallic,
            visual.roughness
        );
    }
    let _ = writeln!(data, "]\nCAMERAS = {{");
    for camera in of.all_cameras() {
        let _ = writeln!(data, "    {}: {},", quoted(&camera.role), values(camera));
    }
    data.push_str("}\n");
    HEAD.replace("# DATA\n", &data)
}

fn values(camera: &CameraFrame) -> String {
    let ((width, height), (cx, cy)) = (camera.size(), camera.centre());
    let (fx, fy) = (camera.intrinsics.fx, camera.intrinsics.fy);
    let at = &camera.body_from_optical;
    let pose = RigidTransform::new(at.rotation * OPTICAL_FROM_OPENGL, at.translation);
    // The height of a pixel relative to its width.
    let aspect = fx / fy;
    let sensor_mm = width * camera.pitch * 1e3;
    let (near, far) = camera.clip;
    format!(
        "{{\"resolution\": ({width}, {height}), \"sensor_width\": {}, \"lens\": {}, \"shift_x\": {}, \"shift_y\": {}, \"pixel_aspect\": {}, \
         \"clip\": ({near}, {far}), \"pose\": {}}}",
        number(sensor_mm),
        number(fx / width * sensor_mm),
        number(-(cx - width / 2.0) / width),
        number((cy - height / 2.0) * aspect / width),
        number(aspect),
        matrix(&pose),
    )
}

fn matrix(pose: &RigidTransform) -> String {
    let DMat3 {
        x_axis: x,
        y_axis: y,
        z_axis: z,
    } = pose.rotation;
    let t = pose.translation;
    let row = |values: [f64; 4]| format!("({})", values.map(number).join(", "));
    format!(
        "({}, {}, {}, (0, 0, 0, 1))",
        row([x.x, y.x, z.x, t.x]),
        row([x.y, y.y, z.y, t.y]),
        row([x.z, y.z, z.z, t.z])
    )
}

/// Returns a Python string.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.escape_default())
}
