use oaktwin_camera::math::DQuat;
use oaktwin_catalog::{Role, Twin};
use serde::Serialize;

use crate::population::Unit;

/// The properties of a unit in which units differ most.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct UnitSummary {
    /// The number of the unit.
    pub number: u64,
    /// The name of its calibration file.
    pub file: String,
    /// The focal length of the colour camera, px.
    pub color_focal_length_px: Option<f64>,
    /// The stereo pair, if the model has one.
    #[serde(flatten)]
    pub pair: Option<UnitPairSummary>,
}

/// The stereo pair of a unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct UnitPairSummary {
    /// The focal length of the left camera, px.
    pub left_focal_length_px: f64,
    /// The focal length of the right camera, px.
    pub right_focal_length_px: f64,
    /// The distance of the optical centres, mm.
    pub baseline_mm: f64,
    /// The rotation of the right camera relative to the left one about the axes of its image (down, right, forward), mrad.
    pub yaw_mrad: f64,
    /// See [`yaw_mrad`](Self::yaw_mrad).
    pub pitch_mrad: f64,
    /// See [`yaw_mrad`](Self::yaw_mrad).
    pub roll_mrad: f64,
    /// The angle between the housing's forward axis and the viewing direction of depth images, mrad.
    pub boresight_mrad: f64,
}

/// The name of a number of a summary, and its value.
type Number = (&'static str, fn(&UnitSummary) -> Option<f64>);

impl UnitSummary {
    /// The numbers with the names of their fields.
    pub const NUMBERS: [Number; 8] = [
        ("color_focal_length_px", |unit| unit.color_focal_length_px),
        ("left_focal_length_px", |unit| {
            Some(unit.pair?.left_focal_length_px)
        }),
        ("right_focal_length_px", |unit| {
            Some(unit.pair?.right_focal_length_px)
        }),
        ("baseline_mm", |unit| Some(unit.pair?.baseline_mm)),
        ("yaw_mrad", |unit| Some(unit.pair?.yaw_mrad)),
        ("pitch_mrad", |unit| Some(unit.pair?.pitch_mrad)),
        ("roll_mrad", |unit| Some(unit.pair?.roll_mrad)),
        ("boresight_mrad", |unit| Some(unit.pair?.boresight_mrad)),
    ];
}

/// How a number differs between units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub deviation: f64,
    /// The smallest value.
    pub smallest: f64,
    /// The largest value.
    pub largest: f64,
}

impl Statistics {
    /// Returns the statistics of some values; `None` without values.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        Some(Self {
            mean,
            deviation: (squares / count).sqrt(),
            smallest: values.iter().copied().reduce(f64::min)?,
            largest: values.iter().copied().reduce(f64::max)?,
        })
    }
}

impl Unit {
    /// Returns what distinguishes the unit.
    #[must_use]
    pub fn summary(&self) -> UnitSummary {
        let fx = |role| self.twin.camera(role).map(|camera| camera.intrinsics.fx);
        UnitSummary {
            number: self.number,
            file: self.file_name(),
            color_focal_length_px: fx(Role::Rgb),
            pair: pair(&self.twin),
        }
    }

    /// Returns the name of the unit's calibration file: `oak_d_pro_poe_000007.json`.
    #[must_use]
    pub fn file_name(&self) -> String {
        format!("{}_{:06}.json", self.twin.device.id, self.number)
    }
}

fn pair(twin: &Twin) -> Option<UnitPairSummary> {
    let (left, right) = (twin.camera(Role::Left)?, twin.camera(Role::Right)?);
    let left_from_right = left.body_from_camera.inverse() * right.body_from_camera;
    let rotation = DQuat::from_mat3(&left_from_right.rotation).to_scaled_axis() * 1e3;
    let forward = twin
        .rectified_left((Role::Left, Role::Right))?
        .body_from_camera
        .rotation
        .z_axis;
    Some(UnitPairSummary {
        left_focal_length_px: left.intrinsics.fx,
        right_focal_length_px: right.intrinsics.fx,
        baseline_mm: left_from_right.translation.length() * 1e3,
        yaw_mrad: rotation.y,
        pitch_mrad: rotation.x,
        roll_mrad: rotation.z,
        boresight_mrad: forward.x.clamp(-1.0, 1.0).acos() * 1e3,
    })
}
