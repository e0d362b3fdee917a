//! Conversion from pixels of an image to matcher pixels.

/// Returns the odd side in matcher pixels of a window in an image, where `image_px` pixels are one matcher pixel.
pub(super) fn matcher_window(side: usize, image_px: f64) -> f64 {
    let sides = (0..32u32).map(|i| f64::from(2 * i + 1));
    let width = side as f64;
    let exact = |matcher: f64| (matcher * image_px).round().max(1.0) - width;
    sides
        .min_by(|a, b| {
            let off = |matcher: f64| (exact(matcher).abs(), (matcher * image_px - width).abs());
            let ((a0, a1), (b0, b1)) = (off(*a), off(*b));
            a0.total_cmp(&b0).then(a1.total_cmp(&b1))
        })
        .unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_in_matcher_pixels() {
        assert_eq!(matcher_window(7, 1.0), 7.0);
        assert_eq!(matcher_window(4, 0.5), 7.0);
        assert_eq!(matcher_window(1, 0.1), 9.0);
        assert_eq!(matcher_window(6, 1.0), 5.0);
        assert_eq!(matcher_window(500, 1.0), 63.0);
    }
}
