/// A number of IEEE 754's half precision; single precision holds every one.
pub(crate) fn f32_from_half(half: u16) -> f32 {
    /// The value of the last bit of a subnormal half: 2⁻²⁴.
    const LAST_BIT: f32 = 1.0 / 16_777_216.0;
    let sign = u32::from(half >> 15) << 31;
    let exponent = u32::from((half >> 10) & 0x1F);
    let mantissa = u32::from(half & 0x3FF);
    let magnitude = match exponent {
        0 => (f32::from(half & 0x3FF) * LAST_BIT).to_bits(),
        // Infinity, and what is no number.
        31 => 0x7F80_0000 | (mantissa << 13),
        // The exponent's bias is 15 there, 127 here.
        _ => ((exponent + 112) << 23) | (mantissa << 13),
    };
    f32::from_bits(sign | magnitude)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_by_hand() {
        for (half, expected) in [
            (0x0000, 0.0),
            (0x3C00, 1.0),
            (0xC000, -2.0),
            (0x3555, 0.333_251_95),
            (0x7BFF, 65504.0),
            (0x0001, 5.960_464_5e-8),
            (0x03FF, 6.097_555e-5),
            (0x0400, 6.103_515_6e-5),
            (0x7C00, f32::INFINITY),
            (0xFC00, f32::NEG_INFINITY),
        ] {
            assert_eq!(f32_from_half(half), expected, "{half:#06x}");
        }
        assert!(f32_from_half(0x7E00).is_nan());
        assert!(f32_from_half(0x8000).is_sign_negative());
    }

    #[test]
    fn they_grow_with_their_bits() {
        for half in 0..0x7C00u16 {
            assert!(f32_from_half(half) < f32_from_half(half + 1), "{half:#06x}");
        }
    }
}
