//! Stereo pairs with exact disparity in the layouts of Middlebury, KITTI and Scene Flow.

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Intrinsics, OpenCv};
use oaktwin_files::OutputFiles;
use oaktwin_image::{Image, pfm, png};
use serde_json::{Value, json};

use super::common::{DepthSummary, Depths, FrameFiles, center, count_lost, fixed, in_product, missing};
use crate::{Format, Records, Shot, StereoImages, WriteError};

/// Middlebury 2014: a folder for each frame with `im0.png`, `disp0.pfm`, `mask0nocc.png` (255 where the surface is visible in both images, 128
/// where it is not, 0 without a surface), the same of the right image as `im1.png` and so on, and `calib.txt`; measured depth is in `depth_sensor.pfm`, metres.
#[derive(Debug, Default)]
pub(super) struct Middlebury;

const MIDDLEBURY: &str = "middlebury";

impl Format for Middlebury {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let stereo = pair(MIDDLEBURY, shot)?;
        let folder = in_product(shot, format!("{:06}", shot.number));
        let mut frame = FrameFiles::default();
        for side in 0..2 {
            frame.add(format!("{folder}/im{side}.png"), move || {
                Ok(png::encode(&stereo.images[side])?)
            });
            frame.add(format!("{folder}/disp{side}.pfm"), move || {
                Ok(pfm::encode(&stereo.disparities[side]))
            });
            frame.add(format!("{folder}/mask{side}nocc.png"), move || {
                Ok(png::encode(&visibility(stereo, side))?)
            });
        }
        frame.add(format!("{folder}/calib.txt"), || {
            Ok(calibration(stereo).into_bytes())
        });
        let path = |kind: &str, extension: &str| format!("{folder}/{kind}.{extension}");
        write_with_depth(frame, path, shot, output)
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        DepthSummary::of(records)?.finish(MIDDLEBURY, f64::INFINITY, output)
    }
}

/// KITTI 2015: `training/image_2` and `image_3`, `disp_noc_0` and `disp_occ_0` in 1/256 px, `calib_cam_to_cam` with `P_rect_02` and `P_rect_03`, and `depth`
/// as in the depth benchmark in 1/256 m, which is measured if `depth_exact` is there.
#[derive(Debug, Default)]
pub(super) struct Kitti;

const KITTI: &str = "kitti";
const STEPS: f32 = 256.0;

impl Format for Kitti {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let stereo = pair(KITTI, shot)?;
        let root = in_product(shot, "training".to_owned());
        let name = format!("{:06}_10.png", shot.number);
        let mut frame = FrameFiles::default();
        frame.add(format!("{root}/image_2/{name}"), || {
            Ok(png::encode(&grey(&stereo.images[0]))?)
        });
        frame.add(format!("{root}/image_3/{name}"), || {
            Ok(png::encode(&grey(&stereo.images[1]))?)
        });
        frame.add(format!("{root}/disp_occ_0/{name}"), || {
            Ok(png::encode(&fixed(&stereo.disparities[0], STEPS))?)
        });
        frame.add(format!("{root}/disp_noc_0/{name}"), || {
            Ok(png::encode(&fixed(&matched(stereo), STEPS))?)
        });
        let depths = Depths::of(shot);
        frame.add_depths(&depths, STEPS, |folder| format!("{root}/{folder}/{name}").into());
        frame.add(format!("{root}/calib_cam_to_cam/{:06}.txt", shot.number), || {
            Ok(projections(stereo).into_bytes())
        });
        frame.write(output)?;
        let mut record = json!({"lost_disparity": count_lost(&stereo.disparities[0], STEPS)});
        depths.add_losses(STEPS, &mut record);
        Ok(record)
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        DepthSummary::of(records)?.finish(KITTI, 256.0, output)
    }
}

/// The layout of Scene Flow: below `FlyingThings3D`, `frames_cleanpass/TRAIN/A/SEQUENCE/left/NUMBER.png` and `right`,
/// `disparity/…/left/NUMBER.pfm` and `right` in px (the column in the left image minus that in the right; `+inf` without a surface), and
/// `disparity_occlusions/…/left/NUMBER.png` and `right` (255 where the other image does not show the surface). Measured depth is in `depth_sensor/…/left/NUMBER.pfm`, metres.
#[derive(Debug, Default)]
pub(super) struct SceneFlow;

const SCENEFLOW: &str = "sceneflow";

impl Format for SceneFlow {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let stereo = pair(SCENEFLOW, shot)?;
        let root = in_product(shot, "FlyingThings3D".to_owned());
        let path = |kind: &str, side: &str, extension: &str| {
            let (sequence, number) = (shot.sequence, shot.number);
            format!("{root}/{kind}/TRAIN/A/{sequence:04}/{side}/{number:04}.{extension}")
        };
        let mut frame = FrameFiles::default();
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            frame.add(path("frames_cleanpass", name, "png"), move || {
                Ok(png::encode(&grey(&stereo.images[side]))?)
            });
            frame.add(path("disparity", name, "pfm"), move || {
                Ok(pfm::encode(&stereo.disparities[side]))
            });
            frame.add(path("disparity_occlusions", name, "png"), move || {
                Ok(png::encode(&occlusion(stereo, side))?)
            });
        }
        write_with_depth(
            frame,
            |kind, extension| path(kind, "left", extension),
            shot,
            output,
        )
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        DepthSummary::of(records)?.finish(SCENEFLOW, f64::INFINITY, output)
    }
}

/// Writes the files of a frame, with the measured depth as PFM and what is known about it, and returns the frame's record.
fn write_with_depth<'a>(
    mut frame: FrameFiles<'a>,
    path: impl Fn(&str, &str) -> String,
    shot: &'a Shot,
    output: &mut OutputFiles,
) -> Result<Value, WriteError> {
    let depths = Depths::of(shot);
    if let (Some(measured), Some(_)) = (depths.main, depths.exact) {
        frame.add(path("depth_sensor", "pfm"), move || Ok(pfm::encode(measured)));
    }
    frame.add_quality(&depths, |kind| path(kind, "png"));
    frame.write(output)?;
    let mut record = json!({});
    depths.add_common(&mut record);
    Ok(record)
}

fn pair<'a>(format: &'static str, shot: &'a Shot) -> Result<&'a StereoImages, WriteError> {
    shot.stereo
        .as_ref()
        .ok_or_else(|| missing(format, "a stereo pair"))
}

fn visibility(stereo: &StereoImages, side: usize) -> Image<u8> {
    let disparity = &stereo.disparities[side];
    let mut mask = Image::filled(disparity.width(), disparity.height(), 0);
    let pixels = mask.pixels_mut().iter_mut().zip(disparity.pixels());
    for ((pixel, disparity), is_matched) in pixels.zip(stereo.is_matched[side].pixels()) {
        *pixel = match (disparity.is_finite(), is_matched) {
            (true, true) => 255,
            (true, false) => 128,
            (false, _) => 0,
        };
    }
    mask
}

/// 255 where the other image does not show the surface.
fn occlusion(stereo: &StereoImages, side: usize) -> Image<u8> {
    visibility(stereo, side).map(|seen| if *seen == 128 { 255 } else { 0 })
}

/// The disparities of the surfaces that both images see; 0 elsewhere.
fn matched(stereo: &StereoImages) -> Image<f32> {
    let [mut kept, _] = stereo.disparities.clone();
    for (disparity, is_matched) in kept.pixels_mut().iter_mut().zip(stereo.is_matched[0].pixels()) {
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
    let matrix = |camera: &Intrinsics| {
        let [cx, cy] = center(camera);
        format!("[{:.6} 0 {cx:.6}; 0 {:.6} {cy:.6}; 0 0 1]", camera.fx, camera.fy)
    };
    let doffs = right.principal_point::<OpenCv>().x - left.principal_point::<OpenCv>().x;
    let finite = stereo.disparities[0]
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

/// The lines of both cameras as in KITTI's files; the images are rectified, so that their size and their matrix are the same before and after.
fn projections(stereo: &StereoImages) -> String {
    let mut text = String::new();
    let numbers = |values: &[f64]| {
        let words: Vec<String> = values.iter().map(|value| format!("{value:.9e}")).collect();
        words.join(" ")
    };
    let identity = numbers(&DMat3::IDENTITY.to_cols_array());
    for (index, camera, x) in [
        (2, &stereo.cameras[0], 0.0),
        (3, &stereo.cameras[1], -stereo.baseline_m),
    ] {
        let Intrinsics { fx, fy, size, .. } = camera.intrinsics;
        let [cx, cy] = center(&camera.intrinsics);
        let size = numbers(&[size.width.into(), size.height.into()]);
        let matrix = numbers(&[fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0]);
        let projection = numbers(&[fx, 0.0, cx, fx * x, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0]);
        for (name, value) in [
            ("S", &size),
            ("K", &matrix),
            ("D", &numbers(&[0.0; 5])),
            ("R", &identity),
            ("T", &numbers(&[x, 0.0, 0.0])),
            ("S_rect", &size),
            ("R_rect", &identity),
            ("P_rect", &projection),
        ] {
            text += &format!("{name}_{index:02}: {value}\n");
        }
    }
    text
}
