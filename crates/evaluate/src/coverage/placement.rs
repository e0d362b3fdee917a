//! Poses of an OAK: given ones, and sweeps of their height and tilt.

use oaktwin_base::diagnostic::{message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_pipeline::render::{PoseError, look_at};

use super::CoverageError;
use super::measure::check_candidates;
use crate::list::{self, InvalidItem};

/// The poses that a sweep starts from.
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// Poses of the body (x forward, y left, z up) in the world, in metres.
    Poses(Vec<RigidTransform>),
    /// A position of the body, the point it faces at any height, and the direction of its z axis.
    LookAt {
        /// The position.
        eye: DVec3,
        /// The point.
        target: DVec3,
        /// The direction.
        up: DVec3,
    },
}

/// A sweep: every combination of a pose, a height and a tilt.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlacementSweep {
    /// The heights along the scene's up axis in metres; if empty, the heights of the poses.
    pub heights_m: Vec<f64>,
    /// The angles in degrees by which the body's x axis points below the horizontal; they keep its heading and remove its roll. If
    /// empty, the orientation is kept.
    pub tilts_deg: Vec<f64>,
}

/// A pose with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// The name: `pose 2, height 1.5 m, tilt 30°`.
    pub name: String,
    /// The pose of the body in the world.
    pub world_from_body: RigidTransform,
}

impl PlacementSweep {
    /// Creates a sweep from lists of numbers and ranges `FROM:TO:STEP`, separated by commas.
    ///
    /// # Errors
    /// Returns an error if an item is not a number or out of range.
    pub fn parse(heights_m: Option<&str>, tilts_deg: Option<&str>) -> Result<Self, CoverageError> {
        let sweep = Self {
            heights_m: numbers("height", "metres", heights_m)?,
            tilts_deg: numbers("tilt", "degrees", tilts_deg)?,
        };
        sweep.check()?;
        Ok(sweep)
    }

    fn check(&self) -> Result<(), CoverageError> {
        if let Some(height) = self.heights_m.iter().find(|height| !height.is_finite()) {
            return Err(message![opt("height"), format!(": {height} is not finite; give metres")].into());
        }
        if let Some(tilt) = self.tilts_deg.iter().find(|tilt| !(-90.0..=90.0).contains(*tilt)) {
            let what = format!(": {tilt} is out of range; give -90 (up) to 90 (down) degrees");
            return Err(message![opt("tilt"), what].into());
        }
        Ok(())
    }

    /// Returns the swept poses; `up` is the scene's up axis.
    ///
    /// # Errors
    /// Returns an error if a number is out of range, there are too many poses, or a pose is undefined.
    pub fn placements(&self, base: &Base, up: DVec3) -> Result<Vec<Placement>, CoverageError> {
        self.check()?;
        let count = match base {
            Base::Poses(poses) => poses.len(),
            Base::LookAt { .. } => 1,
        };
        let each = self
            .heights_m
            .len()
            .max(1)
            .saturating_mul(self.tilts_deg.len().max(1));
        check_candidates(count.saturating_mul(each))?;
        let mut placements = Vec::new();
        for pose in 0..count {
            for height in options(&self.heights_m) {
                let body = base.at_height(pose, height, up)?;
                for tilt in options(&self.tilts_deg) {
                    placements.push(Placement {
                        name: name((count > 1).then_some(pose), height, tilt),
                        world_from_body: match tilt {
                            Some(tilt) => tilted(&body, tilt.to_radians(), up)?,
                            None => body,
                        },
                    });
                }
            }
        }
        Ok(placements)
    }
}

impl Base {
    /// The pose of an index, at another height if one is given.
    fn at_height(
        &self,
        pose: usize,
        height: Option<f64>,
        up: DVec3,
    ) -> Result<RigidTransform, CoverageError> {
        let moved = |position: DVec3| match height {
            Some(height) => position + up * (height - position.dot(up)),
            None => position,
        };
        match self {
            Self::Poses(poses) => Ok(RigidTransform::new(
                poses[pose].rotation,
                moved(poses[pose].translation),
            )),
            Self::LookAt { eye, target, up } => look_at(moved(*eye), *target, *up).map_err(|error| {
                let at = height.map_or_else(String::new, |height| format!(" at a height of {height} m"));
                message![opt("look-at"), format!("{at}: {error}")].into()
            }),
        }
    }
}

/// Returns a pose with the same position and heading whose x axis points below the horizontal by an angle.
fn tilted(body: &RigidTransform, tilt: f64, up: DVec3) -> Result<RigidTransform, CoverageError> {
    let level = |axis: DVec3| axis - up * axis.dot(up);
    let forward = body.rotation.x_axis;
    // A body that faces straight down has its heading above it, as seen by the camera.
    let heading = if level(forward).length() > 1e-6 {
        level(forward)
    } else {
        level(body.rotation.z_axis) * -forward.dot(up)
    };
    let heading = heading.normalize_or_zero();
    let forward = heading * tilt.cos() - up * tilt.sin();
    let above = heading * tilt.sin() + up * tilt.cos();
    let position = body.translation;
    look_at(position, position + forward, above)
        .map_err(|error: PoseError| message![opt("tilt"), format!(": {error}")].into())
}

/// The numbers of an axis; `None` once if it is not swept.
fn options(numbers: &[f64]) -> Vec<Option<f64>> {
    if numbers.is_empty() {
        vec![None]
    } else {
        numbers.iter().copied().map(Some).collect()
    }
}

fn name(pose: Option<usize>, height: Option<f64>, tilt: Option<f64>) -> String {
    let parts = [
        pose.map(|pose| format!("pose {pose}")),
        height.map(|height| format!("height {height} m")),
        tilt.map(|tilt| format!("tilt {tilt}°")),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    if parts.is_empty() {
        "pose 0".to_owned()
    } else {
        parts.join(", ")
    }
}

fn numbers(option: &'static str, unit: &str, text: Option<&str>) -> Result<Vec<f64>, CoverageError> {
    let Some(text) = text else {
        return Ok(Vec::new());
    };
    list::parse(text, "a number", |number| {
        if number.is_finite() {
            Ok(number)
        } else {
            Err("is not finite")
        }
    })
    .map_err(|InvalidItem { text, what }| {
        let what = format!(": '{text}' {what}; give {unit}, separated by commas, or FROM:TO:STEP");
        message![opt(option), what].into()
    })
}
