//! Estimates the latency of a camera from a recording of a moving edge.
//!
//! The camera reports where the edge is in each image, with the time at which the image arrived; a reference, such as an encoder of the
//! axis that moves the edge, reports where it was, on the same clock. The position in an image that arrives at t is taken for an affine
//! function of the reference's position at t − L, which is interpolated linearly between samples. The latency L is the one with the smallest
//! sum of squared residuals, that is, the largest correlation; it is not limited to whole frames. As the edge is blurred symmetrically by
//! the exposure, L counts from the middle of the exposure.
//!
//! The residual of a frame is the measurement noise of the edge, plus the frame's own delay times the speed of the edge. A line through the
//! squared residuals over the squared speeds therefore separates the two: its slope is the variance of the delay (`jitter`), and its intercept
//! is the variance of the measured edge.

mod search;
#[cfg(test)]
mod tests;
mod track;

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_files::FileError;
use serde::Serialize;

pub use track::Track;

use search::Search;

/// The longest latency that is searched by default, s.
pub const LONGEST_S: f64 = 1.0;
/// The number of images that an estimate needs.
const LEAST_IMAGES: usize = 20;
/// The distance from a limit of the search at which a latency lies on it, s.
const AT_LIMIT_S: f64 = 1e-6;
/// The correlation below which the camera does not see the reference's motion.
const LEAST_CORRELATION: f64 = 0.9;

/// The reason why nothing was estimated.
#[derive(Debug, thiserror::Error)]
pub enum LatencyError {
    /// A file cannot be read or understood.
    #[error(transparent)]
    File(#[from] FileError),
    /// The recordings do not determine a latency.
    #[error("{0}")]
    Recording(Message),
}

/// An estimated latency.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LatencyReport {
    /// The time from the middle of an exposure until its image arrives, s.
    pub latency_s: f64,
    /// The 95 % confidence interval, s.
    #[serde(rename = "confidence_interval_95")]
    pub interval_95_s: (f64, f64),
    /// The standard deviation of the latency from frame to frame, s.
    pub jitter_s: f64,
    /// The standard deviation of the edge in a motionless image, in the camera's unit.
    pub edge_noise: f64,
    /// The correlation of the camera with the delayed reference, between −1 and 1.
    pub correlation: f64,
    /// The number of images used.
    pub images: usize,
    /// The time that they span, s.
    pub seconds: f64,
    /// The files.
    pub sources: Vec<String>,
    /// Whether nothing was reported.
    pub passed: bool,
}

/// Estimates the latency of a camera whose images arrived at the times of a track, up to a longest one in seconds. The findings are about
/// the recordings.
///
/// # Errors
/// Returns an error if `longest_s` is out of range, if the reference does not cover 20 images with their latencies, or if the camera
/// does not see the motion of the reference.
pub fn latency(
    camera: &Track,
    reference: &Track,
    longest_s: f64,
) -> Result<(LatencyReport, Vec<Finding>), LatencyError> {
    if !(longest_s > 0.0 && longest_s <= 60.0) {
        let (option, is) = (
            opt("longest"),
            format!(" {longest_s}: is out of range; give seconds above 0, up to 60"),
        );
        return Err(LatencyError::Recording(message![option, is]));
    }
    let search = Search::new(camera, reference, longest_s);
    if search.images() < LEAST_IMAGES {
        return Err(LatencyError::Recording(message![
            format!(
                "{}: has {} images while the reference was recorded for all latencies up to {longest_s} s, of the {LEAST_IMAGES} \
                 needed; record longer, begin the reference earlier, or reduce ",
                camera.name,
                search.images()
            ),
            opt("longest")
        ]));
    }
    let best = search.best();
    let fit = search.fit(best);
    if fit.correlation.abs() < LEAST_CORRELATION {
        return Err(LatencyError::Recording(message![
            format!(
                "{}: correlates with {} by {:.2} at most, at {:.1} ms; check that both have the same clock and that the edge \
                 moves, or raise ",
                camera.name,
                reference.name,
                fit.correlation.abs(),
                1e3 * best
            ),
            opt("longest")
        ]));
    }
    let findings = findings(&search, best, longest_s, camera);
    let deviation = 1.959_964 * fit.latency_sigma_s;
    let report = LatencyReport {
        latency_s: best,
        interval_95_s: (best - deviation, best + deviation),
        jitter_s: fit.jitter_s,
        edge_noise: fit.edge_noise,
        correlation: fit.correlation,
        images: search.images(),
        seconds: search.seconds(),
        sources: vec![camera.name.clone(), reference.name.clone()],
        passed: findings.is_empty(),
    };
    Ok((report, findings))
}

fn findings(search: &Search<'_>, best: f64, longest_s: f64, camera: &Track) -> Vec<Finding> {
    let mut findings = Vec::new();
    if best < AT_LIMIT_S || best > longest_s - AT_LIMIT_S {
        findings.push(Finding::new(
            "latency-at-limit",
            Level::Warning,
            &camera.name,
            format!(
                "the best latency, {:.1} ms, is at a limit of the search",
                1e3 * best
            ),
            message![
                "check that times are those at which images arrived, or raise ",
                opt("longest")
            ],
        ));
    }
    if let Some(other) = search.rival(best) {
        findings.push(Finding::new(
            "latency-ambiguous",
            Level::Warning,
            &camera.name,
            format!(
                "{:.1} ms explains the positions almost as well as {:.1} ms",
                1e3 * other,
                1e3 * best
            ),
            message!["move the edge irregularly, or reduce ", opt("longest")],
        ));
    }
    findings
}
