//! Phase unwrapping: the period of each frequency in which a distance lies.

use super::parameters::Parameters;

/// The speed of light in vacuum, m/s (SI).
pub(super) const LIGHT_M_S: f64 = 299_792_458.0;

/// Whole periods of both frequencies in metres, which are added to the distances of their phases.
pub(super) type Periods = [f32; 2];

/// The conversion of two phases to one distance.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unwrapping {
    /// Metres per turn, c / 2f.
    pub(super) turn_m: [f32; 2],
    /// The weights of the two distances in their mean.
    pub(super) weights: [f32; 2],
    /// The candidates; of those that fit best, the first is taken.
    pub(super) candidates: Vec<Periods>,
    /// The maximum difference between the two distances, m.
    pub(super) threshold_m: f32,
}

/// The tolerance in single precision for a whole number of periods.
const SAME: f64 = 1e-6;

/// Returns the metres per turn of the phase, c / 2f: distances are ambiguous by multiples of it.
pub(super) fn turn_m(frequency_mhz: f64) -> f64 {
    LIGHT_M_S / (2e6 * frequency_mhz)
}

impl Unwrapping {
    #[expect(clippy::cast_possible_truncation, reason = "metres are single precision")]
    pub(super) fn new(p: &Parameters) -> Self {
        let turns = p.frequencies_mhz.map(turn_m);
        let turn_m = turns.map(|turn| turn as f32);
        if p.phase_unwrapping_level == 0 || !p.enable_phase_unwrapping {
            return Self {
                turn_m,
                weights: [1.0, 0.0],
                candidates: vec![[0.0; 2]],
                threshold_m: f32::INFINITY,
            };
        }
        // A distance's error is the phase's times the length of a turn: these weights minimize the variance.
        let squares = p.frequencies_mhz.map(|f| f * f);
        let weights = squares.map(|square| (square / (squares[0] + squares[1])) as f32);
        let most = range_m(p);
        let mut candidates = Vec::new();
        // The pairs of periods that contain a distance, from near to far.
        let (mut low, mut high) = (0.0, 0.0);
        while f64::max(low * turns[0], high * turns[1]) < most * (1.0 - SAME) {
            candidates.push([(low * turns[0]) as f32, (high * turns[1]) as f32]);
            let ends = [(low + 1.0) * turns[0], (high + 1.0) * turns[1]];
            let both = (ends[0] - ends[1]).abs() <= SAME * ends[0];
            if both || ends[0] < ends[1] {
                low += 1.0;
            }
            if both || ends[1] < ends[0] {
                high += 1.0;
            }
        }
        Self {
            turn_m,
            weights,
            candidates,
            threshold_m: (f64::from(p.phase_unwrap_error_threshold) / 1000.0) as f32,
        }
    }
}

/// Returns the unambiguous range, m: surfaces beyond it are reported nearer, or not at all.
pub(super) fn range_m(p: &Parameters) -> f64 {
    let turns = p.frequencies_mhz.map(turn_m);
    if p.phase_unwrapping_level == 0 || !p.enable_phase_unwrapping {
        return turns[0];
    }
    // Distances repeat where both frequencies begin a period.
    let anew = (1..=p.phase_unwrapping_level + 1).find(|&periods| {
        let low = f64::from(periods) * turns[1] / turns[0];
        (low - low.round()).abs() <= SAME * low && low.round() >= 1.0
    });
    f64::from(anew.unwrap_or(p.phase_unwrapping_level + 1)) * turns[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(level: u32) -> Parameters {
        Parameters {
            phase_unwrapping_level: level,
            ..Parameters::new(457.0, 640)
        }
    }

    #[test]
    fn levels_are_depthais_ranges() {
        let documented = [1.87, 3.0, 4.5, 6.0, 7.5, 7.5];
        for (level, metres) in (0..).zip(documented) {
            assert!((range_m(&at(level)) - metres).abs() < 0.01, "{level}");
        }
        let off = Parameters {
            enable_phase_unwrapping: false,
            ..at(4)
        };
        assert_eq!(range_m(&off), range_m(&at(0)));
        assert_eq!(Unwrapping::new(&off), Unwrapping::new(&at(0)));
    }

    #[test]
    #[expect(clippy::cast_possible_truncation, reason = "as candidates are")]
    fn each_distance_in_range_has_its_periods() {
        for (level, count) in (0..6).zip([1, 3, 5, 7, 8, 8]) {
            let unwrapping = Unwrapping::new(&at(level));
            assert_eq!(unwrapping.candidates.len(), count);
            let turns = at(level).frequencies_mhz.map(turn_m);
            for i in 0..1000 {
                let r = (f64::from(i) + 0.5) / 1000.0 * range_m(&at(level));
                let periods = turns.map(|turn| ((r / turn).floor() * turn) as f32);
                let found = unwrapping.candidates.contains(&periods);
                assert!(found || level == 0, "{level} {r}");
            }
        }
    }

    /// What no whole multiple of both frequencies ends is looked through up to the level.
    #[test]
    fn frequencies_of_any_kind() {
        for pair in [[20.0, 100.0], [1.0, 1000.0], [83.1, 97.3], [99.999, 100.0]] {
            let p = Parameters {
                frequencies_mhz: pair,
                ..at(4)
            };
            let unwrapping = Unwrapping::new(&p);
            assert!(!unwrapping.candidates.is_empty() && unwrapping.candidates.len() < 20);
            assert!(range_m(&p) > 0.1);
        }
    }
}
