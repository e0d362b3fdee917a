//! Random scenes and cameras, reproducible from a seed.

mod scene;
mod view;

pub use scene::{Kind, scene};
pub use view::{Lens, view};

use oaktwin_camera::math::{DMat3, DQuat, DVec3};

/// A random number generator (`SplitMix64`).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Creates a generator from a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a number from `low` up to `high`, uniformly distributed.
    #[expect(clippy::cast_precision_loss, reason = "53 bits are enough")]
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1u64 << 53) as f64;
        low + (high - low) * unit
    }

    /// Returns a number from `low` up to `high`, uniformly distributed in its logarithm.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.range(low.ln(), high.ln()).exp()
    }

    /// Returns an integer below `end`.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "0 to `end`"
    )]
    pub fn below(&mut self, end: u32) -> u32 {
        self.range(0.0, f64::from(end)) as u32
    }

    /// Returns a point in a cube with a half edge of 1.
    pub fn in_cube(&mut self) -> DVec3 {
        DVec3::new(
            self.range(-1.0, 1.0),
            self.range(-1.0, 1.0),
            self.range(-1.0, 1.0),
        )
    }

    /// Returns a unit vector.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let v = self.in_cube();
            let squared = v.length_squared();
            if squared > 0.01 && squared <= 1.0 {
                return v / squared.sqrt();
            }
        }
    }

    /// Returns a rotation.
    pub fn rotation(&mut self) -> DMat3 {
        let angle = self.range(-3.2, 3.2);
        DMat3::from_quat(DQuat::from_axis_angle(self.direction(), angle))
    }
}
