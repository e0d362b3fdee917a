//! What is known about one pixel.

use oaktwin::camera::math::DVec3;
use oaktwin::camera::{PixelPoint, Usd};
use oaktwin::depth::Reason;
use oaktwin::depth::stereo_noise::Subpixel;
use oaktwin::render::{Ray, Renderer};

use crate::protocol::{Failure, ProbeAnswer, ProbeRequest};
use crate::reasons;
use crate::station::{Measurement, Station};

/// A surface that is nearer than this share of a distance to its end does not occlude it.
const SURFACE: f64 = 1e-4;

/// Explains a pixel of the last measurement.
pub(crate) fn probe(station: Option<&Station>, request: &ProbeRequest) -> Result<ProbeAnswer, Failure> {
    let measurement = station
        .and_then(Station::last)
        .ok_or_else(|| Failure::of("oak", "nothing was measured yet; request a frame first"))?;
    let measured = &measurement.capture.distance.0;
    let pixel = [
        index(request.x, measured.width()),
        index(request.y, measured.height()),
    ];
    let [x, y] = pixel;
    let valid = |z: Option<f32>| z.map(f64::from).filter(|z| z.is_finite() && *z > 0.0);
    let truth = measurement.truth().and_then(|truth| {
        let place = truth.width() as usize * y as usize + x as usize;
        truth.pixels().get(place).copied()
    });
    let (true_m, measured_m) = (valid(truth), valid(measured.get(x, y).copied()));
    let hit = hit(measurement, pixel);
    let width = measurement.view.camera.intrinsics.size.width;
    let disparity_times_depth = measurement.engine.disparity_times_depth(width);
    let known = measured_m.or(true_m).filter(|_| disparity_times_depth > 0.0);
    let step_px = measurement.engine.subpixel().map(Subpixel::step_px);
    let step_m = known.zip(step_px).and_then(|(z, step_px)| {
        let next = disparity_times_depth / z - step_px;
        (next > 0.0).then(|| disparity_times_depth / next - z)
    });
    let reason = reasons::codes(measurement).and_then(|codes| codes.get(x, y));
    let point = hit.as_ref().map(|hit| hit.point);
    let occluder = point
        .filter(|_| measured_m.is_none() && reason.is_some_and(|code| HIDDEN.contains(code)))
        .and_then(|point| occluder(&measurement.scene.renderer, measurement.other?.translation, point));
    Ok(ProbeAnswer {
        id: request.id,
        oak: request.oak.clone(),
        pixel,
        true_m,
        disparity_px: known.map(|z| disparity_times_depth / z),
        measured_m,
        error_m: true_m.zip(measured_m).map(|(truth, measured)| measured - truth),
        step_m,
        reason: reason.copied().unwrap_or_default(),
        object: hit.map(|hit| hit.path),
        occluder,
        point: point.map(|point| point.to_array()),
    })
}

/// The reasons that something between the surface and the other camera can have.
const HIDDEN: [u8; 2] = [Reason::Occluded.code(), Reason::LeftRightCheck.code()];

/// Returns the pixel at a fraction of a length.
fn index(fraction: f64, length: u32) -> u32 {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates, and is limited to the image"
    )]
    let pixel = (fraction * f64::from(length)).floor() as u32;
    pixel.min(length.saturating_sub(1))
}

/// The surface in a pixel.
struct SurfaceHit {
    path: String,
    point: DVec3,
}

fn hit(measurement: &Measurement, [x, y]: [u32; 2]) -> Option<SurfaceHit> {
    let view = &measurement.output;
    let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let in_camera = view.camera.unproject(centre)?;
    // Distances along the ray are then distances along the optical axis.
    let in_camera = in_camera / in_camera.z.abs().max(1e-9);
    let ray = Ray {
        origin: view.world_from_camera.translation,
        direction: view.world_from_camera.rotation * in_camera,
        near: view.clip.near_m,
        far: view.clip.far_m,
    };
    let renderer = &measurement.scene.renderer;
    let (distance, hit) = renderer.cast_rays(&[ray]).into_iter().next().flatten()?;
    let instance = renderer.scene().instances.get(hit.instance as usize)?;
    Some(SurfaceHit {
        path: instance.path.clone(),
        point: ray.origin + ray.direction * distance,
    })
}

/// Returns the prim between a camera and a point, if there is one.
fn occluder(renderer: &Renderer, camera: DVec3, point: DVec3) -> Option<String> {
    let ray = Ray {
        origin: camera,
        direction: point - camera,
        near: 1e-3,
        far: 1.0 - SURFACE,
    };
    let (_, hit) = renderer.cast_rays(&[ray]).into_iter().next().flatten()?;
    let instance = renderer.scene().instances.get(hit.instance as usize)?;
    Some(instance.path.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_select_pixels_within_the_image() {
        assert_eq!(
            [0.0, 0.499, 0.5, 1.0, 7.0, -1.0, f64::NAN].map(|x| index(x, 10)),
            [0, 4, 5, 9, 9, 0, 0]
        );
        assert_eq!(index(0.5, 0), 0);
    }
}
