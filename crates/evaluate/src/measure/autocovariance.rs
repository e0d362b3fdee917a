/// The autocovariance of images along rows and columns, accumulated image by image.
///
/// The values are deviations with mean 0; NaN is invalid.
#[derive(Clone, Debug, PartialEq)]
pub struct Autocovariance {
    products: Vec<f64>,
    counts: Vec<u64>,
}

impl Autocovariance {
    /// Creates an empty autocovariance for lags of 0 to `lags − 1` px.
    #[must_use]
    pub fn new(lags: usize) -> Self {
        Self {
            products: vec![0.0; lags],
            counts: vec![0; lags],
        }
    }

    /// Adds an image whose rows are `width` px wide.
    pub fn add(&mut self, values: &[f32], width: usize) {
        let width = width.max(1);
        for (lag, (product, count)) in self.products.iter_mut().zip(&mut self.counts).enumerate() {
            let mut add = |a: &[f32], b: &[f32]| {
                let (mut sum, mut pairs) = (0.0f64, 0u64);
                for (&a, &b) in a.iter().zip(b) {
                    let both = f64::from(a) * f64::from(b);
                    if both.is_finite() {
                        sum += both;
                        pairs += 1;
                    }
                }
                *product += sum;
                *count += pairs;
            };
            for row in values.chunks_exact(width) {
                add(row, row.get(lag..).unwrap_or_default());
            }
            if lag > 0 {
                add(values, values.get(lag * width..).unwrap_or_default());
            }
        }
    }

    /// Adds another autocovariance with the same number of lags.
    pub fn merge(&mut self, other: &Self) {
        for (sum, more) in self.products.iter_mut().zip(&other.products) {
            *sum += more;
        }
        for (sum, more) in self.counts.iter_mut().zip(&other.counts) {
            *sum += more;
        }
    }

    /// Returns the covariance at a lag in pixels; `None` without pairs of values.
    #[must_use]
    pub fn at(&self, lag: usize) -> Option<f64> {
        let count = *self.counts.get(lag)?;
        (count > 0).then(|| self.products.get(lag).copied().unwrap_or_default() / count as f64)
    }

    /// Returns the number of values.
    #[must_use]
    pub fn values(&self) -> u64 {
        self.counts.first().copied().unwrap_or_default()
    }

    /// Returns the number of lags.
    #[must_use]
    pub fn lags(&self) -> usize {
        self.products.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn averages_products_along_rows_and_columns() {
        let mut sums = Autocovariance::new(3);
        sums.add(&[1.0, 2.0, f32::NAN, 4.0, 5.0, 6.0], 3);
        // 1 4 25 36 16; 1·2 4·5 5·6 and 1·4 2·5; 4·6.
        assert_eq!(sums.values(), 5);
        assert_eq!(sums.at(0), Some(82.0 / 5.0));
        assert_eq!(sums.at(1), Some((2.0 + 20.0 + 30.0 + 4.0 + 10.0) / 5.0));
        assert_eq!(sums.at(2), Some(24.0));
        assert_eq!(sums.at(3), None);
        let mut twice = sums.clone();
        twice.merge(&sums);
        assert_eq!((twice.at(1), twice.values()), (sums.at(1), 10));
        assert_eq!(Autocovariance::new(2).at(0), None);
    }
}
