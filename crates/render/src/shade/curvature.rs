//! Where curved mirrors and lenses show what is seen in them.

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

/// What mirrors and lenses on a path do to rays near it that leave the eye side by side: the transfer matrix of paraxial optics, from the
/// offset and the slope of a ray at the eye to those at the end of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transfer {
    offset: [f64; 2],
    slope: [f64; 2],
}

impl Transfer {
    /// The way, metres, from the eye to the first surface.
    pub(super) const fn over(distance: f64) -> Self {
        Self {
            offset: [1.0, distance],
            slope: [0.0, 1.0],
        }
    }

    /// Adds a mirror with a curvature.
    pub(super) fn reflected(self, curvature: f64) -> Self {
        self.bent(1.0, 2.0 * curvature)
    }

    /// Adds a surface that refracts; `ratio` is the index of refraction before it divided by the one behind.
    pub(super) fn refracted(self, ratio: f64, curvature: f64) -> Self {
        self.bent(ratio, (ratio - 1.0) * curvature)
    }

    fn bent(self, factor: f64, power: f64) -> Self {
        let [offset, slope] = [self.offset, self.slope];
        Self {
            slope: [0, 1].map(|i| slope[i] * factor + offset[i] * power),
            ..self
        }
    }

    /// Adds a way, metres.
    pub(super) fn ahead(self, distance: f64) -> Self {
        let [offset, slope] = [self.offset, self.slope];
        Self {
            offset: [0, 1].map(|i| offset[i] + slope[i] * distance),
            ..self
        }
    }

    /// Returns the distance from the eye, metres, at which the end of the path appears to be; infinite if that is behind the eye.
    pub(super) fn apparent_m(self) -> f64 {
        ahead_of_eye(self.offset)
    }

    /// Returns the distance at which something infinitely far beyond the end of the path appears to be.
    pub(super) fn apparent_sky_m(self) -> f64 {
        ahead_of_eye(self.slope)
    }
}

fn ahead_of_eye([by_offset, by_slope]: [f64; 2]) -> f64 {
    let distance = by_slope / by_offset;
    if distance > 0.0 { distance } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mirrors_have_the_images_of_the_mirror_equation() {
        let image =
            |curvature: f64, way: f64| Transfer::over(2.0).reflected(curvature).ahead(way).apparent_m() - 2.0;
        assert!((image(0.0, 3.0) - 3.0).abs() < 1e-12);
        // 1 / image = 1 / way + 2 / radius.
        assert!((image(1.0 / 0.5, 1.0) - 0.2).abs() < 1e-12);
        // The focal point of a ball is half a radius behind its surface.
        assert!((Transfer::over(2.0).reflected(1.0 / 0.2).apparent_sky_m() - 2.1).abs() < 1e-12);
        assert_eq!(Transfer::over(2.0).reflected(0.0).apparent_sky_m(), f64::INFINITY);
        // A concave mirror enlarges what is near, and has a real image of what is far.
        assert!((image(-0.25, 1.0) - 2.0).abs() < 1e-12);
        assert!((image(-1.0, 3.0) + 0.6).abs() < 1e-12);
    }

    #[test]
    fn glass_has_the_images_of_gauss_equation() {
        // Through a flat surface, depths are divided by the index.
        let flat = Transfer::over(1.0).refracted(1.0 / 1.5, 0.0).ahead(0.3);
        assert!((flat.apparent_m() - 1.2).abs() < 1e-12);
        // The centre of a ball of glass appears where it is.
        let ball = Transfer::over(1.0).refracted(1.0 / 1.5, 1.0 / 0.15);
        assert!((ball.ahead(0.15).apparent_m() - 1.15).abs() < 1e-12);
        // The image of what is far away stands half a radius before the ball.
        let behind = ball.ahead(0.3).refracted(1.5, -1.0 / 0.15);
        assert!((behind.apparent_sky_m() - (1.0 - 0.075)).abs() < 1e-12);
    }
}
