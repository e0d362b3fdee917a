//! The outcomes of a candidate at the points of the surface.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::{PixelPoint, Usd};
use oaktwin_image::ZDepth;
use oaktwin_image::annotation::Reasons;
use oaktwin_pipeline::render::{Backend, Renderer, RigError, View};
use rayon::prelude::*;

use super::sight::{Sight, SightLine};
use super::{Candidate, Outcome, SurfacePoint};

/// The cosine of the angle of incidence below which a face is seen edge-on.
const EDGE_ON: f64 = 1e-6;

/// The steepest slope of depth within a pixel, in widths of the pixel on the surface, up to which a surface counts as resolved.
const STEEPEST: f64 = 16.0;

/// The outcomes of a candidate at all points.
pub(super) struct CandidateOutcomes {
    /// The outcome at each point.
    pub(super) outcomes: Vec<Outcome>,
    /// Measured minus true z, in metres; NaN where nothing is measured.
    pub(super) errors_m: Vec<f32>,
    /// The number of points that each instance hides.
    pub(super) occluders: BTreeMap<u32, u32>,
    pub(super) findings: Vec<Finding>,
}

impl CandidateOutcomes {
    /// Counts points with larger errors as not measured.
    pub(super) fn reject_errors_above(&mut self, tolerance_m: f64) {
        for (outcome, error) in self.outcomes.iter_mut().zip(&self.errors_m) {
            if *outcome == Outcome::MEASURED && f64::from(*error).abs() > tolerance_m {
                *outcome = Outcome::INACCURATE;
            }
        }
    }
}

/// Simulates the depth sensor of a candidate and assesses each point.
///
/// # Errors
/// Returns an error if the sensor cannot measure what was rendered.
pub(super) fn assess_points(
    renderer: &Renderer,
    candidate: &Candidate<'_>,
    points: &[SurfacePoint],
) -> Result<CandidateOutcomes, RigError> {
    let (image, findings) = SensorImage::capture(renderer, candidate)?;
    let lines = image.sight.lines(renderer, points);
    let assessed: Vec<(Outcome, f32)> = points
        .par_iter()
        .zip(&lines)
        .map(|(point, line)| image.assess(point, line.as_ref()))
        .collect();
    let mut occluders = BTreeMap::new();
    for ((outcome, _), line) in assessed.iter().zip(&lines) {
        if let (Outcome::HIDDEN, Some(hit)) = (*outcome, line.as_ref().and_then(|line| line.obstacle)) {
            *occluders.entry(hit.instance).or_default() += 1;
        }
    }
    let (outcomes, errors_m) = assessed.into_iter().unzip();
    Ok(CandidateOutcomes {
        outcomes,
        errors_m,
        occluders,
        findings,
    })
}

/// The image of a depth sensor.
struct SensorImage {
    sight: Sight,
    /// The ground truth of the view.
    truth: ZDepth,
    measured: Option<ZDepth>,
    /// Why pixels have no value.
    reasons: Option<Reasons>,
}

impl SensorImage {
    fn capture(renderer: &Renderer, candidate: &Candidate<'_>) -> Result<(Self, Vec<Finding>), RigError> {
        let pose = &candidate.world_from_body;
        // Each candidate has a new rig, so that its result does not depend on the others.
        let (shots, findings) = candidate.rig.rig.clone().shoot(renderer, Some(pose), 0)?;
        let frame = shots
            .into_iter()
            .next()
            .map(|shot| shot.frame)
            .unwrap_or_default();
        let view = candidate.view();
        let truth = frame
            .distance_to_image_plane
            .filter(|_| view == candidate.rig.camera.view(pose))
            .unwrap_or_else(|| renderer.depth(&view, Backend::Auto));
        let image = Self {
            sight: Sight::new(view),
            truth,
            measured: frame.depth_sensor_distance,
            reasons: frame.depth_sensor_reason,
        };
        Ok((image, findings))
    }

    /// Returns the outcome at a point and the error of its measurement.
    fn assess(&self, point: &SurfacePoint, line: Option<&SightLine>) -> (Outcome, f32) {
        let lost = |outcome| (outcome, f32::NAN);
        let Some(line) = line else {
            return lost(Outcome::OUTSIDE_VIEW);
        };
        let cosine = point.normal.dot(line.backwards());
        if cosine.abs() < EDGE_ON {
            return lost(Outcome::FACES_AWAY);
        }
        if let Some(hit) = line.obstacle {
            // A surface without an inside is hidden like any other; a body hides its own rear.
            let has_rear = !point.is_double_sided || hit.instance == point.instance;
            return lost(if has_rear && cosine < 0.0 {
                Outcome::FACES_AWAY
            } else {
                Outcome::HIDDEN
            });
        }
        let (x, y) = line.pixel;
        let truth = self.truth.0.get(x, y).copied().unwrap_or(f32::INFINITY);
        if !self.resolves(point, line, truth) {
            return lost(Outcome::NOT_RESOLVED);
        }
        let measured = self.measured.as_ref().and_then(|image| image.0.get(x, y));
        match measured {
            Some(&z) if z > 0.0 && z.is_finite() => (Outcome::MEASURED, z - truth),
            _ => {
                let codes = self.reasons.as_ref().map(|reasons| &reasons.codes);
                let code = codes.and_then(|codes| codes.get(x, y)).copied();
                lost(Outcome::of_pixel(code.unwrap_or_default()))
            }
        }
    }

    /// Whether the centre of a point's pixel, where the depth is `truth`, shows the surface around the point. That surface need not
    /// be plane: its depth may differ from the point's by twice what the slope of the face explains, and the width of two pixels.
    fn resolves(&self, point: &SurfacePoint, line: &SightLine, truth: f32) -> bool {
        let camera = &self.sight.view.camera;
        let (x, y) = line.pixel;
        let centre = PixelPoint::<Usd>::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let Some(ray) = camera.unproject(centre) else {
            return false;
        };
        let normal = self.sight.camera_from_world.transform_vector3(point.normal);
        let z = line.point_in_camera.z;
        let width = line.point_in_camera.length() / camera.intrinsics.mean_focal_length();
        let on_face = normal.dot(line.point_in_camera) / normal.dot(ray) * ray.z;
        let slope = (on_face - z).abs();
        let slope = if slope < STEEPEST * width {
            slope
        } else {
            STEEPEST * width
        };
        (f64::from(truth) - z).abs() <= 2.0 * (slope + width)
    }
}

impl Candidate<'_> {
    /// The view that the sensor's image shows.
    pub(super) fn view(&self) -> View {
        let input = self.rig.camera.view(&self.world_from_body);
        let output = self.rig.sensor.output_camera(&input.camera);
        View {
            camera: output.camera,
            world_from_camera: input.world_from_camera * output.input_from_output(),
            clip: input.clip,
        }
    }
}
