//! A PROTO for Webots R2023b: a solid with cameras, range finders and inertial sensors.
//!
//! Webots' cameras see along x, with y to the left and z up. They have square pixels and no principal point.

use std::fmt::Write;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DQuat;

use crate::description::{CameraFrame, Description, Visual};
use crate::xml::{number, numbers};
use crate::{Housing, HousingMesh, RobotFiles};

/// Shifts of the principal point from here on are reported, pixels.
const VISIBLE_SHIFT_PX: f64 = 0.05;

pub(crate) fn export(of: &Description) -> RobotFiles {
    let mut export = RobotFiles::with_visuals(of);
    for camera in of.all_cameras() {
        export.findings.extend(lost(camera));
    }
    export.without_parent(
        of,
        "a PROTO",
        "add the node to the children of that solid, or to its slot for tools",
    );
    let name = proto_name(&of.id);
    export.text(format!("{name}.proto"), proto(of, &name));
    export
}

/// Reports what Webots cannot represent of a camera.
fn lost(camera: &CameraFrame) -> Option<Finding> {
    let ((width, height), (cx, cy)) = (camera.size(), camera.centre());
    let (x, y) = (cx - width / 2.0, cy - height / 2.0);
    let stretch = (camera.intrinsics.fy / camera.intrinsics.fx - 1.0) * height / 2.0;
    let is_visible = [x, y, stretch]
        .iter()
        .any(|error| error.abs() >= VISIBLE_SHIFT_PX);
    is_visible.then(|| {
        Finding::new(
            "intrinsics-simplified",
            Level::Warning,
            camera.role.clone(),
            format!(
                "Webots has neither a principal point nor two focal lengths: the image is shifted by ({x:.2}, {y:.2}) px, and its \
                 borders by {stretch:.2} px vertically"
            ),
            "use another format where that matters",
        )
    })
}

/// Returns the name of the PROTO: `oak_d_pro_poe` becomes `OakDProPoe`.
fn proto_name(id: &str) -> String {
    let words = id.split('_').filter(|word| !word.is_empty());
    let capital = |word: &str| {
        let (first, rest) = word.split_at(word.chars().next().map_or(0, char::len_utf8));
        first.to_uppercase() + rest
    };
    let name: String = words.map(capital).collect();
    if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        name
    } else {
        format!("Oak{name}")
    }
}

fn proto(of: &Description, name: &str) -> String {
    let mut out = String::from("#VRML_SIM R2023b utf8\n");
    let (translation, rotation) = place(&of.parent_from_body);
    let _ = write!(
        out,
        "# {}, written by oaktwin.\n\nPROTO {name} [\n  field SFVec3f translation {translation}\n  field SFRotation rotation {rotation}\n  \
         field SFString name \"{}\"\n]\n{{\n  Solid {{\n    translation IS translation\n    rotation IS rotation\n    name IS name\n    children [\n",
        of.title, of.name
    );
    for visual in &of.housing.visuals {
        out.push_str(&shape(of, visual));
    }
    for camera in &of.cameras {
        out.push_str(&device("Camera", of, camera, ""));
    }
    for depth in &of.depth_sensors {
        let (near, far) = depth.range;
        let range = format!(
            "        minRange {}\n        maxRange {}\n",
            number(near.max(0.01)),
            number(far)
        );
        out.push_str(&device("RangeFinder", of, &depth.camera, &range));
    }
    if let Some(imu) = &of.imu {
        let (translation, rotation) = place(&imu.body_from_imu);
        for (node, name) in [("Accelerometer", "accelerometer"), ("Gyro", "gyro")] {
            let _ = writeln!(
                out,
                "      {node} {{\n        translation {translation}\n        rotation {rotation}\n        name \"{}_{name}\"\n      }}",
                of.name
            );
        }
    }
    let Housing {
        centre,
        mass,
        inertia,
        ..
    } = &of.housing;
    let _ = write!(
        out,
        "    ]\n    boundingObject {}    physics Physics {{\n      density -1\n      mass {}\n      centerOfMass [ {} ]\n      \
         inertiaMatrix [ {:e} {:e} {:e}, 0 0 0 ]\n    }}\n  }}\n}}\n",
        faces(&of.housing.collider),
        number(*mass),
        numbers(centre.to_array()),
        inertia.x,
        inertia.y,
        inertia.z,
    );
    out
}

fn shape(of: &Description, visual: &Visual) -> String {
    format!(
        "      Shape {{\n        appearance PBRAppearance {{\n          baseColor {}\n          metalness {}\n          roughness {}\n        \
         }}\n        geometry Mesh {{ url \"meshes/{}\" }}\n      }}\n",
        numbers(visual.color.map(f64::from)),
        visual.metallic,
        visual.roughness,
        of.visual_file(visual)
    )
}

fn device(node: &str, of: &Description, camera: &CameraFrame, more: &str) -> String {
    let (translation, rotation) = place(&camera.body_from_camera());
    let size = camera.intrinsics.size;
    format!(
        "      {node} {{\n        translation {translation}\n        rotation {rotation}\n        name \"{}_{}\"\n        fieldOfView {}\n        \
         width {}\n        height {}\n{more}      }}\n",
        of.name,
        camera.role,
        number(camera.hfov()),
        size.width,
        size.height
    )
}

/// Returns a mesh as an `IndexedFaceSet`.
fn faces(mesh: &HousingMesh) -> String {
    let points: Vec<String> = mesh
        .points
        .iter()
        .map(|point| numbers(point.map(f64::from)))
        .collect();
    let faces: Vec<String> = mesh
        .triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|[point, _]| point);
            format!("{a} {b} {c} -1")
        })
        .collect();
    format!(
        "IndexedFaceSet {{\n      coord Coordinate {{ point [ {} ] }}\n      coordIndex [ {} ]\n    }}\n",
        points.join(", "),
        faces.join(" ")
    )
}

/// Returns a translation, and a rotation as axis and angle.
fn place(at: &RigidTransform) -> (String, String) {
    let (axis, angle) = DQuat::from_mat3(&at.rotation).to_axis_angle();
    (
        numbers(at.translation.to_array()),
        format!("{} {}", numbers(axis.to_array()), number(angle)),
    )
}
