//! White noise from an integer hash, which is identical on all computers.

/// Returns a number from 0 to 1 that depends only on a position and the noise's number (`kind`).
#[must_use]
pub fn white(x: i32, y: i32, kind: u32) -> f32 {
    let mut h = x
        .cast_unsigned()
        .wrapping_mul(0x9E37_79B1)
        .wrapping_add(y.cast_unsigned().wrapping_mul(0x85EB_CA77))
        .wrapping_add(kind.wrapping_mul(0xC2B2_AE3D));
    h = (h ^ h >> 15).wrapping_mul(0x2C1B_3C6D);
    h = (h ^ h >> 12).wrapping_mul(0x297A_2D39);
    h ^= h >> 15;
    #[expect(clippy::cast_precision_loss, reason = "24 bits")]
    let value = (h >> 8) as f32 / 16_777_215.0;
    value
}
