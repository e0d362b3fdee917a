use ::gltf::json;
use json::extensions::scene::khr_lights_punctual::Type;
use json::validation::Checked;
use oaktwin_camera::math::DAffine3;

use super::camera::rigid;
use super::document::Document;
use crate::import::builder::Builder;
use crate::{Light, LightKind};

/// Punctual lights have no size; this radius in metres is too small to be noticed.
const RADIUS: f32 = 0.01;

/// Reads a light of `KHR_lights_punctual`, which shines along −z. Its illuminance or intensity is converted to the
/// radiance of a small area light.
pub(super) fn read(
    document: &Document,
    index: usize,
    path: &str,
    file_from_node: DAffine3,
    builder: &mut Builder,
) {
    let lights = document
        .root
        .extensions
        .as_ref()
        .and_then(|extensions| extensions.khr_lights_punctual.as_ref());
    let Some(light) = lights.and_then(|lights| lights.lights.get(index)) else {
        builder.warn("gltf-light", path, format!("light {index} does not exist"));
        return;
    };
    let kind = match light.type_ {
        // A distant light divided by its solid angle gives the same illuminance; the sun's disk is half a degree wide.
        Checked::Valid(Type::Directional) => (
            LightKind::Distant {
                angle: 0.53_f32.to_radians(),
            },
            1.0,
        ),
        // A sphere of area 4πr² and radiance L has the intensity L·πr² in all directions.
        Checked::Valid(Type::Point) => (LightKind::Sphere { radius: RADIUS }, 4.0),
        // A disk of area πr² and radiance L has the intensity L·πr² along its axis.
        Checked::Valid(Type::Spot) => {
            builder.warn(
                "gltf-unsupported",
                path,
                "the cone of the spot light is ignored: it is rendered as a disk light",
            );
            (LightKind::Disk { radius: RADIUS }, 1.0)
        }
        Checked::Invalid => {
            builder.warn("gltf-light", path, "skipped: unknown type");
            return;
        }
    };
    let (kind, factor) = kind;
    let radiance = light.color.map(|color| color * light.intensity * factor);
    match rigid(builder.world_from_file() * file_from_node) {
        Some(pose) if radiance.iter().all(|x| x.is_finite() && *x >= 0.0) => {
            let path = builder.free_path(path);
            builder.add_light(Light {
                path,
                kind,
                radiance,
                normalize: true,
                world_from_light: DAffine3::from_mat3_translation(pose.rotation, pose.translation),
            });
        }
        _ => builder.warn(
            "gltf-light",
            path,
            "skipped: its colour or its pose is not finite",
        ),
    }
}
