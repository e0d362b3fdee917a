//! Formats numbers as OpenUSD does: the shortest digits that parse back to the same value, `1` for 1.0, decimals
//! from 1e-6 up to 1e15 and exponents (`1e15`, `1e-7`) beyond.

use zmij::{Buffer, Float};

/// Appends an integer.
pub(super) fn push_i32(out: &mut String, value: i32) {
    out.push_str(itoa::Buffer::new().format(value));
}

/// Appends a 32-bit number with the shortest digits that identify it among `f32` values.
pub(super) fn push_f32(out: &mut String, value: f32) {
    if push_millionths(out, value) {
        return;
    }
    if value.is_finite() {
        push_finite(out, value);
    } else {
        push_special(out, value.is_nan(), value > 0.0);
    }
}

/// Appends a 64-bit number.
pub(super) fn push_f64(out: &mut String, value: f64) {
    if value.is_finite() {
        push_finite(out, value);
    } else {
        push_special(out, value.is_nan(), value > 0.0);
    }
}

/// Appends a number if it is the nearest to a multiple of 1e-6 between -1 and 1, or a small integer, as the coordinates of
/// meshes are. Returns whether it is.
fn push_millionths(out: &mut String, value: f32) -> bool {
    const ONE: f64 = 1e6;
    let scaled = f64::from(value) * ONE;
    #[expect(clippy::cast_possible_truncation, reason = "saturates")]
    let rounded = (scaled + 0.5f64.copysign(scaled)) as i32;
    if rounded == 0 || rounded.unsigned_abs() >= 1_000_000 {
        return push_small_integer(out, value);
    }
    // Six digits identify a number, so the shortest text has no others.
    #[expect(clippy::cast_possible_truncation, reason = "compared with the value")]
    if (f64::from(rounded) / ONE) as f32 != value {
        return false;
    }
    let mut text = *b"-0.000000";
    let digits = rounded.unsigned_abs();
    #[expect(clippy::cast_possible_truncation, reason = "two digits")]
    for (place, pair) in [(3, digits / 10_000), (5, digits / 100 % 100), (7, digits % 100)] {
        text[place] += (pair / 10) as u8;
        text[place + 1] += (pair % 10) as u8;
    }
    let first = usize::from(rounded > 0);
    let last = text.iter().rposition(|digit| *digit != b'0').unwrap_or(0);
    out.push_str(str::from_utf8(&text[first..=last]).unwrap_or_default());
    true
}

/// Appends an integer of up to six digits other than -0. Returns whether the number is one.
fn push_small_integer(out: &mut String, value: f32) -> bool {
    #[expect(clippy::cast_possible_truncation, reason = "saturates")]
    let whole = value as i32;
    #[expect(clippy::cast_precision_loss, reason = "six digits")]
    let is_integer = whole.unsigned_abs() < 1_000_000 && (whole as f32).to_bits() == value.to_bits();
    if is_integer {
        push_i32(out, whole);
    }
    is_integer
}

fn push_special(out: &mut String, is_nan: bool, positive: bool) {
    out.push_str(match (is_nan, positive) {
        (true, _) => "nan",
        (false, true) => "inf",
        (false, false) => "-inf",
    });
}

/// The decimal exponents that OpenUSD (through double-conversion) writes in plain notation.
const PLAIN_EXPONENTS: std::ops::Range<i32> = -6..15;

fn push_finite<F: Float>(out: &mut String, value: F) {
    let mut buffer = Buffer::new();
    let text = buffer.format_finite(value);
    let (sign, text) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
    out.push_str(sign);

    let (mantissa, power) = text.split_once('e').unwrap_or((text, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let fraction = fraction.trim_end_matches('0');
    // The value is d.ddd · 10^exponent.
    let exponent = power
        + if whole == "0" {
            length(fraction.trim_start_matches('0')) - length(fraction) - 1
        } else {
            length(whole) - 1
        };
    if power == 0 && PLAIN_EXPONENTS.contains(&exponent) {
        out.push_str(whole);
        if !fraction.is_empty() {
            out.push('.');
            out.push_str(fraction);
        }
        return;
    }
    // The formatter and OpenUSD switch notation at different exponents, so the digits are laid out again.
    let digits = [whole, fraction].concat();
    let digits = digits.trim_matches('0');
    if PLAIN_EXPONENTS.contains(&exponent) {
        push_plain(out, digits, exponent);
    } else {
        let (first, rest) = digits.split_at(1.min(digits.len()));
        out.push_str(first);
        if !rest.is_empty() {
            out.push('.');
            out.push_str(rest);
        }
        out.push('e');
        out.push_str(&exponent.to_string());
    }
}

fn push_plain(out: &mut String, digits: &str, exponent: i32) {
    let Ok(shift) = usize::try_from(exponent) else {
        out.push_str("0.");
        out.extend(std::iter::repeat_n('0', (-1 - exponent).unsigned_abs() as usize));
        out.push_str(digits);
        return;
    };
    let whole = shift + 1;
    if digits.len() <= whole {
        out.push_str(digits);
        out.extend(std::iter::repeat_n('0', whole - digits.len()));
    } else {
        out.push_str(&digits[..whole]);
        out.push('.');
        out.push_str(&digits[whole..]);
    }
}

fn length(text: &str) -> i32 {
    i32::try_from(text.len()).unwrap_or(i32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn f32_text(value: f32) -> String {
        let mut out = String::new();
        push_f32(&mut out, value);
        out
    }

    fn f64_text(value: f64) -> String {
        let mut out = String::new();
        push_f64(&mut out, value);
        out
    }

    /// Expected texts come from `Sdf.Layer.ExportToString()` of usd-core 24.5.
    #[test]
    fn matches_openusd() {
        for (value, text) in [
            (1e-5, "0.00001"),
            (1e-6, "0.000001"),
            (1e-7, "1e-7"),
            (1.5e-7, "1.5e-7"),
            (123_456_789.0, "123456789"),
            (1e14, "100000000000000"),
            (1e15, "1e15"),
            (1e22, "1e22"),
            (0.1, "0.1"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::NAN, "nan"),
            (-0.0, "-0"),
            (0.0, "0"),
            (3.402_823_5e38, "3.4028235e38"),
            (-1_234_567.8, "-1234567.8"),
            (10_000_000.0, "10000000"),
            (123_456_789_012.5, "123456789012.5"),
        ] {
            assert_eq!(f64_text(value), text);
        }
        for (value, text) in [
            (123_456_789.0, "123456790"),
            (4.762_592, "4.762592"),
            (1e20, "1e20"),
            (16_777_216.0, "16777216"),
            (1e15, "1e15"),
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (-0.999_999, "-0.999999"),
            (0.000_001, "0.000001"),
            (f32::MIN_POSITIVE, "1.1754944e-38"),
        ] {
            assert_eq!(f32_text(value), text);
        }
    }

    #[test]
    fn every_millionth_has_its_shortest_text() {
        for millionths in (-1_000_100..1_000_100).step_by(7).chain(-3000..3000) {
            #[expect(clippy::cast_possible_truncation, reason = "the nearest f32")]
            let value = (f64::from(millionths) / 1e6) as f32;
            for value in [value, value.next_up(), value.next_down()] {
                let mut general = String::new();
                push_finite(&mut general, value);
                assert_eq!(f32_text(value), general);
            }
        }
    }

    proptest! {
        #[test]
        fn round_trips_to_the_same_bits(bits in any::<u64>(), narrow in any::<u32>(), scale in -20i32..20, mantissa in -1e6..1e6f64) {
            let shorter = mantissa * 10f64.powi(scale);
            for value in [f64::from_bits(bits), shorter] {
                if value.is_finite() {
                    prop_assert_eq!(f64_text(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
                }
            }
            #[expect(clippy::cast_possible_truncation, reason = "any f32 is a valid test value")]
            for value in [f32::from_bits(narrow), shorter as f32] {
                if value.is_finite() {
                    prop_assert_eq!(f32_text(value).parse::<f32>().unwrap().to_bits(), value.to_bits());
                }
            }
        }

        #[test]
        fn uses_exponents_in_the_same_range_as_openusd(digit in 1u32..10, exponent in -30i32..30) {
            let text = f64_text(format!("{digit}e{exponent}").parse().unwrap());
            prop_assert_eq!(text.contains('e'), !(-6..15).contains(&exponent), "{}", text);
        }
    }
}
