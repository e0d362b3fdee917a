//! Stereo pairs with exact disparity: Middlebury's layout, and KITTI's.

use oaktwin_camera::OpenCv;
use oaktwin_diagnostic::Finding;
use oaktwin_files::OutputFiles;
use oaktwin_image::{Image, pfm, png};
use serde_json::{Value, json};

use super::common::{Depths, FrameFiles, Losses, center, count_lost, fixed, missing};
use crate::{Format, Records, Shot, StereoImages, WriteError};

/// Middlebury 2014: a folder for each frame with `im0.png`, `im1.png`, `disp0.pfm`, `mask0nocc.png` (255 where the surface is visible in both
/// images, 128 where it is not, 0 without a surface) and `calib.txt`; measured depth is in `depth_sensor.pfm`, metres.
#[derive(Debug, Default)]
pub(super) struct Middlebury;

const MIDDLEBURY: &str = "middlebury";

impl Format for Middlebury {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let stereo = pair(MIDDLEBURY, shot)?;
        let folder = match &shot.render_product {
            Some(product) => format!("{product}/{:06}", shot.number),
            None => format!("{:06}", shot.number),
        };
        let mut frame = FrameFiles::default();
        frame.add(format!("{folder}/im0.png"), || Ok(png::encode(&stereo.left)?));
        frame.add(format!("{folder}/im1.png"), || Ok(png::encode(&stereo.right)?));
        frame.add(format!("{folder}/disp0.pfm"), || {
            Ok(pfm::encode(&stereo.disparity))
        });
        frame.add(format!("{folder}/mask0nocc.png"), || {
            Ok(png::encode(&visibility(stereo))?)
        });
        frame.add(format!("{folder}/calib.txt"), || {
            Ok(calibration(stereo).into_bytes())
        });
        let depths = Depths::of(shot);
        if let (Some(measured), Some(_)) = (depths.main, depths.exact) {
            frame.add(format!("{folder}/depth_sensor.pfm"), move || {
                Ok(pfm::encode(measured))
            });
        }
        frame.write(output)?;
        let mut record = json!({});
        depths.add_foreign(&mut record);
        Ok(record)
    }

    fn finish(&self, records: &mut Records<'_>, _: &mut OutputFiles) -> Result<Vec<Finding>, WriteError> {
        Ok(Losses::of(records)?.findings(MIDDLEBURY, f64::INFINITY))
    }
}

/// KITTI 2015: `training/image_2` and `image_3`, `disp_noc_0` and `disp_occ_0` in 1/256 px, `calib_cam_to_cam` with `P2` and `P3`, and `depth`
/// as in the depth benchmark in 1/256 m, which is measured if `depth_exact` is there.
#[derive(Debug, Default)]
pub(super) struct Kitti;

const KITTI: &str = "kitti";
const STEPS: f32 = 256.0;

impl Format for Kitti {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let stereo = pair(KITTI, shot)?;
        let root = match &shot.render_product {
            Some(product) => format!("{product}/training"),
            None => "training".to_owned(),
        };
        let name = format!("{:06}_10.png", shot.number);
        let mut frame = FrameFiles::default();
        frame.add(format!("{root}/image_2/{name}"), || {
            Ok(png::encode(&grey(&stereo.left))?)
        });
        frame.add(format!("{root}/image_3/{name}"), || {
            Ok(png::encode(&grey(&stereo.right))?)
        });
        frame.add(format!("{root}/disp_occ_0/{name}"), || {
            Ok(png::encode(&fixed(&stereo.disparity, STEPS))?)
        });
        frame.add(format!("{root}/disp_noc_0/{name}"), || {
            Ok(png::encode(&fixed(&matched(stereo), STEPS))?)
        });
        let depths = Depths::of(shot);
        for (folder, depth) in [("depth", depths.main), ("depth_exact", depths.exact)] {
            if let Some(depth) = depth {
                frame.add_depth(format!("{root}/{folder}/{name}"), depth, STEPS);
            }
        }
        frame.add(format!("{root}/calib_cam_to_cam/{:06}.txt", shot.number), || {
            Ok(projections(stereo).into_bytes())
        });
        frame.write(output)?;
        let mut record = json!({"lost_disparity": count_lost(&stereo.disparity, STEPS)});
        depths.add_losses(STEPS, &mut record);
        Ok(record)
    }

    fn finish(&self, records: &mut Records<'_>, _: &mut OutputFiles) -> Result<Vec<Finding>, WriteError> {
        Ok(Losses::of(records)?.findings(KITTI, 256.0))
    }
}

fn pair<'a>(format: &'static str, shot: &'a Shot) -> Result<&'a StereoImages, WriteError> {
    shot.stereo
        .as_ref()
        .ok_or_else(|| missing(format, "a stereo pair"))
}

fn visibility(stereo: &StereoImages) -> Image<u8> {
    let mut mask = Image::filled(stereo.disparity.width(), stereo.disparity.height(), 0);
    let pixels = mask.pixels_mut().iter_mut().zip(stereo.disparity.pixels());
    for ((pixel, disparity), is_matched) in pixels.zip(stereo.is_matched.pixels()) {
        *pixel = match (disparity.is_finite(), is_matched) {
            (true, true) => 255,
            (true, false) => 128,
            (false, _) => 0,
        };
    }
    mask
}

/// The disparities of the surfaces that both images see; 0 elsewhere.
fn matched(stereo: &StereoImages) -> Image<f32> {
    let mut kept = stereo.disparity.clone();
    for (disparity, is_matched) in kept.pixels_mut().iter_mut().zip(stereo.is_matched.pixels()) {
        if !is_matched {
            *disparity = 0.0;
        }
    }
    kept
}

fn grey(image: &Image<u8>) -> Image<[u8; 3]> {
    image.map(|value| [*value; 3])
}

fn calibration(stereo: &StereoImages) -> String {
    let [left, right] = stereo.cameras.map(|camera| camera.intrinsics);
    let matrix = |camera: &oaktwin_camera::Intrinsics| {
        let [cx, cy] = center(camera);
        format!("[{:.6} 0 {cx:.6}; 0 {:.6} {cy:.6}; 0 0 1]", camera.fx, camera.fy)
    };
    let doffs = right.principal_point::<OpenCv>().x - left.principal_point::<OpenCv>().x;
    let finite = stereo
        .disparity
        .pixels()
        .iter()
        .filter(|disparity| disparity.is_finite());
    let (low, high) = finite.fold((f32::INFINITY, 0.0f32), |(low, high), disparity| {
        (low.min(*disparity), high.max(*disparity))
    });
    let low = if low.is_finite() {
        low.floor().max(0.0)
    } else {
        0.0
    };
    format!(
        "cam0={}\ncam1={}\ndoffs={doffs:.6}\nbaseline={:.6}\nwidth={}\nheight={}\nndisp={}\nisint=0\nvmin={low}\nvmax={}\n",
        matrix(&left),
        matrix(&right),
        stereo.baseline_m * 1000.0,
        left.size.width,
        left.size.height,
        high.ceil() + 1.0,
        high.ceil(),
    )
}

fn projections(stereo: &StereoImages) -> String {
    let mut text = String::new();
    for (index, (camera, shift)) in [
        (2, (stereo.cameras[0], 0.0)),
        (3, (stereo.cameras[1], stereo.baseline_m)),
    ] {
        let intrinsics = camera.intrinsics;
        let [cx, cy] = center(&intrinsics);
        let (fx, fy) = (intrinsics.fx, intrinsics.fy);
        let offset = if shift > 0.0 { -fx * shift } else { 0.0 };
        text += &format!("P{index}: {fx:.9e} 0 {cx:.9e} {offset:.9e} 0 {fy:.9e} {cy:.9e} 0 0 0 1 0\n");
    }
    text
}
