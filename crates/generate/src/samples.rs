//! The samples of the inertial sensor along the trajectory of each arrangement.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::InertialPart;
use oaktwin_dataset::{WriteError, euroc};
use oaktwin_files::OutputFiles;
use oaktwin_pipeline::imu::{ImuOptions, ImuSimulation};

use crate::GenerateError;
use crate::context::Context;
use crate::inertial::Inertial;
use crate::run::Store;
use crate::unit::DrawnUnit;

/// The format that has samples.
const FORMAT: &str = "euroc";

/// Samples that are formatted at a time.
const BATCH: usize = 4096;

impl Context {
    /// Checks that the recipe has a motion, and a place for the samples of every model.
    ///
    /// # Errors
    /// Returns an error if it has not.
    pub(crate) fn check_inertial(&self) -> Result<Vec<Finding>, GenerateError> {
        let Some(inertial) = &self.inertial else {
            return Ok(Vec::new());
        };
        let recipe = &self.file.recipe;
        if !self.formats.iter().any(|format| format.name == FORMAT) {
            let remedy = "add it to output.formats, or remove camera.imu";
            return Err(self.unfit("camera.imu", "only the format euroc has samples", remedy));
        }
        let (poses, frames) = (self.trajectory.len() as u64, recipe.frames_per_scene);
        if frames < 2 || frames > poses {
            return Err(self.unfit(
                "camera.imu",
                format!("frames_per_scene is {frames}, and the trajectory has {poses} poses"),
                "give 2 or more frames to an arrangement, but not more than there are poses",
            ));
        }
        let mut findings = Vec::new();
        for model in inertial.parts.keys() {
            let unit = DrawnUnit::draw(self, model, 0);
            add_new(&mut findings, self.samples(inertial, 0, &unit)?.1);
        }
        Ok(findings)
    }

    /// Returns the biases of the gyroscope and of the accelerometer at each frame of an arrangement; nothing without an inertial sensor.
    pub(crate) fn biases(&self, number: u64, unit: &DrawnUnit) -> Result<Vec<[DVec3; 2]>, GenerateError> {
        let Some(inertial) = &self.inertial else {
            return Ok(Vec::new());
        };
        let (mut samples, _) = self.samples(inertial, number, unit)?;
        let rate_hz = samples.rate_hz();
        let mut taken = 0;
        let biases = (0..self.file.recipe.frames_per_scene).map(|index| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "a number of samples"
            )]
            let nearest = (self.since_first_s(index) * rate_hz).round() as u64;
            while taken < nearest && samples.next().is_some() {
                taken += 1;
            }
            samples.biases()
        });
        Ok(biases.collect())
    }

    /// Returns the time of a frame of an arrangement since its first one, seconds.
    pub(crate) fn since_first_s(&self, index: u64) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "times of a sequence, nanoseconds")]
        let seconds = self.time_ns(index).saturating_sub(self.time_ns(0)) as f64 * 1e-9;
        seconds
    }

    /// Returns the samples of an arrangement, whose poses begin at 0.
    fn samples(
        &self,
        inertial: &Inertial,
        number: u64,
        unit: &DrawnUnit,
    ) -> Result<(ImuSimulation, Vec<Finding>), GenerateError> {
        let motion = self.motion_of_poses()?;
        let twin = self.units(&unit.model).twin(unit.number);
        let options = ImuOptions {
            rate_hz: inertial.rule.rate_hz,
            seed: self.random.numbers("camera.imu", number).bits(),
        };
        let up = self.bases[self.base_of(number)].scene.up;
        let made = ImuSimulation::new(&twin, &inertial.parts[&unit.model], motion, up, options);
        made.map_err(|error| self.unfit("camera.imu", error.message, error.remedy))
    }

    /// Writes the samples of each arrangement that has frames, for each of the formats in these folders that has a place for them.
    ///
    /// # Errors
    /// Returns an error if a record cannot be read, or a file cannot be written.
    pub(crate) fn write_inertial(
        &self,
        store: &Store,
        frames: &BTreeSet<u64>,
        folder: &Path,
        format: &str,
    ) -> Result<OutputFiles, GenerateError> {
        let mut output = OutputFiles::in_folder(folder)?;
        let Some(inertial) = self.inertial.as_ref().filter(|_| format == FORMAT) else {
            return Ok(output);
        };
        let mut last = None;
        for frame in frames {
            let number = self.file.recipe.scene_of(*frame);
            if last.replace(number) == Some(number) {
                continue;
            }
            let unit = store.frame(*frame)?.unit;
            let (samples, _) = self.samples(inertial, number, &unit)?;
            let place = PathBuf::from(format!("{number:06}/mav0/imu0"));
            let part = &inertial.parts[&unit.model];
            output.write(&place.join("sensor.yaml"), description(part, &samples).as_bytes())?;
            let samples = samples.in_sequence(self.time_ns(0));
            write_samples(samples, &place.join("data.csv"), &mut output)?;
        }
        Ok(output)
    }
}

/// The description of an inertial sensor in EuRoC's terms.
fn description(part: &InertialPart, samples: &ImuSimulation) -> String {
    let noise = |noise: Option<oaktwin_imu::ChannelNoise>| {
        noise.map_or([0.0; 2], |noise| [noise.mean_density(), noise.mean_random_walk()])
    };
    let [gyroscope, accelerometer] = [part.gyroscope_noise(), part.accelerometer_noise()].map(noise);
    euroc::imu_description(&euroc::ImuDescription {
        part: &part.id,
        body_from_imu: samples.body_from_imu(),
        rate_hz: samples.rate_hz(),
        gyroscope,
        accelerometer,
    })
}

fn write_samples(samples: ImuSimulation, path: &Path, output: &mut OutputFiles) -> Result<(), WriteError> {
    let mut file = output.create(path)?;
    let mut text = euroc::HEADER.to_owned();
    for (index, sample) in samples.enumerate() {
        // Writing to a string cannot fail.
        _ = write!(text, "{}", euroc::EurocLine(&sample));
        if index % BATCH == BATCH - 1 {
            file.append(text.as_bytes())?;
            text.clear();
        }
    }
    file.append(text.as_bytes())?;
    Ok(output.finish(file)?)
}
