//! The transfer function of sRGB (IEC 61966-2-1) as a function and as tables.

use std::sync::LazyLock;

/// Converts an sRGB value of 0 to 1 to a linear one.
fn exact(srgb: f64) -> f64 {
    if srgb <= 0.040_45 {
        srgb / 12.92
    } else {
        ((srgb + 0.055) / 1.055).powf(2.4)
    }
}

static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    #[expect(clippy::cast_possible_truncation, reason = "rounded to float32")]
    let of = |i: usize| exact(i as f64 / 255.0) as f32;
    std::array::from_fn(of)
});

/// The smallest linear value that rounds to each sRGB value except the first.
static STEPS: LazyLock<[f32; 255]> = LazyLock::new(|| {
    #[expect(clippy::cast_possible_truncation, reason = "rounded to float32")]
    let of = |i: usize| exact((i as f64 + 0.5) / 255.0) as f32;
    std::array::from_fn(of)
});

/// Converts an sRGB value to a linear one, both from 0 to 1.
#[expect(clippy::cast_possible_truncation, reason = "rounded to float32")]
#[must_use]
pub fn linear(srgb: f32) -> f32 {
    exact(srgb.into()) as f32
}

/// Returns the linear values, 0 to 1, of all sRGB values.
#[must_use]
pub fn linear_from_srgb() -> &'static [f32; 256] {
    &LINEAR
}

/// The values 0 to 1 of bytes of data, which are linear already.
static DATA: [f32; 256] = {
    let mut values = [0.0; 256];
    let mut at = 0;
    while at < 256 {
        values[at] = at as f32 / 255.0;
        at += 1;
    }
    values
};

/// Returns the values, 0 to 1 in equal steps, of the bytes of an image that is not sRGB.
#[must_use]
pub fn linear_from_data() -> &'static [f32; 256] {
    &DATA
}

/// Returns the sRGB value nearest to a linear one. Values below 0 and NaN become 0, values above 1 become 255.
#[must_use]
pub fn srgb_from_linear(linear: f32) -> u8 {
    let below = STEPS.partition_point(|&step| step <= linear);
    u8::try_from(below).unwrap_or(u8::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_trip() {
        for (value, &linear) in (0u8..=255).zip(linear_from_srgb()) {
            assert_eq!(srgb_from_linear(linear), value);
        }
        assert_eq!(linear_from_srgb()[0], 0.0);
        assert_eq!(linear_from_srgb()[255], 1.0);
        // The standard's own number for a middle grey.
        assert!((linear_from_srgb()[119] - 0.184).abs() < 1e-3);
    }

    #[test]
    fn clamps_out_of_range_values() {
        let values = [-1.0, f32::NAN, f32::NEG_INFINITY, 1.5, f32::INFINITY, 0.214];
        assert_eq!(values.map(srgb_from_linear), [0, 0, 0, 255, 255, 127]);
    }
}
