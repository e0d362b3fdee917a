use super::{LensError, LensModel, OpenCvFisheye, OpenCvPinhole, padded};

/// The names of a lens model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LensNames {
    /// The name in options and in Python.
    pub option: &'static str,
    /// The name in reports.
    pub report: &'static str,
    /// The token of NVIDIA's lens distortion schemas for USD.
    pub schema: &'static str,
    /// `cameraModel` of Replicator's `camera_params`.
    pub replicator: &'static str,
}

impl LensNames {
    pub(super) const PINHOLE: Self = Self {
        option: "pinhole",
        report: "pinhole",
        schema: "pinhole",
        replicator: "pinhole",
    };
    pub(super) const OPENCV_PINHOLE: Self = Self {
        option: "opencv",
        report: "opencv-pinhole",
        schema: "opencvPinhole",
        replicator: "pinholeOpenCV",
    };
    pub(super) const OPENCV_FISHEYE: Self = Self {
        option: "fisheye",
        report: "opencv-fisheye",
        schema: "opencvFisheye",
        replicator: "fisheyeOpenCV",
    };
    pub(super) const F_THETA: Self = Self {
        option: "f-theta",
        report: "f-theta",
        schema: "ftheta",
        replicator: "fisheyePolynomial",
    };
}

/// A lens model whose coefficients describe a lens completely.
#[derive(Clone, Copy, Debug)]
pub struct LensFamily {
    /// The name in options and in Python.
    pub name: &'static str,
    /// Creates the lens from up to as many coefficients as the model has; missing ones are 0.
    pub from_coefficients: fn(&[f64]) -> Result<LensModel, LensError>,
}

impl LensFamily {
    /// All families.
    pub const ALL: &[Self] = &[
        Self {
            name: LensNames::PINHOLE.option,
            from_coefficients: |k| padded::<0>("a pinhole", k).map(|_| LensModel::Pinhole),
        },
        Self {
            name: LensNames::OPENCV_PINHOLE.option,
            from_coefficients: |k| OpenCvPinhole::from_slice(k).map(LensModel::OpenCvPinhole),
        },
        Self {
            name: LensNames::OPENCV_FISHEYE.option,
            from_coefficients: |k| OpenCvFisheye::from_slice(k).map(LensModel::OpenCvFisheye),
        },
    ];

    /// Returns the family of a lens, or `None` if its coefficients do not describe it completely.
    #[must_use]
    pub fn of(lens: &LensModel) -> Option<&'static Self> {
        let name = lens.names().option;
        Self::ALL.iter().find(|family| family.name == name)
    }
}
