/// A point of an Allan deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AllanPoint {
    /// The averaging time τ in seconds.
    pub tau_s: f64,
    /// The deviation in the unit of the samples.
    pub deviation: f64,
    /// The number of differences that were averaged.
    pub differences: usize,
}

/// Returns the overlapping Allan deviation of samples at a rate in Hz, for averages of `clusters` samples. Sizes of 0, and
/// those with no two successive averages in the samples, are skipped.
///
/// White noise of density N reads N/√τ, a random walk of density K reads K·√(τ/3) (IEEE Std 952, annex C).
#[must_use]
pub fn allan_deviation(samples: &[f64], rate_hz: f64, clusters: &[usize]) -> Vec<AllanPoint> {
    let mut sums = Vec::with_capacity(samples.len() + 1);
    sums.push(0.0);
    let mut sum = 0.0;
    for sample in samples {
        sum += sample;
        sums.push(sum);
    }
    let fits = |size: &usize| *size > 0 && size.saturating_mul(2) <= samples.len();
    let point = |size: usize| {
        let differences = samples.len() - 2 * size + 1;
        let squares: f64 = (0..differences)
            .map(|at| {
                let change = sums[at + 2 * size] - 2.0 * sums[at + size] + sums[at];
                (change / size as f64).powi(2)
            })
            .sum();
        AllanPoint {
            tau_s: size as f64 / rate_hz,
            deviation: (squares / (2.0 * differences as f64)).sqrt(),
            differences,
        }
    };
    clusters.iter().copied().filter(fits).map(point).collect()
}
