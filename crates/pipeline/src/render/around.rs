//! A default view of a scene without cameras.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Bounds, Scene};

/// Returns the points `EYE` and `TARGET` of a view of the whole scene, from above a corner of its bounding box, in metres.
/// `None` for a scene without triangles.
#[must_use]
pub fn overview(scene: &Scene) -> Option<[DVec3; 2]> {
    let bounds = scene.bounds()?;
    let up = scene.up.direction();
    let across = (DVec3::ONE - up) * DVec3::new(1.0, -1.0, 1.0);
    let eye = bounds.center() + (across + up * 0.7).normalize() * (reach(bounds) * 2.0);
    Some([eye, bounds.center()])
}

fn reach(bounds: Bounds) -> f64 {
    (bounds.size() / 2.0).length().max(0.1)
}

/// Returns the numbers of [`overview`] as text.
pub(super) fn look_at(scene: &Scene) -> String {
    let (Some(points), Some(bounds)) = (overview(scene), scene.bounds()) else {
        return "0 0 0 1 0 0".to_owned();
    };
    points
        .iter()
        .flat_map(DVec3::to_array)
        .map(|x| brief(x, reach(bounds)))
        .collect::<Vec<_>>()
        .join(" ")
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
                material_offset: 0,
            }],
            up: Up::Z,
            ..Scene::default()
        };
        assert_eq!(look_at(&scene), "1.1 -1.1 1.27 0 0 0.5");
        assert_eq!(look_at(&Scene::default()), "0 0 0 1 0 0");
    }
}
