//! The errors in closed form, for a wide surface that faces the camera.

use std::f64::consts::TAU;

use super::parameters::Parameters;
use super::unwrap::turn_m;

impl Parameters {
    /// The weight of each frequency's distance in the reported one.
    fn weights(&self) -> [f64; 2] {
        if self.phase_unwrapping_level == 0 || !self.enable_phase_unwrapping {
            return [1.0, 0.0];
        }
        let squares = self.frequencies_mhz.map(|f| f * f);
        squares.map(|square| square / (squares[0] + squares[1]))
    }

    /// The weighted c / 2f of both frequencies, m: the distance error of one wrong period of each.
    #[must_use]
    pub fn period_m(&self) -> f64 {
        let [a, b] = self.weights();
        let [low, high] = self.frequencies_mhz.map(turn_m);
        a * low + b * high
    }

    /// The amplitude of the phase's periodic error, after its correction if that is enabled.
    #[must_use]
    pub fn wiggling_left(&self) -> f64 {
        if self.enable_wiggle_correction {
            self.wiggling_residual
        } else {
            self.wiggling
        }
    }

    /// Returns the error of a distance along the ray due to wiggling of this amplitude, m.
    #[must_use]
    pub fn wiggle_m(&self, range_m: f64, amplitude: f64) -> f64 {
        let errors = self.frequencies_mhz.map(turn_m).map(|turn| {
            let phase = TAU * range_m / turn;
            -(amplitude * (4.0 * phase).sin()).atan() * turn / TAU
        });
        let [a, b] = self.weights();
        a * errors[0] + b * errors[1]
    }

    /// Returns the variance over time of a distance along a ray, m², without the rounding to millimetres; `cosine` is of the
    /// angle between the ray and the surface normal. Valid while the phase noise is a small part of a turn.
    #[must_use]
    pub fn range_variance_m2(&self, range_m: f64, cosine: f64) -> f64 {
        let light = self.signal_e * self.albedo * cosine / (range_m * range_m);
        let ambient = self.ambient_e * self.albedo;
        let averaged = if self.enable_phase_shuffle_temporal_filter {
            0.5
        } else {
            1.0
        };
        let phasor = averaged * (light + ambient + self.read_noise_e * self.read_noise_e) / 2.0;
        let variances = self.frequencies_mhz.map(turn_m).map(|turn| {
            let shape = 1.0 + self.wiggling * (4.0 * TAU * range_m / turn).cos();
            let length = self.contrast * light * shape;
            let phase = phasor / (length * length);
            // To second order: the noise of an angle grows faster than its phasor's.
            phase * (1.0 + phase) * (turn / TAU) * (turn / TAU)
        });
        let [a, b] = self.weights();
        a * a * variances[0] + b * b * variances[1]
    }

    /// Returns the share of a frame's noise that the next frame repeats, 0 to 1.
    #[must_use]
    pub fn shared_noise(&self) -> f64 {
        if self.enable_phase_shuffle_temporal_filter && !self.enable_burst_mode {
            0.5
        } else {
            0.0
        }
    }
}
