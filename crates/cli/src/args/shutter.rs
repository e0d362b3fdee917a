use std::collections::BTreeMap;

use clap::Args;
use oaktwin::camera::math::DVec3;
use oaktwin::render::{Shutter, Twist};

use crate::context::Result;

/// How long frames take.
#[derive(Args, Debug)]
#[command(next_help_heading = "Shutter")]
pub(crate) struct ShutterArgs {
    /// Blur what moves: expose each row for so many ms [default: frames are moments]
    ///
    /// Sensors that roll also read their rows one after another. The time of a frame is the middle of its exposure.
    #[arg(long, value_name = "MS", allow_hyphen_values = true)]
    exposure: Option<f64>,

    /// Read the rows of sensors that roll in so many ms [default: the sensor's own]
    #[arg(long, value_name = "MS", allow_hyphen_values = true)]
    readout: Option<f64>,

    /// Move the OAK at --pose or --look-at while it takes a frame: m/s in the world, deg/s about its axes
    #[arg(
        long,
        num_args = 6,
        value_names = ["VX", "VY", "VZ", "WX", "WY", "WZ"],
        allow_hyphen_values = true,
        requires = "model",
        conflicts_with_all = ["trajectory", "frames"]
    )]
    velocity: Option<Vec<f64>>,

    /// Delay the frames of a camera by this many ms relative to the other cameras; repeatable
    ///
    /// They have the camera's own times, poses and scenes, for devices whose cameras are not synchronized.
    #[arg(long, value_name = "CAMERA=MS")]
    camera_offset: Vec<String>,
}

impl ShutterArgs {
    /// The shutter, if frames take time.
    pub(crate) fn shutter(&self) -> Option<Shutter> {
        (self.exposure.is_some() || self.readout.is_some()).then(|| Shutter {
            exposure_ms: self.exposure.unwrap_or(0.0),
            readout_ms: self.readout,
        })
    }

    /// How long after the others each camera takes its frames, ms.
    pub(crate) fn camera_offsets_ms(&self) -> Result<BTreeMap<String, f64>> {
        let read = |text: &String| {
            let parts = text.split_once('=');
            let parts = parts.and_then(|(camera, ms)| Some((camera.trim(), ms.trim().parse().ok()?)));
            let (camera, ms) = parts.ok_or_else(|| {
                format!("--camera-offset: invalid offset '{text}'; write CAMERA=MS, such as rgb=8.3")
            })?;
            Ok((camera.to_owned(), ms))
        };
        self.camera_offset.iter().map(read).collect()
    }

    /// The velocity of the OAK, if it is given.
    pub(crate) fn twist(&self) -> Result<Option<Twist>> {
        let Some(numbers) = &self.velocity else {
            return Ok(None);
        };
        if self.shutter().is_none() {
            return Err(
                "--velocity requires --exposure or --readout; without them, frames are moments".into(),
            );
        }
        let numbers: [f64; 6] = numbers[..].try_into().map_err(|_| "--velocity takes 6 numbers")?;
        if let Some(number) = numbers.iter().find(|number| !number.is_finite()) {
            return Err(format!("--velocity: {number} is not finite; give finite numbers").into());
        }
        let [vx, vy, vz, wx, wy, wz] = numbers;
        Ok(Some(Twist {
            velocity: DVec3::new(vx, vy, vz),
            angular_velocity: DVec3::new(wx, wy, wz).map(f64::to_radians),
        }))
    }
}
