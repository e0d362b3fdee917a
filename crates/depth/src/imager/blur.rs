//! The blur of a lens.

use oaktwin_image::ImageView;

/// The largest standard deviation, px.
pub(super) const MAX_SIGMA_PX: f64 = 8.0;

/// The share of the central weight below which weights are dropped.
const LEAST: f64 = 1e-4;

/// A separable point spread function, the same along rows and columns.
#[derive(Clone, Debug)]
pub(super) struct Blur {
    /// The weights from the centre outwards; both sides together sum to 1.
    weights: Vec<f32>,
}

impl Blur {
    /// Returns the discrete normal distribution, which has exactly this standard deviation: its weights are the modified
    /// Bessel functions `I_n(σ²)` (Lindeberg, "Scale-space for discrete signals", 1990).
    #[expect(clippy::cast_possible_truncation, reason = "single precision")]
    pub(super) fn new(sigma_px: f64) -> Self {
        let half = sigma_px * sigma_px / 2.0;
        let mut weights = vec![bessel(0, half)];
        loop {
            let next = bessel(weights.len(), half);
            if next < LEAST * weights[0] {
                break;
            }
            weights.push(next);
        }
        let all = 2.0 * weights.iter().sum::<f64>() - weights[0];
        Self {
            weights: weights.iter().map(|weight| (weight / all) as f32).collect(),
        }
    }

    /// Whether it changes the image.
    pub(super) fn is_on(&self) -> bool {
        self.weights.len() > 1
    }

    /// The radius, px.
    pub(super) fn reach(&self) -> usize {
        self.weights.len() - 1
    }

    /// Returns a row of an image as the lens shows it: in `blurred`, or the image's own without blur. `padded` is as for [`Blur::row`].
    #[inline(always)]
    pub(super) fn shown<'a>(
        &self,
        light: ImageView<'a, f32>,
        y: usize,
        padded: &mut [f32],
        blurred: &'a mut [f32],
    ) -> &'a [f32] {
        if self.is_on() {
            self.row(light, y, padded, blurred);
            blurred
        } else {
            light.row(y).unwrap_or_default()
        }
    }

    /// Computes one row of a blurred image, whose border is repeated outside. `padded` is a buffer of the row's length plus
    /// twice the radius.
    #[inline(always)]
    pub(super) fn row(&self, light: ImageView<'_, f32>, y: usize, padded: &mut [f32], out: &mut [f32]) {
        let (width, reach) = (out.len(), self.reach());
        let last = (light.height() as usize).saturating_sub(1);
        let source = |y: usize| light.row(y.min(last)).unwrap_or_default();
        let Some((first, others)) = self.weights.split_first() else {
            return;
        };
        let Some(inner) = padded.get_mut(reach..reach + width) else {
            return;
        };
        for (sum, &light) in inner.iter_mut().zip(source(y)) {
            *sum = lit(light) * first;
        }
        for (weight, i) in others.iter().zip(1..) {
            let (above, below) = (source(y.saturating_sub(i)), source(y + i));
            for ((sum, &above), &below) in inner.iter_mut().zip(above).zip(below) {
                *sum += (lit(above) + lit(below)) * weight;
            }
        }
        let (left, right) = (inner[0], inner[width - 1]);
        padded[..reach].fill(left);
        padded[reach + width..].fill(right);
        for (out, &light) in out.iter_mut().zip(&padded[reach..]) {
            *out = light * first;
        }
        for (weight, i) in others.iter().zip(1..) {
            let (left, right) = (&padded[reach - i..], &padded[reach + i..]);
            for ((out, &left), &right) in out.iter_mut().zip(left).zip(right) {
                *out += (left + right) * weight;
            }
        }
    }
}

/// Invalid light is dark.
#[inline(always)]
fn lit(light: f32) -> f32 {
    if light > 0.0 { light } else { 0.0 }
}

/// `I_n(2h)`: the sum over k of h^(n + 2k) / (k! (n + k)!).
#[expect(clippy::cast_precision_loss, reason = "a few hundred")]
fn bessel(n: usize, half: f64) -> f64 {
    let mut term: f64 = (1..=n).map(|i| half / i as f64).product();
    let mut sum = term;
    let mut k = 1;
    while term > 1e-17 * sum {
        term *= half * half / (k as f64 * (n + k) as f64);
        sum += term;
        k += 1;
    }
    sum
}

#[cfg(test)]
mod tests {
    use oaktwin_image::Image;

    use super::*;

    fn blurred(sigma_px: f64, light: &Image<f32>) -> Image<f32> {
        let blur = Blur::new(sigma_px);
        let width = light.width() as usize;
        let mut padded = vec![f32::NAN; width + 2 * blur.reach()];
        let mut out = Image::filled(light.width(), light.height(), f32::NAN);
        for (y, row) in out.pixels_mut().chunks_exact_mut(width).enumerate() {
            blur.row(light.into(), y, &mut padded, row);
        }
        out
    }

    /// A point becomes a spot with all its light and the requested variance along both axes.
    #[test]
    fn blurs_a_point_with_the_requested_variance() {
        for sigma in [0.2, 0.6, 1.5, MAX_SIGMA_PX] {
            let mut light = Image::filled(141, 133, 0.0);
            light.pixels_mut()[66 * 141 + 70] = 900.0;
            let spot = blurred(sigma, &light);
            let moment = |power: i32, axis: usize| -> f64 {
                let at = |i: usize| [(i % 141) as f64 - 70.0, (i / 141) as f64 - 66.0][axis];
                let pixels = spot.pixels().iter().enumerate();
                pixels
                    .map(|(i, &v)| f64::from(v) / 900.0 * at(i).powi(power))
                    .sum()
            };
            assert!((moment(0, 0) - 1.0).abs() < 1e-6, "{sigma}: {}", moment(0, 0));
            for axis in [0, 1] {
                let variance = moment(2, axis) / (sigma * sigma);
                assert!(
                    moment(1, axis).abs() < 1e-4 && (variance - 1.0).abs() < 0.01,
                    "{sigma}: {variance}"
                );
            }
        }
    }

    #[test]
    fn keeps_uniform_images_up_to_the_borders() {
        for (width, height) in [(1, 1), (3, 2), (40, 1)] {
            let even = blurred(1.2, &Image::filled(width, height, 0.25));
            assert!(even.pixels().iter().all(|v| (v - 0.25).abs() < 1e-6));
        }
        let off = Blur::new(0.0);
        assert!(!off.is_on() && off.reach() == 0);
    }
}
