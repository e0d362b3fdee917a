/// Returns the median; the mean of the two middle values if their number is even, `None` without values. NaN is larger than
/// any number.
#[must_use]
pub fn median(values: &[f64]) -> Option<f64> {
    quantile(values, 0.5)
}

/// Returns the quantile of a share (0 to 1), interpolated linearly (`NumPy`'s `linear` method); `None` without values. NaN is
/// larger than any number.
#[must_use]
pub fn quantile(values: &[f64], share: f64) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let at = share.clamp(0.0, 1.0) * sorted.len().checked_sub(1)? as f64;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an index")]
    let low = at as usize;
    let (a, b) = (*sorted.get(low)?, *sorted.get(low + 1).or(sorted.last())?);
    let part = at - low as f64;
    Some(if part > 0.0 { a + (b - a) * part } else { a })
}

/// Returns the coefficient of determination, 1 − Σ(measured − modelled)² / Σ(measured − mean)²: 1 for a perfect model, 0 for
/// one that is as good as the mean, negative for a worse one. `None` for fewer than two pairs or without variation.
#[must_use]
pub fn r_squared(measured_and_modelled: &[[f64; 2]]) -> Option<f64> {
    let count = measured_and_modelled.len();
    if count < 2 {
        return None;
    }
    let mean = measured_and_modelled.iter().map(|[y, _]| y).sum::<f64>() / count as f64;
    let sum = |of: &dyn Fn(&[f64; 2]) -> f64| {
        measured_and_modelled
            .iter()
            .map(|pair| of(pair).powi(2))
            .sum::<f64>()
    };
    let total = sum(&|[y, _]| y - mean);
    let rest = sum(&|[y, model]| y - model);
    (total > 0.0 && rest.is_finite()).then(|| 1.0 - rest / total)
}

/// Returns the median and reorders the values.
pub(super) fn median_in_place(values: &mut [f32]) -> Option<f64> {
    let middle = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let is_even = values.len().is_multiple_of(2);
    let (below, upper, _) = values.select_nth_unstable_by(middle, f32::total_cmp);
    let upper = f64::from(*upper);
    if !is_even {
        return Some(upper);
    }
    let lower = below
        .iter()
        .copied()
        .max_by(f32::total_cmp)
        .map_or(upper, f64::from);
    Some(f64::midpoint(lower, upper))
}

/// Returns the standard deviation of a sample (over n − 1) of at least two values.
pub(super) fn standard_deviation(values: &[f64]) -> Option<f64> {
    let count = values.len();
    if count < 2 {
        return None;
    }
    let mean = values.iter().sum::<f64>() / count as f64;
    let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
    Some((squares / (count - 1) as f64).sqrt())
}

/// Returns the mean; `None` without values.
pub(super) fn mean(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values
        .into_iter()
        .fold((0.0, 0u32), |(sum, count), value| (sum + value, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn quantiles_lie_between_neighbours() {
        let values = [4.0, 1.0, 3.0, 2.0];
        assert_eq!(median(&values), Some(2.5));
        assert_eq!(quantile(&values, 0.25), Some(1.75));
        assert_eq!(quantile(&values, 1.0), Some(4.0));
        assert_eq!(quantile(&[], 0.5), None);
        assert_eq!(median(&[f64::INFINITY]), Some(f64::INFINITY));
        assert_eq!(median(&[1.0, f64::NAN, 2.0]), Some(2.0));
    }

    #[test]
    fn r_squared_matches_the_closed_form() {
        assert_eq!(r_squared(&[[1.0, 1.0], [2.0, 2.0]]), Some(1.0));
        assert_eq!(r_squared(&[[1.0, 2.0], [3.0, 2.0]]), Some(0.0));
        assert_eq!(r_squared(&[[1.0, 3.0], [3.0, 1.0]]), Some(-3.0));
        assert_eq!(r_squared(&[[1.0, 1.0]]), None);
        assert_eq!(r_squared(&[[1.0, 1.0], [1.0, 2.0]]), None);
        assert_eq!(r_squared(&[[1.0, f64::NAN], [2.0, 2.0]]), None);
    }

    #[test]
    fn deviations_match_the_closed_form() {
        assert_eq!(standard_deviation(&[1.0, 3.0]), Some(2f64.sqrt()));
        assert_eq!(standard_deviation(&[5.0]), None);
    }

    proptest! {
        #[test]
        fn both_medians_agree(mut values in proptest::collection::vec(-1e3f32..1e3, 0..40)) {
            let wide: Vec<f64> = values.iter().copied().map(f64::from).collect();
            let expected = median(&wide);
            let actual = median_in_place(&mut values);
            match (expected, actual) {
                (Some(a), Some(b)) => prop_assert!((a - b).abs() < 1e-9),
                (a, b) => prop_assert_eq!(a, b),
            }
        }
    }
}
