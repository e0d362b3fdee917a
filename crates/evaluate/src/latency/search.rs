//! The search for the latency with the smallest residuals.

use super::track::Track;

/// The steps of the search in the time between two images, which bounds what the camera sees of the motion, and their limit.
const STEPS_PER_INTERVAL: f64 = 8.0;
const MAX_STEPS: usize = 20_000;
/// A latency is a rival if it leaves less than this times the smallest squares, and a thousandth of all.
const RIVAL: f64 = 2.0;

/// The images whose latencies are searched.
pub(super) struct Search<'a> {
    reference: &'a Track,
    /// The arrival and the position of each image.
    images: Vec<(f64, f64)>,
    longest_s: f64,
    step_s: f64,
}

/// The affine fit at a latency.
pub(super) struct Fit {
    pub(super) correlation: f64,
    /// The standard error of the latency, s.
    pub(super) latency_sigma_s: f64,
    pub(super) jitter_s: f64,
    pub(super) edge_noise: f64,
}

impl<'a> Search<'a> {
    /// Chooses the images for which the reference is known at every latency.
    pub(super) fn new(camera: &Track, reference: &'a Track, longest_s: f64) -> Self {
        let begin = reference
            .time_s
            .first()
            .map_or(f64::INFINITY, |first| first + longest_s);
        let end = reference.time_s.last().copied().unwrap_or(f64::NEG_INFINITY);
        let images = camera.time_s.iter().copied().zip(camera.position.iter().copied());
        let images: Vec<(f64, f64)> = images.filter(|(t, _)| (begin..=end).contains(t)).collect();
        let step_s = (camera.interval_s() / STEPS_PER_INTERVAL).max(longest_s / MAX_STEPS as f64);
        Self {
            reference,
            images,
            longest_s,
            step_s,
        }
    }

    pub(super) fn images(&self) -> usize {
        self.images.len()
    }

    /// The time that the images span, s.
    pub(super) fn seconds(&self) -> f64 {
        match &self.images[..] {
            [(first, _), .., (last, _)] => last - first,
            _ => 0.0,
        }
    }

    fn grid(&self) -> impl Iterator<Item = f64> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most MAX_STEPS"
        )]
        let steps = (self.longest_s / self.step_s).ceil() as usize;
        (0..=steps).map(move |step| (step as f64 * self.step_s).min(self.longest_s))
    }

    /// The part of the variance of the positions that a latency leaves unexplained.
    fn unexplained(&self, latency_s: f64) -> f64 {
        let pairs = self
            .images
            .iter()
            .map(|(t, y)| (self.reference.at(t - latency_s).0, *y));
        1.0 - RegressionLine::new(pairs).correlation.powi(2)
    }

    /// Returns the best latency, s.
    pub(super) fn best(&self) -> f64 {
        let scored = self
            .grid()
            .map(|latency_s| (self.unexplained(latency_s), latency_s));
        let (_, nearest) = scored.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default();
        // The golden section of the neighbourhood.
        let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut low, mut high) = (
            (nearest - self.step_s).max(0.0),
            (nearest + self.step_s).min(self.longest_s),
        );
        while high - low > 1e-7 {
            let (a, b) = (high - ratio * (high - low), low + ratio * (high - low));
            if self.unexplained(a) < self.unexplained(b) {
                high = b;
            } else {
                low = a;
            }
        }
        0.5 * (low + high)
    }

    /// Returns another latency that explains the positions almost as well.
    pub(super) fn rival(&self, best_s: f64) -> Option<f64> {
        let limit = RIVAL * self.unexplained(best_s) + 1e-3;
        let scores: Vec<(f64, f64)> = self
            .grid()
            .map(|latency_s| (latency_s, self.unexplained(latency_s)))
            .collect();
        let is_lowest = |at: usize| {
            let below = |other: Option<&(f64, f64)>| other.is_none_or(|other| scores[at].1 <= other.1);
            below(at.checked_sub(1).and_then(|before| scores.get(before))) && below(scores.get(at + 1))
        };
        let rivals = (0..scores.len()).filter(|at| is_lowest(*at) && scores[*at].1 < limit);
        rivals
            .map(|at| scores[at].0)
            .find(|latency_s| (latency_s - best_s).abs() > 2.0 * self.step_s)
    }

    pub(super) fn fit(&self, latency_s: f64) -> Fit {
        let of_image = |(t, y): &(f64, f64)| {
            let (x, speed) = self.reference.at(t - latency_s);
            (x, speed, *y)
        };
        let rows: Vec<(f64, f64, f64)> = self.images.iter().map(of_image).collect();
        let line = RegressionLine::new(rows.iter().map(|(x, _, y)| (*x, *y)));
        let residuals: Vec<f64> = rows.iter().map(|(x, _, y)| y - line.at(*x)).collect();
        let squares: f64 = residuals.iter().map(|r| r * r).sum();
        let variance = squares / (rows.len() as f64 - 3.0);
        // The change of positions with the latency, without what the affine function takes up.
        let speeds: Vec<f64> = rows.iter().map(|(_, speed, _)| line.slope * speed).collect();
        let taken = RegressionLine::new(rows.iter().zip(&speeds).map(|((x, ..), speed)| (*x, *speed)));
        let information: f64 = rows
            .iter()
            .zip(&speeds)
            .map(|((x, ..), speed)| (speed - taken.at(*x)).powi(2))
            .sum();
        let scatter = RegressionLine::new(
            speeds
                .iter()
                .zip(&residuals)
                .map(|(speed, r)| (speed * speed, r * r)),
        );
        Fit {
            correlation: line.correlation,
            latency_sigma_s: (variance / information).sqrt(),
            jitter_s: scatter.slope.max(0.0).sqrt(),
            edge_noise: match scatter.slope > 0.0 {
                true => scatter.at(0.0).max(0.0).sqrt(),
                false => variance.sqrt(),
            },
        }
    }
}

/// The line of the least squares.
struct RegressionLine {
    mean: (f64, f64),
    slope: f64,
    correlation: f64,
}

impl RegressionLine {
    fn new(points: impl Iterator<Item = (f64, f64)> + Clone) -> Self {
        let count = points.clone().count().max(1) as f64;
        let sum = points
            .clone()
            .fold((0.0, 0.0), |sum, (x, y)| (sum.0 + x, sum.1 + y));
        let mean = (sum.0 / count, sum.1 / count);
        let [mut xx, mut xy, mut yy] = [0.0; 3];
        for (x, y) in points {
            let (dx, dy) = (x - mean.0, y - mean.1);
            xx += dx * dx;
            xy += dx * dy;
            yy += dy * dy;
        }
        Self {
            mean,
            slope: if xx > 0.0 { xy / xx } else { 0.0 },
            correlation: if xx > 0.0 && yy > 0.0 {
                xy / (xx * yy).sqrt()
            } else {
                0.0
            },
        }
    }

    fn at(&self, x: f64) -> f64 {
        self.mean.1 + self.slope * (x - self.mean.0)
    }
}
