//! A default view of a scene without cameras.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

/// The numbers `EYE TARGET` of a view of the whole scene, from above a corner of its bounding box.
pub(super) fn look_at(scene: &Scene) -> String {
    let Some((low, high)) = bounds(scene) else {
        return "0 0 0 1 0 0".to_owned();
    };
    let (centre, half) = ((low + high) / 2.0, (high - low) / 2.0);
    let up = scene.up.direction();
    let across = (DVec3::ONE - up) * DVec3::new(1.0, -1.0, 1.0);
    let reach = half.length().max(0.1);
    let eye = centre + (across + up * 0.7).normalize() * (reach * 2.0);
    [eye, centre]
        .iter()
        .flat_map(DVec3::to_array)
        .map(|x| brief(x, reach))
        .collect::<Vec<_>>()
        .join(" ")
}

/// The bounding box of all instances in metres; `None` for an empty scene.
fn bounds(scene: &Scene) -> Option<(DVec3, DVec3)> {
    let boxes: Vec<Option<(DVec3, DVec3)>> = scene
        .meshes
        .iter()
        .map(|mesh| {
            let points = mesh.positions.iter().map(|p| DVec3::from(p.map(f64::from)));
            points.fold(None, |known, point| grow(known, point, point))
        })
        .collect();
    scene.instances.iter().fold(None, |known, instance| {
        let Some(Some((low, high))) = boxes.get(instance.mesh as usize) else {
            return known;
        };
        (0..8u8).fold(known, |known, corner| {
            let pick = |bit: u8, low: f64, high: f64| if corner >> bit & 1 == 0 { low } else { high };
            let corner = DVec3::new(
                pick(0, low.x, high.x),
                pick(1, low.y, high.y),
                pick(2, low.z, high.z),
            );
            let point = instance.world_from_mesh.transform_point3(corner);
            grow(known, point, point)
        })
    })
}

fn grow(known: Option<(DVec3, DVec3)>, low: DVec3, high: DVec3) -> Option<(DVec3, DVec3)> {
    Some(known.map_or((low, high), |(l, h)| (l.min(low), h.max(high))))
}

/// Rounds to two or three digits of the scene's size.
fn brief(x: f64, reach: f64) -> String {
    let step = 10f64.powf((reach / 10.0).log10().floor());
    let decimals = (-step.log10().round()).clamp(0.0, 9.0);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to 0 to 9"
    )]
    let decimals = decimals as usize;
    let text = format!("{:.decimals$}", (x / step).round() * step + 0.0);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::math::DAffine3;
    use oaktwin_scene::{Instance, Mesh, Up};

    #[test]
    fn views_the_scene_from_outside() {
        let mesh = Mesh {
            positions: vec![[-50.0, -50.0, 0.0], [50.0, 50.0, 0.0], [0.0, 0.0, 100.0]],
            triangles: vec![[0, 1, 2]],
            ..Mesh::default()
        };
        let scene = Scene {
            meshes: vec![mesh],
            instances: vec![Instance {
                mesh: 0,
                path: String::new(),
                world_from_mesh: DAffine3::from_scale(DVec3::splat(0.01)),
                labels: Vec::new(),
            }],
            up: Up::Z,
            ..Scene::default()
        };
        assert_eq!(look_at(&scene), "1.1 -1.1 1.27 0 0 0.5");
        assert_eq!(look_at(&Scene::default()), "0 0 0 1 0 0");
    }
}
