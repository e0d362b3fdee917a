use oaktwin_image::ImageView;

use super::{ImageRegion, is_valid};

/// The number of bins of a histogram: odd, so that one is centred on 0.
const BINS: usize = 41;
/// The ends of a histogram in multiples of the 95th percentile of the absolute errors.
const SPREAD: f32 = 2.0;

/// The errors of measured depth in a region, which are measured minus true distances. `None` where nothing was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Errors {
    /// The number of pixels that show a surface.
    pub pixels: u64,
    /// The share of these pixels that have a value, 0 to 1.
    pub fill_rate: f64,
    /// The median error in metres.
    pub median_error_m: Option<f64>,
    /// The median of the absolute errors in metres.
    pub median_absolute_error_m: Option<f64>,
    /// The median of the absolute errors in percent of the true distance.
    pub median_absolute_error_percent: Option<f64>,
    /// The 95th percentile of the absolute errors in metres.
    pub p95_absolute_error_m: Option<f64>,
    /// The distribution of the errors.
    pub histogram: Histogram,
}

/// The number of values in bins of equal width. Values beyond the ends are in the outer bins.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Histogram {
    /// The start of the first bin in metres.
    pub from_m: f64,
    /// The end of the last bin in metres.
    pub to_m: f64,
    /// The number of values in each bin.
    pub counts: Vec<u64>,
}

impl Errors {
    /// Compares measured with true depth of the same camera and size, metres.
    #[must_use]
    pub fn of(truth: ImageView<'_, f32>, measured: ImageView<'_, f32>, region: &ImageRegion) -> Self {
        let rows = region.rows_of(truth).zip(region.rows_of(measured));
        let pixels = rows.flat_map(|(truth, measured)| truth.iter().zip(measured));
        let seen: Vec<(f32, f32)> = pixels
            .map(|(truth, measured)| (*truth, *measured))
            .filter(|(truth, _)| is_valid(*truth))
            .collect();
        let valid: Vec<(f32, f32)> = seen
            .iter()
            .copied()
            .filter(|(_, measured)| is_valid(*measured))
            .collect();
        let mut errors: Vec<f32> = valid.iter().map(|(truth, measured)| measured - truth).collect();
        let mut percent: Vec<f32> = valid
            .iter()
            .map(|(truth, measured)| (measured - truth).abs() / truth * 100.0)
            .collect();
        let mut absolute: Vec<f32> = errors.iter().map(|error| error.abs()).collect();
        let p95 = quantile(&mut absolute, 0.95);
        Self {
            pixels: seen.len() as u64,
            fill_rate: if seen.is_empty() {
                0.0
            } else {
                valid.len() as f64 / seen.len() as f64
            },
            histogram: p95.map_or_else(Histogram::default, |p95| Histogram::of(&errors, SPREAD * p95)),
            median_error_m: quantile(&mut errors, 0.5).map(f64::from),
            median_absolute_error_m: quantile(&mut absolute, 0.5).map(f64::from),
            median_absolute_error_percent: quantile(&mut percent, 0.5).map(f64::from),
            p95_absolute_error_m: p95.map(f64::from),
        }
    }
}

impl Histogram {
    /// Counts values in bins from `−end` to `end`.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates, and is limited to the bins"
    )]
    fn of(values: &[f32], end: f32) -> Self {
        // Perfect measurements have a bin, too.
        let end = end.max(1e-4);
        let mut counts = vec![0; BINS];
        for value in values {
            let bin = (value / end + 1.0) * 0.5 * BINS as f32;
            counts[(bin.max(0.0) as usize).min(BINS - 1)] += 1;
        }
        Self {
            from_m: f64::from(-end),
            to_m: f64::from(end),
            counts,
        }
    }
}

/// The nearest-rank quantile of a share, which sorts many values no further than necessary; `None` without values.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
fn quantile(values: &mut [f32], share: f64) -> Option<f32> {
    let last = values.len().checked_sub(1)?;
    let rank = (share * last as f64).round() as usize;
    let (_, value, _) = values.select_nth_unstable_by(rank, f32::total_cmp);
    Some(*value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_image::Image;

    #[test]
    fn ignores_misses_and_counts_gaps() {
        let truth = Image::new(4, 1, vec![1.0, 2.0, f32::INFINITY, 4.0]).unwrap();
        let measured = Image::new(4, 1, vec![1.01, 0.0, 3.0, 3.8]).unwrap();
        let errors = Errors::of(
            (&truth).into(),
            (&measured).into(),
            &ImageRegion::centred(4, 1, 1.0),
        );
        assert_eq!(errors.pixels, 3);
        assert!((errors.fill_rate - 2.0 / 3.0).abs() < 1e-12);
        assert!((errors.p95_absolute_error_m.unwrap() - 0.2).abs() < 1e-6);
        let percent = errors.median_absolute_error_percent.unwrap();
        assert!((percent - 5.0).abs() < 1e-4, "{percent}");
        assert_eq!(errors.histogram.counts.iter().sum::<u64>(), 2);
    }

    #[test]
    fn nothing_measured_has_no_errors() {
        let truth = Image::filled(3, 3, 2.0);
        let measured = Image::filled(3, 3, 0.0);
        let errors = Errors::of(
            (&truth).into(),
            (&measured).into(),
            &ImageRegion::centred(3, 3, 1.0),
        );
        assert_eq!(
            (errors.pixels, errors.fill_rate, errors.median_error_m),
            (9, 0.0, None)
        );
        assert!(errors.histogram.counts.is_empty());
    }

    #[test]
    fn zero_is_in_the_middle_bin() {
        let histogram = Histogram::of(&[0.0, -9.0, 9.0, f32::MIN_POSITIVE], 1.0);
        assert_eq!(
            (
                histogram.counts[0],
                histogram.counts[BINS / 2],
                histogram.counts[BINS - 1]
            ),
            (1, 2, 1)
        );
    }
}
