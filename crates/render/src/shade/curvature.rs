//! Where curved mirrors show what they reflect.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::Scene;

use crate::Hit;
use crate::annotate::Surface;

/// The step over which normals are compared, as a share of the distance.
const STEP: f64 = 1e-3;

/// Returns the curvature, 1/m, of a surface that an eye sees along a direction in the world, from the normals at the corners of the
/// triangle: positive where it bulges towards the eye, 0 for meshes without normals.
pub(super) fn along(scene: &Scene, surface: &Surface<'_>, hit: Hit, eye: DVec3, direction: DVec3) -> f64 {
    let instance = scene.instances.get(hit.instance as usize);
    let vertices = surface.mesh.triangles.get(hit.triangle as usize);
    let normals = vertices.and_then(|vertices| {
        let normals = surface.mesh.normals.as_ref()?;
        normals.corners(hit.triangle as usize, *vertices)
    });
    let (Some(instance), Some(normals)) = (instance, normals) else {
        return 0.0;
    };
    let Some(tangent) = (direction - surface.normal * direction.dot(surface.normal)).try_normalize() else {
        return 0.0;
    };
    let step = STEP * surface.range;
    let world_from_normal = instance.world_from_mesh.matrix3.inverse().transpose();
    let normals = normals.map(|normal| world_from_normal * DVec3::from(normal.map(f64::from)));
    let normal_at = |weights: [f64; 3]| {
        let sum = normals[0] * weights[0] + normals[1] * weights[1] + normals[2] * weights[2];
        let normal = sum.normalize_or_zero();
        if surface.is_back { -normal } else { normal }
    };
    let aside = surface.point + tangent * step - eye;
    let turned = normal_at(surface.weights_of(aside)) - normal_at(surface.weights);
    let curvature = turned.dot(tangent) / step;
    if curvature.is_finite() { curvature } else { 0.0 }
}

/// Returns how far behind a mirror of a curvature the image of a place is that is `distance` metres in front of it, by the mirror equation
/// for small angles. Infinite where the image is real: in front of the mirror, behind the eye or blurred.
pub(super) fn image_distance(distance: f64, curvature: f64) -> f64 {
    let inverse = 1.0 / distance + 2.0 * curvature;
    if inverse > 0.0 {
        1.0 / inverse
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn images_are_those_of_the_mirror_equation() {
        assert_eq!(image_distance(3.0, 0.0), 3.0);
        // The focal point of a ball is half a radius behind its surface.
        assert!((image_distance(f64::INFINITY, 1.0 / 0.2) - 0.1).abs() < 1e-12);
        assert!((image_distance(1.0, 1.0 / 0.5) - 0.2).abs() < 1e-12);
        // A concave mirror enlarges what is near, and has a real image of what is far.
        assert!((image_distance(1.0, -0.25) - 2.0).abs() < 1e-12);
        assert_eq!(image_distance(3.0, -0.25), f64::INFINITY);
    }
}
