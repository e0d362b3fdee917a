use ::gltf::json;
use json::camera::Type;
use json::validation::Checked;
use oaktwin_camera::math::{DAffine3, DMat3};
use oaktwin_camera::{Axes, RigidTransform};

use super::document::Document;
use crate::import::ImportedCamera;
use crate::import::builder::Builder;

pub(super) fn read(
    document: &Document,
    index: usize,
    path: &str,
    file_from_node: DAffine3,
    builder: &mut Builder,
) {
    let Some(camera) = document.root.cameras.get(index) else {
        builder.warn("gltf-camera", path, format!("cameras[{index}] does not exist"));
        return;
    };
    let perspective = match (&camera.type_, &camera.perspective) {
        (Checked::Valid(Type::Perspective), Some(perspective)) => perspective,
        (Checked::Valid(Type::Orthographic), _) => {
            builder.warn(
                "gltf-unsupported",
                path,
                "orthographic cameras are not supported; skipped",
            );
            return;
        }
        _ => {
            builder.warn(
                "gltf-camera",
                path,
                format!("cameras[{index}] has an unknown type"),
            );
            return;
        }
    };
    let vfov = f64::from(perspective.yfov);
    let pose = rigid(builder.world_from_file() * file_from_node);
    match pose {
        Some(world_from_node) if vfov > 0.0 && vfov < std::f64::consts::PI => {
            let node_from_camera = Axes::Usd.rotation_from(Axes::OpenCv);
            let path = builder.free_path(path);
            builder.add_camera(ImportedCamera {
                path,
                world_from_camera: RigidTransform::new(
                    world_from_node.rotation * node_from_camera,
                    world_from_node.translation,
                ),
                vfov,
                aspect: perspective
                    .aspect_ratio
                    .map(f64::from)
                    .filter(|aspect| aspect.is_finite() && *aspect > 0.0),
            });
        }
        _ => builder.warn(
            "gltf-camera",
            path,
            "skipped: its field of view or its pose is invalid",
        ),
    }
}

/// The position and orientation of a node, without its scale: its −z axis is forward and +y up. `None` if the node's
/// transform is singular.
pub(super) fn rigid(world_from_node: DAffine3) -> Option<RigidTransform> {
    let m = world_from_node.matrix3;
    let z = m.z_axis.try_normalize()?;
    let x = m.y_axis.cross(z).try_normalize()?;
    let pose = RigidTransform::new(DMat3::from_cols(x, z.cross(x), z), world_from_node.translation);
    (pose.orthonormality_error() < 1e-9 && pose.translation.is_finite()).then_some(pose)
}
