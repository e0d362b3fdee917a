//! sRGB's transfer function (IEC 61966-2-1), by tables.

use std::sync::LazyLock;

/// The linear value, 0 to 1, of an sRGB value of 0 to 1.
fn linear(srgb: f64) -> f64 {
    if srgb <= 0.040_45 {
        srgb / 12.92
    } else {
        ((srgb + 0.055) / 1.055).powf(2.4)
    }
}

static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    #[expect(clippy::cast_possible_truncation, reason = "rounded to float32")]
    let of = |i: usize| linear(i as f64 / 255.0) as f32;
    std::array::from_fn(of)
});

/// The linear values from which on each sRGB value but the first is the nearest.
static STEPS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    #[expect(clippy::cast_possible_truncation, reason = "rounded to float32")]
    let of = |i: usize| linear((i as f64 + 0.5) / 255.0) as f32;
    std::array::from_fn(of)
});

/// The linear values, 0 to 1, of all sRGB values.
#[must_use]
pub fn linear_from_srgb() -> &'static [f32; 256] {
    &LINEAR
}

/// The sRGB value that is nearest to a linear one; below 0 (and NaN) is 0, above 1 is 255.
#[must_use]
pub fn srgb_from_linear(linear: f32) -> u8 {
    let below = STEPS.partition_point(|&step| step <= linear);
    u8::try_from(below).unwrap_or(u8::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        for (value, &linear) in (0u8..=255).zip(linear_from_srgb()) {
            assert_eq!(srgb_from_linear(linear), value);
        }
        assert_eq!(linear_from_srgb()[0], 0.0);
        assert_eq!(linear_from_srgb()[255], 1.0);
        // The standard's own number for a middle grey.
        assert!((linear_from_srgb()[119] - 0.184).abs() < 1e-3);
    }

    #[test]
    fn out_of_range() {
        let values = [-1.0, f32::NAN, f32::NEG_INFINITY, 1.5, f32::INFINITY, 0.214];
        assert_eq!(values.map(srgb_from_linear), [0, 0, 0, 255, 255, 127]);
    }
}
