use super::PreviewOptions;
use crate::Image;

/// The ratio of maximum and minimum above which the scale is logarithmic, so that near depths do not share a few colours.
const LOGARITHMIC_FROM: f32 = 12.0;

/// The number of samples for finding the range of an image.
const SAMPLES: usize = 1 << 18;

/// The used steps of turbo, without its nearly black ends.
const STEPS: std::ops::RangeInclusive<u8> = 12..=243;

/// The mapping of depths to steps of the colour map.
pub(super) struct Scale {
    pub(super) near: f32,
    pub(super) far: f32,
    logarithmic: bool,
    offset: f32,
    factor: f32,
}

impl Scale {
    /// Creates a scale, or returns `None` if no depth is valid.
    pub(super) fn of(metres: &Image<f32>, options: &PreviewOptions) -> Option<Self> {
        let (near, far) = match options.range {
            Some((near, far)) => (near.min(far), near.max(far)),
            None => range(metres)?,
        };
        // A constant depth still has a colour and a scale.
        let near = near.max(1e-6);
        let far = if far > near { far } else { near * 1.001 };
        let logarithmic = far / near > LOGARITHMIC_FROM;
        let place = |z| if logarithmic { log2(z) } else { z };
        Some(Self {
            near,
            far,
            logarithmic,
            offset: place(near),
            factor: 1.0 / (place(far) - place(near)),
        })
    }

    /// Returns the position on the scale: 0 at the near end, 1 at the far end.
    pub(super) fn place(&self, metres: f32) -> f32 {
        let value = if self.logarithmic { log2(metres) } else { metres };
        (value - self.offset) * self.factor
    }

    /// Returns round numbers for labels, coarsest first.
    pub(super) fn ticks(&self) -> Vec<f32> {
        let mut ticks = Vec::new();
        // From 1 µm to 10 000 km.
        let decades = (-6..8).map(|exponent| 10f32.powi(exponent));
        if self.logarithmic {
            let decades: Vec<f32> = decades.collect();
            for digit in [1.0, 3.0, 2.0, 5.0] {
                ticks.extend(decades.iter().map(|decade| digit * decade));
            }
            ticks.retain(|&tick| tick > self.near && tick < self.far);
            return ticks;
        }
        let length = self.far - self.near;
        let steps = decades.flat_map(|decade| [decade, 2.0 * decade, 5.0 * decade]);
        let Some(step) = steps.into_iter().find(|step| length / step <= 8.0) else {
            return ticks;
        };
        let first = (self.near / step).ceil();
        ticks.extend((0u8..=8).map(|i| (first + f32::from(i)) * step));
        ticks.retain(|&tick| tick > self.near && tick < self.far);
        ticks
    }
}

/// Returns the step of turbo for a position between the near end, 0, and the far end, 1.
pub(super) fn step(place: f32) -> usize {
    let (far, near) = (f32::from(*STEPS.start()), f32::from(*STEPS.end()));
    let step = near - place.clamp(0.0, 1.0) * (near - far);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "within the steps"
    )]
    let step = (step + 0.5) as u8;
    usize::from(step)
}

/// Returns the minimum and maximum depth without half a percent at both ends.
pub(super) fn range(metres: &Image<f32>) -> Option<(f32, f32)> {
    let stride = (metres.pixels().len() / SAMPLES).max(1);
    // Not a divisor of common widths, so that all columns are sampled.
    let stride = if stride > 1 { stride | 1 } else { 1 };
    let sample = |stride| -> Vec<f32> {
        let pixels = metres.pixels().iter().step_by(stride);
        pixels.copied().filter(|&z| is_value(z)).collect()
    };
    let mut values = sample(stride);
    if values.is_empty() {
        values = sample(1);
    }
    let last = values.len().checked_sub(1)?;
    let cut = values.len() / 200;
    let (_, &mut near, _) = values.select_nth_unstable_by(cut, f32::total_cmp);
    let (_, &mut far, _) = values.select_nth_unstable_by(last - cut, f32::total_cmp);
    Some((near, far))
}

/// Returns the base-2 logarithm of a positive, finite number, within 3e-5. Unlike the system's `log`, its operations are rounded
/// identically on all machines.
fn log2(x: f32) -> f32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23) as f32 - 127.0;
    let mantissa = f32::from_bits((bits & 0x007F_FFFF) | 0x3F80_0000);
    // ln m = 2 atanh((m − 1)/(m + 1))
    let t = (mantissa - 1.0) / (mantissa + 1.0);
    let u = t * t;
    let atanh = t * (1.0 + u * (1.0 / 3.0 + u * (1.0 / 5.0 + u * (1.0 / 7.0))));
    exponent + atanh * (2.0 * std::f32::consts::LOG2_E)
}

/// Whether a depth is valid.
pub(super) fn is_value(metres: f32) -> bool {
    metres > 0.0 && metres < f32::INFINITY
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ramp(width: u32, near: f32, far: f32) -> Image<f32> {
        let row = (0..width).map(|x| near + (far - near) * x as f32 / (width - 1) as f32);
        Image::new(width, 2, row.clone().chain(row).collect()).unwrap()
    }

    #[test]
    fn range_ignores_outliers() {
        let mut image = ramp(1000, 1.0, 2.0);
        image.pixels_mut()[3] = 1e9;
        let scale = Scale::of(&image, &PreviewOptions::default()).unwrap();
        assert!((1.0..1.02).contains(&scale.near) && (1.98..=2.0).contains(&scale.far));
        assert!(!scale.logarithmic);
        assert_eq!(step(scale.place(1e9)), 12);
        assert_eq!(scale.ticks().len(), 4, "{:?}", scale.ticks());
        // One value among thousands of misses is found.
        let mut sparse = Image::filled(2000, 1000, f32::INFINITY);
        sparse.pixels_mut()[1_234_567] = 4.0;
        assert_eq!(range(&sparse), Some((4.0, 4.0)));
    }

    #[test]
    fn wide_ranges_are_logarithmic() {
        let scale = Scale::of(
            &ramp(9, 0.1, 100.0),
            &PreviewOptions {
                range: Some((0.1, 100.0)),
            },
        )
        .unwrap();
        assert!(scale.logarithmic);
        assert_eq!(
            [0.1, 1.0, 10.0, 100.0].map(|z| step(scale.place(z))),
            [243, 166, 89, 12]
        );
        assert!(scale.ticks().starts_with(&[1.0, 10.0]));
    }

    proptest! {
        #[test]
        fn log2_is_close(x in 1e-30..1e30f32) {
            prop_assert!((log2(x) - x.log2()).abs() < 1e-4);
        }
    }
}
