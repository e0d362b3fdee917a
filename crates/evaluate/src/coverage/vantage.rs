//! A view that shows a surface.

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use oaktwin_pipeline::render::{Clip, Renderer, View, look_at};
use oaktwin_scene::Bounds;

use super::sight::Sight;
use super::{Outcome, SurfacePoint};

/// The horizontal field of view from outside of the surface, and from within.
const OUTSIDE_HFOV_DEG: f64 = 50.0;
const INSIDE_HFOV_DEG: f64 = 95.0;

/// The directions around the surface.
const AROUND: u32 = 12;
const ELEVATIONS_DEG: [f64; 4] = [12.0, 30.0, 50.0, 75.0];

/// The position between the centre and a corner of the surface's bounding box from which it is viewed from within.
const INSIDE: f64 = 0.8;

/// The weight of a point that the candidate sees, relative to one that it does not see.
const SEEN: f64 = 6.0;

/// Returns the view that shows most of these points, which are evenly distributed over the surface, and above all the points that a
/// candidate with these outcomes sees.
pub(super) fn vantage(
    renderer: &Renderer,
    points: &[SurfacePoint],
    outcomes: &[Outcome],
    size: ImageSize,
) -> View {
    let up = renderer.scene().up.direction();
    let positions = points.iter().map(|point| Bounds::of(point.position));
    let bounds = positions.reduce(Bounds::union).unwrap_or(Bounds::of(DVec3::ZERO));
    let (centre, half) = (bounds.center(), bounds.size() / 2.0);
    let aspect = f64::from(size.height) / f64::from(size.width);
    let narrowest = (OUTSIDE_HFOV_DEG.to_radians() / 2.0).tan() * aspect.min(1.0);
    let distance = 1.05 * half.length().max(1e-3) / narrowest.atan().sin();
    let across = up.any_orthonormal_vector();
    let outside = ELEVATIONS_DEG.iter().flat_map(|elevation| {
        let (sin, cos) = elevation.to_radians().sin_cos();
        (0..AROUND).map(move |i| {
            let (y, x) = (f64::from(i) / f64::from(AROUND) * std::f64::consts::TAU).sin_cos();
            let around = across * x + up.cross(across) * y;
            (centre + (around * cos + up * sin) * distance, OUTSIDE_HFOV_DEG)
        })
    });
    let inside = (0..8u8).map(|i| {
        let sign = |bit: u8| if i & bit == 0 { -INSIDE } else { INSIDE };
        let corner = DVec3::new(sign(1), sign(2), sign(4));
        (centre + corner * half, INSIDE_HFOV_DEG)
    });
    let views = outside.chain(inside).filter_map(|(eye, hfov)| {
        let body = look_at(eye, centre, up).ok()?;
        let intrinsics = Intrinsics::from_hfov(size, hfov.to_radians());
        Some(View {
            camera: Camera::new(intrinsics, LensModel::Pinhole),
            world_from_camera: body * RigidTransform::new(Axes::Ros.rotation_from(Axes::OpenCv), DVec3::ZERO),
            clip: Clip::default(),
        })
    });
    let mut best: Option<(f64, View)> = None;
    for view in views {
        let shown = shown(renderer, points, outcomes, view);
        if best.is_none_or(|(most, _)| shown > most) {
            best = Some((shown, view));
        }
    }
    best.map_or_else(|| fallback(size), |(_, view)| view)
}

/// The sum over the visible points, each weighted by how much it faces the camera and whether the candidate sees it.
fn shown(renderer: &Renderer, points: &[SurfacePoint], outcomes: &[Outcome], view: View) -> f64 {
    let lines = Sight::new(view).lines(renderer, points);
    let mut sum = 0.0;
    for ((point, outcome), line) in points.iter().zip(outcomes).zip(&lines) {
        let Some(line) = line.as_ref().filter(|line| line.obstacle.is_none()) else {
            continue;
        };
        let cosine = point.normal.dot(line.backwards());
        let cosine = if point.is_double_sided {
            cosine.abs()
        } else {
            cosine
        };
        if cosine > 0.0 {
            sum += (0.25 + cosine) * if outcome.is_seen() { SEEN } else { 1.0 };
        }
    }
    sum
}

/// A view of a surface without extent.
fn fallback(size: ImageSize) -> View {
    View {
        camera: Camera::new(Intrinsics::from_hfov(size, 1.0), LensModel::Pinhole),
        world_from_camera: RigidTransform::IDENTITY,
        clip: Clip::default(),
    }
}
