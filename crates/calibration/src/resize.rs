use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint};

/// The intrinsics for an image of another size by `DepthAI`'s rule: scaled to cover the new image and cropped about
/// its centre; but a wide calibration (up to 16:9) that a 4:3 or narrower image is asked of is scaled to fit and extended
/// above and below, since the sensor reads more rows than the wide image shows. Without `keep_aspect` each axis is
/// scaled by itself. (`CalibrationHandler::getCameraIntrinsics`.)
pub(crate) fn resized(k: &Intrinsics, size: ImageSize, keep_aspect: bool) -> Intrinsics {
    let (w0, h0) = (f64::from(k.size.width), f64::from(k.size.height));
    let (w, h) = (f64::from(size.width), f64::from(size.height));
    let c = k.principal_point::<OpenCv>();
    let (sx, sy) = if !keep_aspect {
        (w / w0, h / h0)
    } else if w / h <= 1.34 && w0 / h0 <= 1.778 && w0 / h0 > 1.5 {
        let s = (w / w0).min(h / h0);
        (s, s)
    } else {
        let s = (w / w0).max(h / h0);
        (s, s)
    };
    // What the scaled image lacks or has too much is shared by both sides.
    let (dx, dy) = if keep_aspect {
        ((w - w0 * sx) / 2.0, (h - h0 * sy) / 2.0)
    } else {
        (0.0, 0.0)
    };
    Intrinsics::new(
        size,
        k.fx * sx,
        k.fy * sy,
        PixelPoint::<OpenCv>::new(c.x * sx + dx, c.y * sy + dy),
    )
}

impl crate::CameraCalibration {
    /// The intrinsics for an image of another size, by `DepthAI`'s rule: scaled to cover it and cropped about the
    /// centre, or, where a 4:3 or narrower image is asked of a wide calibration, scaled to fit and extended. Without
    /// `keep_aspect` each axis is scaled by itself.
    #[must_use]
    pub fn intrinsics_at(&self, size: ImageSize, keep_aspect: bool) -> Intrinsics {
        resized(&self.intrinsics, size, keep_aspect)
    }
}
