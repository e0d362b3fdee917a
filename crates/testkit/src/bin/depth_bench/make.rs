use oaktwin_depth::preset::Platform;
use std::error::Error;
use std::fs;
use std::path::Path;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::DepthShot;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::{Parameters, StereoNoise};
use oaktwin_image::{millimetres, npy};

use crate::{HEIGHT, WIDTH, room};

/// Writes the input images.
pub(crate) fn images(folder: &Path) -> Result<(), Box<dyn Error>> {
    let (depth, rgb) = room::ray_cast(WIDTH, HEIGHT);
    let (rows, columns) = (HEIGHT as usize, WIDTH as usize);
    let channels: Vec<u8> = rgb.pixels().iter().flatten().copied().collect();
    fs::create_dir_all(folder)?;
    fs::write(
        folder.join("depth.npy"),
        npy::encode(&[rows, columns], depth.pixels())?,
    )?;
    fs::write(
        folder.join("rgb.npy"),
        npy::encode(&[rows, columns, 4], &channels)?,
    )?;
    let (far, _) = room::ray_cast(640, 480);
    fs::write(
        folder.join("depth_640.npy"),
        npy::encode(&[480, 640], far.pixels())?,
    )?;
    let stereo = StereoGeometry {
        focal_length_px: 805.0,
        baseline_m: 0.075,
    };
    let engine = StereoNoise::new(Parameters::new(Platform::Rvc2, stereo, WIDTH))?;
    let mut frames = Vec::new();
    for frame in 0..4 {
        let mut shot = DepthShot::new((&depth).into());
        shot.frame = frame;
        let sensed = engine.sense(&shot, &Stream::new(7, "Camera_pseudo_depth"));
        frames.extend(millimetres::from_metres(&sensed.0).into_pixels());
    }
    fs::write(
        folder.join("millimetres.npy"),
        npy::encode(&[4, rows, columns], &frames)?,
    )?;
    Ok(())
}
