use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_base::parameter::{Kind, Table};
use oaktwin_catalog::{DepthKind, DepthSensor as Spec};

use super::rule::Rule;
use super::scene::{CheckedCamera, CheckedDepthSensor, CheckedScene};
use super::{num, same};

pub(super) const DEPTH_VALUE: Rule = Rule {
    code: "depth-value",
    level: Level::Error,
    what: "a depth sensor's value is zero, negative, infinite or NaN where that is invalid",
    remedy: "author a valid value",
};
pub(super) const CONFIDENCE_THRESHOLD: Rule = Rule {
    code: "confidence-threshold",
    level: Level::Error,
    what: "confidenceThreshold is outside 0 to 1",
    remedy: "set it between 0 and 1; the sheet has 0.8",
};
pub(super) const NOISE_MEAN_ZERO: Rule = Rule {
    code: "noise-mean-zero",
    level: Level::Note,
    what: "noiseMean is 0, which disables both the quantization of disparity and the jitter of noiseSigma",
    remedy: "",
};
pub(super) const FOCAL_LENGTH_PIXEL: Rule = Rule {
    code: "focal-length-pixel",
    level: Level::Warning,
    what: "focalLengthPixel is not the camera's fx for an image sensorSizePixel wide: disparity is then inconsistent \
           with depth",
    remedy: "set focalLengthPixel to sensorSizePixel × focalLength / horizontalAperture, rounded",
};
pub(super) const SENSOR_SIZE_PIXEL: Rule = Rule {
    code: "sensor-size-pixel",
    level: Level::Warning,
    what: "sensorSizePixel is neither the rendered width nor the width of the camera's own image",
    remedy: "set sensorSizePixel to the width of the sensor's image, and adjust focalLengthPixel",
};
pub(super) const DISTANCE_RANGE: Rule = Rule {
    code: "distance-range",
    level: Level::Error,
    what: "minDistance is not below maxDistance, so no depth is valid",
    remedy: "author 0 ≤ minDistance < maxDistance, in metres",
};
pub(super) const MIN_DISTANCE: Rule = Rule {
    code: "min-distance",
    level: Level::Warning,
    what: "minDistance is below the minimum that maxDisparityPixel allows, focalLengthPixel × baselineMM / \
           maxDisparityPixel: nearer depth is already cut off there",
    remedy: "raise minDistance, or raise maxDisparityPixel (191 in OAK's extended mode)",
};
pub(super) const CLIPPED_RANGE: Rule = Rule {
    code: "clipped-range",
    level: Level::Warning,
    what: "the camera's clippingRange cuts into the depth sensor's range",
    remedy: "extend clippingRange (in stage units) beyond minDistance and maxDistance (in metres)",
};
pub(super) const TOF_AS_STEREO: Rule = Rule {
    code: "tof-as-stereo",
    level: Level::Warning,
    what: "a time-of-flight sensor is modelled as stereo with a baseline of a few millimetres: disparity vanishes with \
           distance, and noise of a tenth of a pixel becomes a large depth error",
    remedy: "do not rely on its noise; simulate the sensor as time of flight",
};

/// The minimum baseline of a stereo camera, mm.
const SHORTEST_BASELINE_MM: f64 = 5.0;
/// The tolerance for rounding to integer pixels, as in the sheet, and to `float`.
const FOCAL_LENGTH_TOLERANCE_PX: f64 = 0.5 + 1e-3;

/// The numbers of a depth sensor, authored or the schema's defaults (Isaac Sim 5.1).
#[derive(Clone, Copy)]
pub(super) struct Parameters<'a> {
    sensor: &'a CheckedDepthSensor<'a>,
}

impl<'a> Parameters<'a> {
    pub(super) fn of(sensor: &'a CheckedDepthSensor<'a>) -> Self {
        Self { sensor }
    }

    pub(super) fn authored(&self, name: &str) -> Option<f64> {
        let full = format!("{}{name}", self.sensor.generation.namespace());
        self.sensor.prim.number(&full)
    }

    pub(super) fn get(&self, name: &str) -> f64 {
        let default = || {
            let row = Attributes::row(name).ok()?;
            (row.numbers)(&Attributes::isaac_5_1()).first().copied()
        };
        self.authored(name).or_else(default).unwrap_or(f64::NAN)
    }

    /// Returns the distance at which disparity reaches its limit, in metres.
    pub(super) fn nearest_by_disparity_m(&self) -> f64 {
        (self.get("baselineMM") * 1e-3).abs() * self.get("focalLengthPixel") / self.get("maxDisparityPixel")
    }

    /// Returns the disparity at a distance, in sensor pixels.
    fn disparity_px(&self, distance_m: f64) -> f64 {
        (self.get("baselineMM") * 1e-3).abs() * self.get("focalLengthPixel") / distance_m
    }

    /// Formats a value: `805`, or `897 (schema default)` if it is not authored.
    fn text(&self, name: &str) -> String {
        let value = num(self.get(name));
        if self.authored(name).is_some() {
            value
        } else {
            format!("{value} (schema default)")
        }
    }
}

pub(super) fn rules(scene: &CheckedScene<'_>, sensor: &CheckedDepthSensor<'_>, findings: &mut Vec<Finding>) {
    let parameters = Parameters::of(sensor);
    let path = &sensor.prim.path;
    if !values(path, &parameters, findings) {
        return;
    }
    let spec = sensor.known.map(|known| &known.spec);
    if let Some(camera) = scene.camera(sensor) {
        focal_length(path, &parameters, camera, findings);
        clipping(scene, path, &parameters, camera, findings);
    }
    sensor_size(scene, sensor, &parameters, findings);
    min_distance(path, &parameters, spec, findings);
    tof(path, &parameters, spec, findings);
}

/// Reports invalid values. Returns whether all are valid.
fn values(path: &str, parameters: &Parameters<'_>, findings: &mut Vec<Finding>) -> bool {
    let before = findings.len();
    for about in Attributes::rows().map(|row| row.about) {
        let has_own_rule = matches!(about.name, "confidenceThreshold" | "minDistance" | "maxDistance");
        if about.kind != Kind::Number || has_own_rule {
            continue;
        }
        let value = parameters.get(about.name);
        if !about.accepts(value) || about.name == "baselineMM" && value == 0.0 {
            let expected = about.expectation();
            findings.push(DEPTH_VALUE.with_remedy(
                path,
                format!("{} is {}", about.name, num(value)),
                format!("author {}", expected.trim_start_matches("expected ")),
            ));
        }
    }
    let (nearest, farthest) = (parameters.get("minDistance"), parameters.get("maxDistance"));
    if !(nearest >= 0.0 && nearest < farthest) {
        findings.push(DISTANCE_RANGE.at(
            path,
            format!(
                "minDistance is {} m and maxDistance {} m",
                parameters.text("minDistance"),
                parameters.text("maxDistance")
            ),
        ));
    }
    let threshold = parameters.get("confidenceThreshold");
    if !(0.0..=1.0).contains(&threshold) {
        findings.push(CONFIDENCE_THRESHOLD.at(path, format!("confidenceThreshold is {}", num(threshold))));
    }
    let sound = findings.len() == before;
    if parameters.get("noiseMean") == 0.0 {
        findings.push(NOISE_MEAN_ZERO.note(path, NOISE_MEAN_ZERO.what));
    }
    sound
}

fn focal_length(
    path: &str,
    parameters: &Parameters<'_>,
    camera: &CheckedCamera<'_>,
    findings: &mut Vec<Finding>,
) {
    let width = parameters.get("sensorSizePixel");
    let optics = camera.camera.optics();
    let by_aperture = width * optics.focal_length_mm / optics.horizontal_aperture_mm;
    let by_lens = camera
        .lens
        .as_ref()
        .and_then(crate::lens::Lens::intrinsics)
        .map(|k| k.fx * width / f64::from(k.size.width));
    if !by_aperture.is_finite() || !camera.camera.is_perspective() {
        return;
    }
    let value = parameters.get("focalLengthPixel");
    let fits = |fx: f64| (value - fx).abs() <= FOCAL_LENGTH_TOLERANCE_PX;
    if fits(by_aperture) || by_lens.is_some_and(fits) {
        return;
    }
    findings.push(FOCAL_LENGTH_PIXEL.with_remedy(
        path,
        format!(
            "focalLengthPixel is {}, but fx of {} is {by_aperture:.2} px for sensorSizePixel {}",
            parameters.text("focalLengthPixel"),
            camera.path(),
            parameters.text("sensorSizePixel"),
        ),
        format!("set focalLengthPixel to {}", by_aperture.round()),
    ));
}

fn sensor_size(
    scene: &CheckedScene<'_>,
    sensor: &CheckedDepthSensor<'_>,
    parameters: &Parameters<'_>,
    findings: &mut Vec<Finding>,
) {
    let value = parameters.get("sensorSizePixel");
    let rendered = sensor.product.and_then(crate::stage::RenderProduct::resolution);
    let own = scene.camera(sensor).and_then(CheckedCamera::own_size);
    let path = &sensor.prim.path;
    let is =
        |size: Option<oaktwin_camera::ImageSize>| size.is_some_and(|size| same(f64::from(size.width), value));
    let value = parameters.text("sensorSizePixel");
    match (rendered, own) {
        (_, Some(own)) if !is(Some(own)) => findings.push(SENSOR_SIZE_PIXEL.with_remedy(
            path,
            format!("sensorSizePixel is {value}, but the camera's image is {own}"),
            format!(
                "set it to {}, and focalLengthPixel to fx for that width",
                own.width
            ),
        )),
        (Some(rendered), Some(_)) if !is(Some(rendered)) => findings.push(SENSOR_SIZE_PIXEL.note(
            path,
            format!("the product renders {rendered} for a sensor {value} px wide, so disparity is rescaled"),
        )),
        (Some(rendered), None) if !is(Some(rendered)) => findings.push(SENSOR_SIZE_PIXEL.with_remedy(
            path,
            format!("sensorSizePixel is {value}, but the product renders {rendered}"),
            "make them equal, unless the simulated sensor and the image differ in width",
        )),
        _ => {}
    }
}

fn min_distance(path: &str, parameters: &Parameters<'_>, spec: Option<&Spec>, findings: &mut Vec<Finding>) {
    let limit = parameters.nearest_by_disparity_m();
    let value = parameters.get("minDistance");
    if value >= limit * (1.0 - 1e-3) {
        return;
    }
    let shipped = spec.is_some_and(|spec| {
        same(value, spec.min_distance_m) || spec.extended_min_distance_m.is_some_and(|min| same(value, min))
    });
    findings.push(MIN_DISTANCE.at_or_note(
        shipped,
        path,
        format!(
            "minDistance is {} m, but disparity already reaches its limit of {} px at {limit:.3} m{}",
            parameters.text("minDistance"),
            parameters.text("maxDisparityPixel"),
            if shipped { " (as in the sheet)" } else { "" }
        ),
    ));
}

fn clipping(
    scene: &CheckedScene<'_>,
    path: &str,
    parameters: &Parameters<'_>,
    camera: &CheckedCamera<'_>,
    findings: &mut Vec<Finding>,
) {
    let unit = scene.meters_per_unit();
    let (near, far) = camera.camera.clipping_range();
    let (near, far) = (near * unit, far * unit);
    let cuts_near = near > parameters.get("minDistance") * (1.0 + 1e-6);
    let cuts_far = parameters
        .authored("maxDistance")
        .is_some_and(|farthest| far < farthest * (1.0 - 1e-6));
    if cuts_near || cuts_far {
        findings.push(CLIPPED_RANGE.at(
            path,
            format!(
                "{} renders {} to {} m, but the depth sensor's range is {} to {} m",
                camera.path(),
                num(near),
                num(far),
                parameters.text("minDistance"),
                parameters.text("maxDistance")
            ),
        ));
    }
}

fn tof(path: &str, parameters: &Parameters<'_>, spec: Option<&Spec>, findings: &mut Vec<Finding>) {
    let baseline = parameters.get("baselineMM");
    if baseline.abs() >= SHORTEST_BASELINE_MM {
        return;
    }
    let shipped = spec.is_some_and(|spec| spec.kind == DepthKind::Tof && same(baseline, spec.baseline_mm));
    let at = |name: &str| {
        let distance = parameters.get(name);
        let disparity = parameters.disparity_px(distance);
        let error = parameters.get("noiseSigma") / disparity * 100.0;
        format!(
            "{disparity:.2} px at {} m (noiseSigma is {error:.0} % of it)",
            num(distance)
        )
    };
    findings.push(TOF_AS_STEREO.at_or_note(
        shipped,
        path,
        format!(
            "baselineMM is {}: disparity is {} and {}{}",
            parameters.text("baselineMM"),
            at("minDistance"),
            at("maxDistance"),
            if shipped {
                "; the sheet models its time-of-flight sensor this way"
            } else {
                ""
            }
        ),
    ));
}
