//! An OAK, or the cameras of a stage, with everything that makes images of a scene.

mod build;
mod colors;
mod during;
mod error;
mod findings;
mod measure;
mod shoot;
mod spec;
#[cfg(test)]
mod tests;

pub use error::RigError;
pub use spec::{PairUse, RigSpec, depth_sensor_of};

use std::sync::Arc;

use oaktwin_camera::RigidTransform;
use oaktwin_image::annotation::Annotator;
use oaktwin_render::{Backend, Transparent};

use self::colors::RgbImager;
use super::PlacedCamera;
use super::shutter::{Shutter, Twist};
use super::sweep::SweptSensors;
use crate::pair::PairCameras;
use crate::sensor::Sensor;

/// Cameras with their depth sensors and the stereo pair that these match, which can be placed in any scene.
///
/// [`Rig::new`] makes the rig of an OAK, and [`Rig::of_stage`] the rig of a stage's own cameras; [`Rig::shoot`] renders and measures
/// one frame, [`Rig::measure`] measures images that were rendered elsewhere, and [`write_frames`](super::write_frames) is the loop over
/// the frames of a data set.
///
/// A rig is mutable where its sensors remember earlier frames, which only temporal filters do; a clone continues on its own.
#[derive(Clone, Debug)]
pub struct Rig {
    /// The name of the model, or of the stage's file.
    name: String,
    cameras: Vec<PlacedCamera>,
    /// The depth sensor of each camera.
    sensors: Vec<Option<Sensor>>,
    swept: Option<SweptSensors>,
    /// Shared, because a pair has large tables.
    pair: Option<Arc<PairCameras>>,
    pair_use: PairUse,
    annotators: Vec<Annotator>,
    are_outputs_optional: bool,
    /// What records the colours of each camera; none if colours are exact.
    imagers: Vec<RgbImager>,
    backend: Backend,
    transparent: Transparent,
    shutter: Option<Shutter>,
    /// How long after the time of a frame each camera takes it, s.
    offsets_s: Vec<f64>,
    /// The velocity while a frame is taken at a pose of no trajectory.
    twist: Option<Twist>,
}

impl Rig {
    /// Returns the name of the model, or of the stage's file.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the cameras.
    #[must_use]
    pub fn cameras(&self) -> &[PlacedCamera] {
        &self.cameras
    }

    /// Returns the depth sensor of each camera; none of a camera without one, or if no annotator requires them.
    #[must_use]
    pub fn sensors(&self) -> &[Option<Sensor>] {
        &self.sensors
    }

    /// Returns the first camera with a depth sensor, and its sensor.
    #[must_use]
    pub fn depth_sensor(&self) -> Option<(&PlacedCamera, &Sensor)> {
        let mut both = self.cameras.iter().zip(&self.sensors);
        both.find_map(|(camera, sensor)| Some((camera, sensor.as_ref()?)))
    }

    /// Returns the stereo pair, if it is used.
    #[must_use]
    pub fn pair(&self) -> Option<&PairCameras> {
        self.pair.as_deref()
    }

    /// Returns the annotators of a shot.
    #[must_use]
    pub fn annotators(&self) -> &[Annotator] {
        &self.annotators
    }

    /// Returns how long a frame takes, if it takes time.
    #[must_use]
    pub fn shutter(&self) -> Option<&Shutter> {
        self.shutter.as_ref()
    }

    /// Returns how long after the time of a frame a camera takes it, s.
    #[must_use]
    pub fn offset_s(&self, camera: usize) -> f64 {
        self.offsets_s.get(camera).copied().unwrap_or(0.0)
    }

    /// The same in nanoseconds, as stamps have it.
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "at most 10 s, not negative"
    )]
    pub fn offset_ns(&self, camera: usize) -> u64 {
        (self.offset_s(camera) * 1e9).round() as u64
    }

    /// Whether frames have times besides their own.
    pub(in crate::render) fn takes_time(&self) -> bool {
        self.shutter.is_some() || self.offsets_s.iter().any(|offset_s| *offset_s > 0.0)
    }

    /// Returns the rig with the body of its OAK (x forward, y left, z up), or each of a stage's cameras, at a pose in metres.
    #[must_use]
    pub fn at(mut self, world_from_body: &RigidTransform) -> Self {
        for camera in &mut self.cameras {
            camera.world_from_mount = *world_from_body;
        }
        self
    }

    /// Returns the rig with a velocity at the pose where it is put, for frames that take time.
    #[must_use]
    pub fn moving(mut self, twist: Twist) -> Self {
        self.twist = Some(twist);
        self
    }

    /// Returns the velocity that [`Rig::moving`] gave.
    #[must_use]
    pub(in crate::render) fn twist(&self) -> Option<&Twist> {
        self.twist.as_ref()
    }

    /// Moves the cameras to the poses of others. Returns whether the others are the same but for their poses, without which nothing is moved.
    pub(in crate::render) fn place_cameras(&mut self, others: Vec<PlacedCamera>) -> bool {
        let is_same = |(own, other): (&PlacedCamera, &PlacedCamera)| {
            let moved = PlacedCamera {
                world_from_mount: own.world_from_mount,
                ..other.clone()
            };
            moved == *own
        };
        let are_same = others.len() == self.cameras.len() && self.cameras.iter().zip(&others).all(is_same);
        if are_same {
            self.cameras = others;
        }
        are_same
    }

    /// Returns each camera as a rig of its own. Cameras without a depth sensor are left out.
    #[must_use]
    pub fn split(self) -> Vec<Self> {
        let cameras = self
            .cameras
            .iter()
            .zip(&self.sensors)
            .zip(&self.offsets_s)
            .zip(0..);
        let measuring = cameras.filter(|(((_, sensor), _), _)| sensor.is_some());
        let alone = measuring.map(|(((camera, sensor), offset_s), index)| Self {
            imagers: self.imagers.get(index).copied().into_iter().collect(),
            name: camera.path.clone(),
            cameras: vec![camera.clone()],
            sensors: vec![sensor.clone()],
            offsets_s: vec![*offset_s],
            swept: None,
            pair: self.pair.clone(),
            annotators: self.annotators.clone(),
            ..self
        });
        alone.collect()
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        for sensor in self.sensors.iter_mut().flatten() {
            sensor.reset();
        }
    }
}
