//! Latencies in constant memory.

use std::time::Duration;

use serde::Serialize;

/// The width of a bin.
const BIN: Duration = Duration::from_micros(100);
/// Latencies from here are counted together.
const LAST: usize = 20_000;

/// A histogram of latencies.
#[derive(Clone, Debug)]
pub(crate) struct Latencies {
    bins: Vec<u64>,
    count: u64,
    longest: Duration,
}

/// Percentiles of latencies, milliseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Percentiles {
    /// Half of all are at most this.
    pub median: f64,
    /// 95 of 100 are at most this.
    pub p95: f64,
    /// The longest.
    pub longest: f64,
}

impl Default for Latencies {
    fn default() -> Self {
        Self {
            bins: vec![0; LAST + 1],
            count: 0,
            longest: Duration::ZERO,
        }
    }
}

impl Latencies {
    /// Adds a latency.
    pub(crate) fn add(&mut self, latency: Duration) {
        let bin = usize::try_from(latency.as_micros() / BIN.as_micros()).map_or(LAST, |bin| bin.min(LAST));
        self.bins[bin] += 1;
        self.count += 1;
        self.longest = self.longest.max(latency);
    }

    /// Returns the percentiles to a tenth of a millisecond; `None` before the first latency.
    pub(crate) fn percentiles(&self) -> Option<Percentiles> {
        let longest = (self.longest.as_secs_f64() * 1e4).round() / 10.0;
        (self.count > 0).then(|| Percentiles {
            median: self.percentile(50).min(longest),
            p95: self.percentile(95).min(longest),
            longest,
        })
    }

    /// The upper end of the bin with the percentile, milliseconds.
    fn percentile(&self, percent: u64) -> f64 {
        let rank = (self.count * percent).div_ceil(100).max(1);
        let mut below = 0;
        let bin = self.bins.iter().position(|count| {
            below += count;
            below >= rank
        });
        match bin {
            // A bin is a tenth of a millisecond.
            Some(bin) if bin < LAST => (bin + 1) as f64 / 10.0,
            _ => self.longest.as_secs_f64() * 1e3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_of_all_latencies() {
        let mut latencies = Latencies::default();
        assert_eq!(latencies.percentiles(), None);
        for ms in 1..=100u64 {
            latencies.add(Duration::from_micros(ms * 1000 - 50));
        }
        let found = latencies.percentiles().unwrap();
        assert!(
            (found.median - 50.0).abs() < 0.11 && (found.p95 - 95.0).abs() < 0.11,
            "{found:?}"
        );
        assert!((found.longest - 100.0).abs() < 0.11);
        latencies.add(Duration::from_secs(3600));
        assert_eq!(latencies.percentiles().unwrap().longest, 3_600_000.0);
    }
}
