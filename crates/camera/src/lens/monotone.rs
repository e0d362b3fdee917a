//! Positivity of polynomials, and the inverse of functions that increase on an interval.

/// Whether `c[0] + c[1] u + c[2] u² + …` is positive on all of [0, end].
///
/// Bernstein coefficients enclose the polynomial; the interval is halved until they decide. At a double root they never do:
/// it counts as not positive.
pub(super) fn positive_on<const N: usize>(c: &[f64; N], end: f64) -> bool {
    let mut bernstein = *c;
    let (mut power, mut binomial) = (1.0, 1.0);
    for (i, (b, left)) in bernstein.iter_mut().zip((0..N).rev()).enumerate() {
        *b *= power / binomial;
        power *= end;
        #[expect(clippy::cast_precision_loss, reason = "degrees of at most 6")]
        let (taken, left) = ((i + 1) as f64, left as f64);
        binomial *= left / taken;
    }
    for pass in 1..N {
        for j in (pass..N).rev() {
            bernstein[j] += bernstein[j - 1];
        }
    }
    positive(bernstein, 40)
}

fn positive<const N: usize>(mut bernstein: [f64; N], halvings: u32) -> bool {
    // In this form, NaN is not positive.
    if !(bernstein[0] > 0.0 && bernstein[N - 1] > 0.0) {
        return false;
    }
    if bernstein.iter().all(|&b| b > 0.0) {
        return true;
    }
    if halvings == 0 {
        return false;
    }
    // De Casteljau's algorithm at the middle: the left half is collected, the right half remains in place.
    let mut left = [0.0; N];
    for (pass, first) in left.iter_mut().enumerate() {
        *first = bernstein[0];
        for j in 1..N - pass {
            bernstein[j - 1] = f64::midpoint(bernstein[j - 1], bernstein[j]);
        }
    }
    positive(left, halvings - 1) && positive(bernstein, halvings - 1)
}

/// Returns the x in [0, max] with f(x) = target, or `None` if f does not reach the target. `f` returns its value and
/// derivative, and increases as long as `holds` is true: on [0, edge] for some edge.
pub(super) fn inverse(
    f: impl Fn(f64) -> (f64, f64),
    holds: impl Fn(f64) -> bool,
    target: f64,
    start: f64,
    max: f64,
) -> Option<f64> {
    let found = |x: f64| (0.0..=max).contains(&x) && agrees(f(x).0, target) && holds(x);

    let mut x = start.clamp(0.0, max);
    for _ in 0..20 {
        let (value, slope) = f(x);
        let step = (value - target) / slope;
        x -= step;
        if !step.is_finite() || step.abs() <= 1e-14 * x.abs() {
            break;
        }
    }
    if found(x) {
        return Some(x);
    }

    // Newton's method diverged: bracket the target from 0 up to the edge, and bisect.
    if !holds(0.0) || f(0.0).0 > target {
        return None;
    }
    let (mut low, mut high) = (0.0, start.clamp(f64::MIN_POSITIVE, max));
    loop {
        if !holds(high) {
            let (mut inside, mut outside) = (low, high);
            while let Some(middle) = between(inside, outside) {
                *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
            }
            high = inside;
            if f(high).0 < target {
                return found(high).then_some(high);
            }
            break;
        }
        if f(high).0 >= target {
            break;
        }
        if high >= max {
            return None;
        }
        low = high;
        high = (2.0 * high).min(max);
    }
    while let Some(middle) = between(low, high) {
        *(if f(middle).0 < target { &mut low } else { &mut high }) = middle;
    }
    [low, high].into_iter().find(|&x| found(x))
}

/// Whether two values are equal up to the rounding error of a polynomial whose terms nearly cancel.
pub(super) fn agrees(value: f64, target: f64) -> bool {
    (value - target).abs() <= 1e-12 * (1.0 + target.abs())
}

fn between(low: f64, high: f64) -> Option<f64> {
    let middle = f64::midpoint(low, high);
    (low < middle && middle < high).then_some(middle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn is_positive_up_to_the_first_root() {
        // (u − 1)(u − 2) = 2 − 3u + u²
        assert!(positive_on(&[2.0, -3.0, 1.0], 0.999));
        assert!(!positive_on(&[2.0, -3.0, 1.0], 1.001));
        assert!(!positive_on(&[2.0, -3.0, 1.0], 3.0));
        // (u − 1)² + 1e-6 has no root, (u − 1)² has one.
        assert!(positive_on(&[1.0 + 1e-6, -2.0, 1.0], 5.0));
        assert!(!positive_on(&[1.0, -2.0, 1.0], 5.0));
        assert!(!positive_on(&[1.0, f64::NAN, 1.0], 5.0));
        assert!(!positive_on(&[1.0, -1.0], f64::INFINITY));
    }

    #[test]
    fn has_no_inverse_beyond_the_edge() {
        // x − x³/3 increases up to 1, where it is 2/3.
        let f = |x: f64| (x - x.powi(3) / 3.0, 1.0 - x * x);
        let holds = |x: f64| positive_on(&[1.0, 0.0, -1.0], x);
        let of = |target| inverse(f, holds, target, target, 10.0);
        assert!(agrees(f(of(0.66).unwrap()).0, 0.66));
        assert!(of(0.66).unwrap() < 1.0);
        assert_eq!(of(0.67), None);
        assert_eq!(of(5.0), None);
        assert_eq!(of(-0.1), None);
        assert_eq!(of(f64::NAN), None);
    }

    proptest! {
        #[test]
        fn positive_agrees_with_sampling(c in prop::array::uniform4(-10.0..10.0f64), end in 0.01..3.0f64) {
            let c = [1.0, c[0], c[1], c[2], c[3]];
            let min = (0..=2000)
                .map(|i| { let u = end * f64::from(i) / 2000.0; c.iter().rev().fold(0.0, |sum, k| sum * u + k) })
                .fold(f64::INFINITY, f64::min);
            prop_assume!(min.abs() > 1e-3);
            prop_assert_eq!(positive_on(&c, end), min > 0.0);
        }
    }
}
