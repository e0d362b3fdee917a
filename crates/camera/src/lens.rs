/// How a lens bends the ideal pinhole's rays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum LensModel {
    /// No distortion.
    #[default]
    Pinhole,
    /// OpenCV's rational, thin-prism and tilt model.
    OpenCvPinhole(OpenCvPinhole),
    /// OpenCV's fisheye model (equidistant with four odd terms).
    OpenCvFisheye(OpenCvFisheye),
}

/// The 14 coefficients of OpenCV's pinhole distortion in its order:
/// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy. Absent ones are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenCvPinhole {
    /// In OpenCV's order.
    pub coefficients: [f64; 14],
}

/// The 4 coefficients of OpenCV's fisheye model, `θd = θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenCvFisheye {
    /// k1 to k4.
    pub k: [f64; 4],
}
