//! The radial factor of OpenCV's pinhole model, and its poles that a zero cancels.

use glam::DVec2;

use super::monotone::positive_on;

/// A pole and a zero that are closer together than this in r = √u cancel. Real factory calibrations have such pairs up to
/// 0.0018 apart, about a pixel and a half: the fit has put them between its measurements.
const CANCELS: f64 = 0.005;
/// A complex pair of poles that is farther from the axis of real r than this disturbs no ray, even if zeros are near.
const HARMLESS: f64 = 0.07;

/// A rational function of u = r², n(u) / d(u), with d(0) = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rational {
    /// The coefficients of the numerator in ascending powers of u.
    pub(super) n: [f64; 4],
    /// The coefficients of the denominator.
    pub(super) d: [f64; 4],
}

/// A rational function without its cancelled poles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Smooth {
    /// The function.
    pub(super) radial: Rational,
    /// The radii r of the poles in ascending order; infinite for those that do not exist.
    pub(super) poles: [f64; 3],
}

impl Rational {
    /// Returns the value at u and its derivative with respect to u.
    pub(super) fn at(&self, u: f64) -> (f64, f64) {
        let [(n, dn), (d, dd)] = [self.n, self.d].map(|[c0, c1, c2, c3]| {
            (
                c0 + u * (c1 + u * (c2 + u * c3)),
                c1 + u * (2.0 * c2 + u * 3.0 * c3),
            )
        });
        let value = n / d;
        (value, (dn - value * dd) / d)
    }

    /// Whether r times this factor increases, without a pole, from r = 0 to r² = `end`.
    pub(super) fn increases_to(&self, end: f64) -> bool {
        // d(r n/d)/dr = Σ nᵢ dⱼ (1 + 2i − 2j) u^(i+j) / d²
        let mut slope = [0.0; 7];
        for (i, ni) in (0u8..).zip(self.n) {
            for (j, dj) in (0u8..).zip(self.d) {
                slope[usize::from(i + j)] += ni * dj * (1.0 + 2.0 * (f64::from(i) - f64::from(j)));
            }
        }
        positive_on(&self.d, end) && positive_on(&slope, end)
    }

    /// Returns the function without the poles that a zero cancels, or `None` if it has none. Both functions are nearly equal
    /// but for the surroundings of the poles.
    pub(super) fn without_cancelled_poles(&self) -> Option<Smooth> {
        let (mut zeros, mut poles) = (roots(self.n)?, roots(self.d)?);
        let mut scale = 1.0;
        let mut cancelled = [f64::INFINITY; 3];
        for (pole, cancelled) in poles.iter_mut().zip(&mut cancelled) {
            let Some(r) = radius(*pole).filter(|r| r.y.abs() < HARMLESS) else {
                continue;
            };
            let distance = |zero: DVec2| radius(zero).map_or(f64::INFINITY, |other| r.distance(other));
            let zero = zeros
                .iter_mut()
                .min_by(|a, b| distance(**a).total_cmp(&distance(**b)))?;
            if distance(*zero) < CANCELS {
                // (1 − u/u₀) / (1 − u/u₁) tends to u₁/u₀ on both sides of the pair.
                scale *= zero.length() / pole.length();
                (*zero, *pole) = (DVec2::ZERO, DVec2::ZERO);
                *cancelled = r.x;
            }
        }
        cancelled.sort_by(f64::total_cmp);
        cancelled[0].is_finite().then_some(Smooth {
            radial: Self {
                n: from_roots(zeros)?.map(|c| c * scale),
                d: from_roots(poles)?,
            },
            poles: cancelled,
        })
    }
}

/// Solves `1 + c₁ u + c₂ u² + c₃ u³ = 0`. Returns 1/u for each root u, as a complex number, and 0 for each root that is missing because
/// the last coefficients are 0. Returns `None` if the coefficients are too large. The numbers v = 1/u are the roots of
/// v³ + c₁ v² + c₂ v + c₃, which Weierstrass's iteration finds.
fn roots([_, c1, c2, c3]: [f64; 4]) -> Option<[DVec2; 3]> {
    let bound = c1.abs().max(c2.abs().sqrt()).max(c3.abs().cbrt());
    if bound == 0.0 {
        return Some([DVec2::ZERO; 3]);
    }
    let polynomial = |v: DVec2| {
        let value = v + DVec2::new(c1, 0.0);
        let value = value.rotate(v) + DVec2::new(c2, 0.0);
        value.rotate(v) + DVec2::new(c3, 0.0)
    };
    // Three points that are symmetric to no axis.
    let mut v = [0.4, 2.5, 4.6].map(|angle: f64| bound * DVec2::from_angle(angle));
    for _ in 0..200 {
        let mut largest = 0.0_f64;
        for i in 0..3 {
            let apart = (v[i] - v[(i + 1) % 3]).rotate(v[i] - v[(i + 2) % 3]);
            let step = divide(polynomial(v[i]), apart);
            if step.is_finite() {
                v[i] -= step;
                largest = largest.max(step.length());
            }
        }
        if largest <= 1e-15 * bound {
            break;
        }
    }
    v.iter().all(|v| v.is_finite()).then_some(v)
}

/// Returns r = √(1/v) with a positive real part, or `None` if its square has none.
fn radius(v: DVec2) -> Option<DVec2> {
    (v.x > 0.0).then(|| DVec2::from_angle(-0.5 * v.to_angle()) / v.length().sqrt())
}

/// Returns the coefficients of Π (1 − vᵢ u), or `None` if they are not real.
fn from_roots(v: [DVec2; 3]) -> Option<[f64; 4]> {
    let mut product = [DVec2::X, DVec2::ZERO, DVec2::ZERO, DVec2::ZERO];
    for v in v {
        for i in (1..4).rev() {
            product[i] -= v.rotate(product[i - 1]);
        }
    }
    product
        .iter()
        .all(|c| c.y.abs() <= 1e-9 * (1.0 + c.x.abs()))
        .then(|| product.map(|c| c.x))
}

fn divide(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(b.x, -b.y).rotate(a) / b.length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(roots: &[f64]) -> [f64; 4] {
        let mut all = [DVec2::ZERO; 3];
        for (v, u) in all.iter_mut().zip(roots) {
            *v = DVec2::new(1.0 / u, 0.0);
        }
        from_roots(all).unwrap()
    }

    #[test]
    fn finds_roots() {
        let radii = |c| {
            let mut radii: Vec<f64> = roots(c)
                .unwrap()
                .into_iter()
                .filter_map(radius)
                .map(|r| r.x)
                .collect();
            radii.sort_by(f64::total_cmp);
            radii
        };
        assert!(radii([1.0, 0.0, 0.0, 0.0]).is_empty());
        // One of three real roots is negative.
        let found = radii(product(&[0.25, 4.0, -3.0]));
        assert!(
            (found[0] - 0.5).abs() < 1e-9 && (found[1] - 2.0).abs() < 1e-9 && found.len() == 2,
            "{found:?}"
        );
        // (1 + u + u²)(1 − 2 u)
        let found = radii([1.0, -1.0, -1.0, -2.0]);
        assert!(
            (found[0] - 0.5_f64.sqrt()).abs() < 1e-9 && found.len() == 1,
            "{found:?}"
        );
    }

    #[test]
    fn cancels_close_pairs_only() {
        let pair = |zero: f64, pole: f64| Rational {
            n: product(&[zero * zero, 9.0]),
            d: product(&[pole * pole, -2.0]),
        };
        let smooth = pair(0.8003, 0.8).without_cancelled_poles().unwrap();
        assert!((smooth.poles[0] - 0.8).abs() < 1e-9 && smooth.poles[1].is_infinite());
        for u in [0.0, 0.3, 1.2] {
            assert!((smooth.radial.at(u).0 / pair(0.8003, 0.8).at(u).0 - 1.0).abs() < 2e-3);
        }
        assert_eq!(pair(0.81, 0.8).without_cancelled_poles(), None);
        assert_eq!(pair(0.79, 0.8).without_cancelled_poles(), None);
    }

    #[test]
    fn cancels_two_pairs_and_complex_ones() {
        let two = Rational {
            n: product(&[0.4401, 0.5601]),
            d: product(&[0.44, 0.56]),
        };
        let smooth = two.without_cancelled_poles().unwrap();
        assert!((smooth.radial.at(0.5).0 - 1.0).abs() < 1e-3 && smooth.radial.increases_to(2.0));
        // (1 − v u)(1 − v̄ u) with v = 2 ± 0.01i, and a double zero beside it.
        let near = Rational {
            n: [1.0, -4.0, 4.0, 0.0],
            d: [1.0, -4.0, 4.0001, 0.0],
        };
        assert!(!near.increases_to(1.0));
        assert!(near.without_cancelled_poles().unwrap().radial.increases_to(1.0));
    }
}
