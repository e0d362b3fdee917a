use oaktwin_camera::math::DVec3;

/// The errors of an accelerometer (m/s²) or a gyroscope (rad/s), per axis of the inertial sensor's frame. An error of 0 is
/// not simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelNoise {
    /// The density of the white noise, unit/√Hz: a sample has the standard deviation density · √rate.
    pub density: DVec3,
    /// The density of the noise whose integral is the bias, unit/s/√Hz.
    pub random_walk: DVec3,
    /// The standard deviation of the bias of the first sample, in the unit.
    pub turn_on_bias: DVec3,
    /// The largest absolute value that is reported, in the unit; infinite if unlimited.
    pub range: f64,
    /// The difference of successive values, in the unit; 0 if values are not quantized.
    pub step: f64,
}

impl ChannelNoise {
    /// No errors.
    pub const NONE: Self = Self {
        density: DVec3::ZERO,
        random_walk: DVec3::ZERO,
        turn_on_bias: DVec3::ZERO,
        range: f64::INFINITY,
        step: 0.0,
    };

    /// Returns the root mean square of the axes' densities of white noise.
    #[must_use]
    pub fn mean_density(&self) -> f64 {
        root_mean_square(self.density)
    }

    /// Returns the root mean square of the axes' random walks.
    #[must_use]
    pub fn mean_random_walk(&self) -> f64 {
        root_mean_square(self.random_walk)
    }

    /// Returns the standard deviation of the white noise of a sample at a rate in Hz.
    #[must_use]
    pub fn sample_deviation(&self, rate_hz: f64) -> DVec3 {
        self.density * rate_hz.sqrt()
    }

    /// Returns the standard deviation of the change of the bias between samples at a rate in Hz.
    #[must_use]
    pub fn bias_step_deviation(&self, rate_hz: f64) -> DVec3 {
        self.random_walk / rate_hz.sqrt()
    }

    /// Returns the value that is reported for a true value with its errors: limited to the range, then rounded to a multiple
    /// of the step within it.
    #[must_use]
    pub fn reported(&self, value: DVec3) -> DVec3 {
        let limited = value.clamp(DVec3::splat(-self.range), DVec3::splat(self.range));
        if self.step <= 0.0 {
            return limited;
        }
        let last = (self.range / self.step).floor();
        let code = (limited / self.step).round();
        code.clamp(DVec3::splat(-last), DVec3::splat(last)) * self.step
    }
}

/// Standard normal numbers of one sample and channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Draws {
    /// The white noise.
    pub white: DVec3,
    /// The change of the bias.
    pub walk: DVec3,
}

/// A channel whose bias moves from sample to sample.
#[derive(Clone, Copy, Debug)]
pub struct Channel {
    noise: ChannelNoise,
    white: DVec3,
    walk: DVec3,
    bias: DVec3,
}

impl Channel {
    /// Creates a channel that is sampled at a rate in Hz. `turn_on` are the standard normal numbers of the bias of the first
    /// sample.
    #[must_use]
    pub fn new(noise: ChannelNoise, rate_hz: f64, turn_on: DVec3) -> Self {
        Self {
            noise,
            white: noise.sample_deviation(rate_hz),
            walk: noise.bias_step_deviation(rate_hz),
            bias: noise.turn_on_bias * turn_on,
        }
    }

    /// Returns the reported value of the next sample.
    pub fn measure(&mut self, truth: DVec3, draws: Draws) -> DVec3 {
        let measured = self.noise.reported(truth + self.bias + self.white * draws.white);
        self.bias += self.walk * draws.walk;
        measured
    }

    /// Returns the standard deviation of the white noise of a sample.
    #[must_use]
    pub const fn white_deviation(&self) -> DVec3 {
        self.white
    }

    /// Returns the bias of the next sample.
    #[must_use]
    pub const fn bias(&self) -> DVec3 {
        self.bias
    }
}

fn root_mean_square(axes: DVec3) -> f64 {
    (axes.length_squared() / 3.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PART: ChannelNoise = ChannelNoise {
        range: 10.0,
        step: 0.3,
        ..ChannelNoise::NONE
    };

    #[test]
    fn values_are_multiples_of_the_step_within_the_range() {
        let reported = |x: f64| PART.reported(DVec3::splat(x)).x;
        assert_eq!(reported(0.14), 0.0);
        assert_eq!(reported(0.16), 0.3);
        assert_eq!(reported(-0.16), -0.3);
        // 33 steps are 9.9; 34 are beyond the range.
        assert_eq!(reported(9.99), 33.0 * 0.3);
        assert_eq!(reported(1e9), 33.0 * 0.3);
        assert_eq!(reported(-1e9), -33.0 * 0.3);
        let unlimited = ChannelNoise::NONE.reported(DVec3::new(1e9, -0.123, 0.0));
        assert_eq!(unlimited, DVec3::new(1e9, -0.123, 0.0));
    }

    #[test]
    fn the_bias_of_a_sample_precedes_its_change() {
        let noise = ChannelNoise {
            density: DVec3::new(0.1, 0.2, 0.3),
            random_walk: DVec3::splat(0.5),
            turn_on_bias: DVec3::splat(2.0),
            ..ChannelNoise::NONE
        };
        let mut channel = Channel::new(noise, 100.0, DVec3::new(1.0, 0.0, -1.0));
        let draws = Draws {
            white: DVec3::ONE,
            walk: DVec3::ONE,
        };
        // White noise has the deviation density · 10; the bias moves by walk / 10.
        let first = channel.measure(DVec3::ZERO, draws);
        assert!((first - DVec3::new(3.0, 2.0, 1.0)).length() < 1e-12);
        let second = channel.measure(DVec3::ZERO, draws);
        assert!((second - first - DVec3::splat(0.05)).length() < 1e-12);
        assert!((channel.bias() - DVec3::new(2.1, 0.1, -1.9)).length() < 1e-12);
    }
}
