//! Distortion models of ROS.

use oaktwin_camera::{LensModel, OpenCvLens};

/// A distortion model's name and coefficients.
pub(super) struct Distortion {
    pub(super) model: &'static str,
    pub(super) d: Vec<f64>,
}

/// ROS's models: `plumb_bob` (k1 k2 p1 p2 k3), `rational_polynomial` (and k4 k5 k6), `equidistant` (k1 k2 k3 k4); `None`
/// for other lenses.
pub(super) fn distortion(lens: &LensModel) -> Option<Distortion> {
    let coefficients = match lens.as_opencv()? {
        OpenCvLens::Pinhole(coefficients) => coefficients,
        OpenCvLens::Fisheye(k) => {
            return Some(Distortion {
                model: "equidistant",
                d: k.to_vec(),
            });
        }
    };
    let (rational, [k4, k5, k6]) = (&coefficients[..8], [5, 6, 7].map(|at| coefficients[at]));
    Some(if [k4, k5, k6] == [0.0; 3] {
        Distortion {
            model: "plumb_bob",
            d: rational[..5].to_vec(),
        }
    } else {
        Distortion {
            model: "rational_polynomial",
            d: rational.to_vec(),
        }
    })
}

/// Returns a description of what `camera_info` cannot represent of a lens. Images and point clouds are not affected.
#[must_use]
pub fn ros_lens_loss(lens: &LensModel) -> Option<&'static str> {
    match lens.as_opencv() {
        None => Some("ROS has no model of this lens: camera_info is omitted"),
        Some(OpenCvLens::Pinhole(coefficients)) if coefficients[8..].iter().any(|c| *c != 0.0) => {
            Some("ROS has no thin prism and no tilt: camera_info contains the first eight coefficients only")
        }
        Some(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_camera::{OpenCvFisheye, OpenCvPinhole};

    #[test]
    fn chooses_the_smallest_model() {
        let opencv = |numbers: &[f64]| LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(numbers).unwrap());
        let of = |lens: &LensModel| distortion(lens).map(|found| (found.model, found.d));
        assert_eq!(of(&LensModel::Pinhole), Some(("plumb_bob", vec![0.0; 5])));
        let five = [0.1, 0.2, 0.3, 0.4, 0.5];
        assert_eq!(of(&opencv(&five)), Some(("plumb_bob", five.to_vec())));
        let eight = [0.1, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.6];
        assert_eq!(of(&opencv(&eight)), Some(("rational_polynomial", eight.to_vec())));
        let fisheye = LensModel::OpenCvFisheye(OpenCvFisheye::from_slice(&five[..4]).unwrap());
        assert_eq!(of(&fisheye), Some(("equidistant", five[..4].to_vec())));
        assert!(ros_lens_loss(&fisheye).is_none() && ros_lens_loss(&opencv(&eight)).is_none());
        let prism = [0.1, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.6, 0.01];
        assert!(ros_lens_loss(&opencv(&prism)).is_some());
    }
}
