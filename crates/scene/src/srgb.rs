//! The transfer function of sRGB.

/// Converts sRGB to linear, both from 0 to 1 (IEC 61966-2-1).
#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
#[must_use]
pub fn linear(encoded: f32) -> f32 {
    let encoded = f64::from(encoded);
    if encoded <= 0.040_45 {
        (encoded / 12.92) as f32
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4) as f32
    }
}
