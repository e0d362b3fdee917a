use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use super::common::{Depths, FrameFiles, by_folder, center, number, pinhole, quaternion, rgb, text};
use crate::{Format, Records, Shot, View, WriteError, euroc};

const NAME: &str = "euroc";
const PER_METRE: f32 = 1000.0;
const POSES: &str =
    "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []";

/// EuRoC's layout, one folder for each sequence: `mav0/cam0/{sensor.yaml,data.csv,data/NANOSECONDS.png}`, `cam1` and so on for the other
/// cameras, and the poses of the device's body in `mav0/state_groundtruth_estimate0/data.csv`. The depth of `cam0`, for which the data sets have
/// no place, is in `mav0/depth0` in millimetres. The sensor of `cam0` has the pose `T_BS` in the body's frame (x forward, y left, z up).
#[derive(Debug, Default)]
pub(super) struct Euroc;

impl Format for Euroc {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let view = pinhole(NAME, shot)?;
        let rgb = rgb(NAME, shot)?;
        let depths = Depths::of(shot);
        let folder = PathBuf::from(format!("{:06}/mav0", shot.sequence));
        let (camera, time) = (shot.camera, shot.time_ns);
        let path = |kind: &str| folder.join(format!("{kind}{camera}/data/{time}.png"));
        let mut frame = FrameFiles::default();
        frame.add_rgb(path("cam"), rgb);
        frame.add_depths(&depths, PER_METRE, path);
        frame.write(output)?;
        let body = &shot.world_from_mount;
        let [x, y, z] = body.translation.to_array();
        let [qx, qy, qz, qw] = quaternion(&body.rotation);
        let mut record = json!({
            "folder": folder.to_string_lossy(),
            "camera": camera,
            "time": time,
            "pose": format!("{time},{x:.9},{y:.9},{z:.9},{qw:.12},{qx:.12},{qy:.12},{qz:.12}"),
            "sensor": sensor(view, &(body.inverse() * view.world_from_camera)),
        });
        depths.add_losses(PER_METRE, &mut record);
        Ok(record)
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        let (sequences, summary) = by_folder(records, Sequence::add)?;
        for (folder, sequence) in sequences {
            sequence.write(Path::new(&folder), output)?;
        }
        summary.finish(NAME, 65.535, output)
    }
}

/// The description of a camera, without its rate.
fn sensor(view: &View, body_from_camera: &RigidTransform) -> String {
    let intrinsics = &view.camera.intrinsics;
    let [cx, cy] = center(intrinsics);
    format!(
        "sensor_type: camera\n{}resolution: [{}, {}]\ncamera_model: pinhole\n\
         intrinsics: [{:.9}, {:.9}, {cx:.9}, {cy:.9}]\ndistortion_model: radial-tangential\n\
         distortion_coefficients: [0.0, 0.0, 0.0, 0.0]\n",
        euroc::pose(body_from_camera),
        intrinsics.size.width,
        intrinsics.size.height,
        intrinsics.fx,
        intrinsics.fy,
    )
}

/// The files of a sequence.
#[derive(Default)]
struct Sequence {
    /// The poses by time, nanoseconds.
    poses: BTreeMap<u64, String>,
    cameras: BTreeMap<u64, Camera>,
}

#[derive(Default)]
struct Camera {
    sensor: String,
    times: Vec<u64>,
}

impl Sequence {
    fn add(&mut self, record: &Value) {
        let time = number(record, "time");
        self.poses.insert(time, text(record, "pose").to_owned());
        let camera = self.cameras.entry(number(record, "camera")).or_default();
        text(record, "sensor").clone_into(&mut camera.sensor);
        camera.times.push(time);
    }

    fn write(&self, folder: &Path, output: &mut OutputFiles) -> Result<(), WriteError> {
        let poses: String = self.poses.values().map(|pose| format!("{pose}\n")).collect();
        let place = folder.join("state_groundtruth_estimate0");
        output.write(&place.join("data.csv"), format!("{POSES}\n{poses}").as_bytes())?;
        let sensor = "sensor_type: visual-inertial\ncomment: exact poses of the device's body\n\
            T_BS:\n  cols: 4\n  rows: 4\n  data: [1.0, 0.0, 0.0, 0.0,\n         0.0, 1.0, 0.0, 0.0,\n         \
            0.0, 0.0, 1.0, 0.0,\n         0.0, 0.0, 0.0, 1.0]\n";
        output.write(&place.join("sensor.yaml"), sensor.as_bytes())?;
        output.write(&folder.join("body.yaml"), b"comment: oaktwin\n")?;
        for (index, camera) in &self.cameras {
            let place = folder.join(format!("cam{index}"));
            let lines: String = camera
                .times
                .iter()
                .map(|time| format!("{time},{time}.png\n"))
                .collect();
            let table = format!("#timestamp [ns],filename\n{lines}");
            output.write(&place.join("data.csv"), table.as_bytes())?;
            let description = format!("{}{}", camera.sensor, rate(&camera.times));
            output.write(&place.join("sensor.yaml"), description.as_bytes())?;
        }
        Ok(())
    }
}

/// The line with the mean rate; empty for a single frame.
fn rate(times: &[u64]) -> String {
    match times {
        [first, .., last] if last > first => {
            #[expect(clippy::cast_precision_loss, reason = "a rate")]
            let rate = (times.len() - 1) as f64 * 1e9 / (last - first) as f64;
            format!("rate_hz: {rate:.6}\n")
        }
        _ => String::new(),
    }
}
