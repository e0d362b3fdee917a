/// Cosine and sine of `part / whole` of a full turn, computed identically on every machine, and exactly
/// symmetric: eighths of a turn are mirror images of each other.
pub(crate) fn cos_sin(part: u32, whole: u32) -> (f64, f64) {
    let (part, whole) = (u64::from(part % whole.max(1)), u64::from(whole.max(1)));
    let quarter = 4 * part / whole;
    // The remainder in units of 1 / (4 · whole) of a turn, less than `whole`.
    let rest = 4 * part - quarter * whole;
    let (cosine, sine) = if 2 * rest <= whole {
        first_eighth(rest, whole)
    } else {
        let (cosine, sine) = first_eighth(whole - rest, whole);
        (sine, cosine)
    };
    match quarter {
        0 => (cosine, sine),
        1 => (-sine, cosine),
        2 => (-cosine, -sine),
        _ => (sine, -cosine),
    }
}

/// Cosine and sine of `rest / whole` of a quarter turn, at most an eighth of a full turn.
#[allow(clippy::cast_precision_loss, reason = "below 2³⁴")]
fn first_eighth(rest: u64, whole: u64) -> (f64, f64) {
    let angle = std::f64::consts::FRAC_PI_2 * (rest as f64 / whole as f64);
    let square = angle * angle;
    // Taylor series; the first omitted term is below 1e-17 at an eighth of a turn.
    let series = |last: u32| {
        let mut sum = 1.0;
        let mut n = last;
        while n >= 2 {
            sum = 1.0 - square / f64::from(n * (n - 1)) * sum;
            n -= 2;
        }
        sum
    };
    (series(16), angle * series(17))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_standard_library() {
        for whole in [1, 2, 3, 5, 8, 12, 64, 1000] {
            for part in 0..whole + 2 {
                let angle = std::f64::consts::TAU * f64::from(part) / f64::from(whole);
                let (cosine, sine) = cos_sin(part, whole);
                assert!((cosine - angle.cos()).abs() < 1e-14, "{part}/{whole}");
                assert!((sine - angle.sin()).abs() < 1e-14, "{part}/{whole}");
            }
        }
    }

    #[test]
    fn quarters_are_exact_and_mirrored() {
        assert_eq!(cos_sin(16, 64), (0.0, 1.0));
        assert_eq!(cos_sin(32, 64), (-1.0, 0.0));
        let (cosine, sine) = cos_sin(3, 64);
        assert_eq!(cos_sin(13, 64), (sine, cosine));
        assert_eq!(cos_sin(61, 64), (cosine, -sine));
    }
}
