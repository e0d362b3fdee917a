/// Round numbers within a range, about as many as wanted, at least two apart of which the range allows two.
pub(super) fn ticks([low, high]: [f64; 2], wanted: u32) -> Vec<f64> {
    let rough = (high - low) / f64::from(wanted.max(1));
    if !(rough.is_finite() && rough > 0.0) {
        return Vec::new();
    }
    let power = 10f64.powi(rounded_down(rough.log10()));
    let step = [1.0, 2.0, 5.0, 10.0]
        .map(|multiple| multiple * power)
        .into_iter()
        .find(|step| *step >= rough * 0.999)
        .unwrap_or(power);
    let first = (low / step - 1e-9).ceil();
    // No more than a few: the step is about the range over their number.
    (0..4 * wanted.max(1))
        .map(|i| (first + f64::from(i)) * step)
        .take_while(|tick| *tick <= high + step * 1e-9)
        .collect()
}

fn rounded_down(value: f64) -> i32 {
    #[expect(clippy::cast_possible_truncation, reason = "a decimal exponent")]
    let floor = value.floor() as i32;
    floor
}

/// A tick's number without trailing zeros.
pub(super) fn label(tick: f64) -> String {
    let text = format!("{tick:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(range: [f64; 2]) -> Vec<String> {
        ticks(range, 6).into_iter().map(label).collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels([0.0, 10.5]), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(labels([0.2, 1.3]), ["0.2", "0.4", "0.6", "0.8", "1", "1.2"]);
        assert_eq!(labels([-3.0, 6.9]), ["-2", "0", "2", "4", "6"]);
        assert_eq!(labels([0.0, 219.0]), ["0", "50", "100", "150", "200"]);
        assert_eq!(
            labels([-0.001, 0.004]),
            ["-0.001", "0", "0.001", "0.002", "0.003", "0.004"]
        );
    }

    #[test]
    fn ranges_that_are_none_have_no_ticks() {
        for range in [[1.0, 1.0], [2.0, 1.0], [0.0, f64::NAN], [0.0, f64::INFINITY]] {
            assert!(ticks(range, 6).is_empty());
        }
        assert!(ticks([1e300, 1.000001e300], 6).len() < 25);
    }
}
