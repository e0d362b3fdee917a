//! The drift of a stereo pair since its calibration, and the baseline of its design, in the engines that measure depth images.

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint, StereoDrift};
use oaktwin_depth::{DriftedPair, EngineInput, EngineKind, ParameterError, Setup};

use super::setup::GeometrySource;
use super::{STEREO_NOISE, SensorOptions};

/// The columns and rows of the points at which the loss is computed.
const POINTS: (u32, u32) = (16, 10);

/// The depth of the points, m.
const FAR_M: f64 = 5.0;

/// Returns the pair that an engine measures depth images of, if its processor assumes another geometry than the cameras have.
pub(super) fn pair(
    kind: &EngineKind,
    source: &GeometrySource<'_>,
    options: &SensorOptions,
    setup: &Setup,
    place: &str,
    findings: &mut Vec<Finding>,
) -> Result<Option<DriftedPair>, ParameterError> {
    let pair = (*kind == STEREO_NOISE)
        .then(|| geometry(source, options, setup))
        .flatten();
    let Some(drift) = options.drift.filter(|drift| !drift.is_none()) else {
        return Ok(pair.filter(|pair| pair.depth_baseline_m != pair.baseline_m));
    };
    if kind.input == EngineInput::Pair {
        return match source {
            GeometrySource::Twin { .. } => Ok(None),
            _ => Err(ParameterError::new(
                "drift",
                "recorded pairs contain the drift of their own cameras",
                "remove it",
            )),
        };
    }
    if let Some(pair) = pair {
        return Ok(Some(DriftedPair { drift, ..pair }));
    }
    let message = format!(
        "{} has no stereo pair that drifts; the option is ignored",
        kind.name
    );
    findings.push(Finding::new(
        "ignored",
        Level::Warning,
        place,
        message,
        "use stereo-noise with an OAK",
    ));
    Ok(None)
}

/// Adds the share of pixels that the matcher of a drifted pair loses, unless it is given.
pub(super) fn add_loss(pair: &DriftedPair, setup: &mut Setup) {
    if pair.drift.is_none() || setup.sets("dropout") {
        return;
    }
    let scale = f64::from(setup.width_px) / f64::from(pair.intrinsics.size.width.max(1));
    let lost = lost_share(&pair.drift, &pair.intrinsics, pair.baseline_m, scale);
    setup.parameters.push(("dropout".to_owned(), lost.into()));
}

/// The rectified pair as it was calibrated.
fn geometry(source: &GeometrySource<'_>, options: &SensorOptions, setup: &Setup) -> Option<DriftedPair> {
    let GeometrySource::Twin { twin, sensor, .. } = source else {
        return None;
    };
    let pair = sensor.spec.pair()?;
    let baseline_m = twin.baseline_m(pair)?;
    Some(DriftedPair {
        drift: StereoDrift::default(),
        intrinsics: options
            .image
            .or_else(|| Some(twin.depth_camera(sensor)?.intrinsics))?,
        baseline_m,
        // A bias that is given, for example by a fit, contains the error of the baseline.
        depth_baseline_m: if setup.sets("bias") {
            baseline_m
        } else {
            twin.depth_baseline_m(pair)?
        },
    })
}

/// The share of pixels that the matcher loses, the mean over the image; `scale` is the number of the matcher's pixels in one of the
/// image.
fn lost_share(drift: &StereoDrift, intrinsics: &Intrinsics, baseline_m: f64, scale: f64) -> f64 {
    let ImageSize { width, height } = intrinsics.size;
    let matches = drift.matches(intrinsics, baseline_m);
    let (columns, rows) = POINTS;
    let lost = |x: u32, y: u32| {
        let at = |index: u32, count: u32, size: u32| {
            (f64::from(index) + 0.5) / f64::from(count) * f64::from(size) - 0.5
        };
        let pixel = PixelPoint::<OpenCv>::new(at(x, columns, width), at(y, rows, height));
        lost_at(matches.error(pixel, FAR_M).row_px * scale)
    };
    let points = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
    let mean = points.map(|(x, y)| lost(x, y)).sum::<f64>() / f64::from(columns * rows);
    // Rounded, so that it is the same on every machine.
    (mean * 1e4).round() / 1e4
}

/// The share of pixels that the matcher loses where the right image is `row_px` too low. Measured with `stereo-matching` in a
/// rendered room, with and without dots: 1.5 to 2.5 % are lost at 0.44 px, 6 % at 0.9 px, 20 % at 1.8 px and 53 % at 3.5 px.
fn lost_at(row_px: f64) -> f64 {
    1.0 - (-(row_px.abs() / 4.2).powf(1.75)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loss_grows_with_the_vertical_offset() {
        let size = ImageSize::new(1280, 800);
        let centre = PixelPoint::<OpenCv>::new(639.5, 399.5);
        let intrinsics = Intrinsics::new(size, 882.0, 882.0, centre);
        let lost = |drift: &str, scale: f64| {
            let drift = StereoDrift::parse(drift).unwrap();
            lost_share(&drift, &intrinsics, 0.075, scale)
        };
        assert!(lost("yaw=3", 1.0) < 0.02);
        let expected = [(0.5, 0.02), (1.0, 0.063), (2.0, 0.2), (4.0, 0.53)];
        for (pitch, share) in expected {
            let found = lost(&format!("pitch={pitch}"), 1.0);
            // The mean over an image whose borders have larger offsets.
            assert!((found - share).abs() < 0.04, "{pitch}: {found}");
        }
        // The matcher of half the width sees half the offset.
        assert!((lost("pitch=4", 0.5) - lost("pitch=2", 1.0)).abs() < 1e-3);
    }
}
