//! Transformations of decoded attributes, in place.

use std::f32::consts::FRAC_1_SQRT_2;

/// Applies the filter of that name; `None` if it is unknown or does not fit the stride.
pub(super) fn apply(name: &str, bytes: &mut [u8], stride: usize) -> Option<()> {
    match (name, stride) {
        ("NONE", _) => {}
        ("OCTAHEDRAL", 4) => signed_bytes(bytes, |v| octahedral(v, 127.0)),
        ("OCTAHEDRAL", 8) => signed_shorts(bytes, |v| octahedral(v, 32767.0)),
        ("QUATERNION", 8) => signed_shorts(bytes, quaternion),
        ("EXPONENTIAL", _) => {
            for bytes in bytes.as_chunks_mut().0 {
                *bytes = exponential(i32::from_le_bytes(*bytes)).to_le_bytes();
            }
        }
        // The difference between signed and unsigned is lost in the conversion back.
        ("COLOR", 4) => signed_bytes(bytes, |v| color(v, 255)),
        ("COLOR", 8) => signed_shorts(bytes, |v| color(v, 65535)),
        _ => return None,
    }
    Some(())
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the low bits are the value"
)]
fn signed_bytes(bytes: &mut [u8], filter: impl Fn([i32; 4]) -> [i32; 4]) {
    for element in bytes.as_chunks_mut::<4>().0 {
        *element = filter(element.map(|byte| byte.cast_signed().into())).map(|value| value as u8);
    }
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the low bits are the value"
)]
fn signed_shorts(bytes: &mut [u8], filter: impl Fn([i32; 4]) -> [i32; 4]) {
    for element in bytes.as_chunks_mut::<8>().0 {
        let value = |i: usize| i32::from(i16::from_le_bytes([element[i], element[i + 1]]));
        let [a, b, c, d] =
            filter([value(0), value(2), value(4), value(6)]).map(|value| (value as u16).to_le_bytes());
        *element = [a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]];
    }
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "16 bits"
)]
fn octahedral([x, y, one, rest]: [i32; 4], max: f32) -> [i32; 4] {
    let one = one as f32;
    let (mut x, mut y) = (x as f32 / one, y as f32 / one);
    let z = 1.0 - x.abs() - y.abs();
    // The lower hemisphere is folded over the corners.
    let fold = z.min(0.0);
    x -= fold.copysign(x);
    y -= fold.copysign(y);
    let length = (x * x + y * y + z * z).sqrt();
    let [x, y, z] = [x, y, z].map(|value| (value / length * max).round() as i32);
    [x, y, z, rest]
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "16 bits"
)]
fn quaternion([x, y, z, last]: [i32; 4]) -> [i32; 4] {
    let one = (last | 3) as f32;
    let [x, y, z] = [x, y, z].map(|value| value as f32 / one * FRAC_1_SQRT_2);
    let w = (1.0 - x * x - y * y - z * z).max(0.0).sqrt();
    let mut turned = [w, x, y, z].map(|value| (value * 32767.0).round() as i32);
    turned.rotate_right(usize::try_from(last & 3).unwrap_or(0));
    turned
}

fn exponential(value: i32) -> f32 {
    let (exponent, mantissa) = (value >> 24, (value << 8) >> 8);
    #[allow(clippy::cast_precision_loss, reason = "24 bits")]
    let mantissa = mantissa as f32;
    // Exponents are from −100 to 100 and the scale is therefore a normal number.
    let bits = (exponent.clamp(-100, 100) + 127).cast_unsigned() << 23;
    mantissa * f32::from_bits(bits)
}

#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "16 bits"
)]
fn color([luma, co, cg, alpha]: [i32; 4], max: i32) -> [i32; 4] {
    let (luma, alpha) = (luma & max, alpha & max);
    // The highest bit of alpha tells the number of bits.
    let scale = (1 << (32 - alpha.leading_zeros())) - 1;
    let alpha = alpha & (scale >> 1);
    let factor = max as f32 / (scale.max(1)) as f32;
    let expanded = (alpha << 1) | (alpha & 1);
    [luma + co - cg, luma + cg, luma - co - cg, expanded].map(|value| (value as f32 * factor).round() as i32)
}
