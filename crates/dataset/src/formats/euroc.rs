use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};
use oaktwin_files::OutputFiles;
use oaktwin_imu::Motion;
use serde::Deserialize;
use serde_json::{Value, json};

use super::common::{Depths, FrameFiles, by_folder, center, number, quaternion, rgb, text};
use super::lens::{Lens, lens};
use crate::{Format, FrameCamera, Records, Shot, WriteError, euroc};

const NAME: &str = "euroc";
const PER_METRE: f32 = 1000.0;
const STATES: &str = "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], \
    v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1], b_w_RS_S_y [rad s^-1], b_w_RS_S_z [rad s^-1], \
    b_a_RS_S_x [m s^-2], b_a_RS_S_y [m s^-2], b_a_RS_S_z [m s^-2]";

/// EuRoC's layout, one folder for each sequence: `mav0/cam0/{sensor.yaml,data.csv,data/NANOSECONDS.png}`, `cam1` and so on for the other
/// cameras, and the state of the device's body in `mav0/state_groundtruth_estimate0/data.csv`: its pose, its velocity along the smooth motion
/// through all poses, and the biases of the inertial sensor, 0 without one. Times that count from the start of a sequence are
/// stamped from 14 July 2017, because readers fail at 0. The depth of `cam0`, for which the data sets have
/// no place, is in `mav0/depth0` in millimetres. The sensor of `cam0` has the pose `T_BS` in the body's frame (x forward, y left, z up).
#[derive(Debug, Default)]
pub(super) struct Euroc;

impl Format for Euroc {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let (view, lens) = lens(NAME, shot, 2)?;
        let rgb = rgb(NAME, shot)?;
        let depths = Depths::of(shot);
        let folder = PathBuf::from(format!("{:06}/mav0", shot.sequence));
        let (camera, time) = (shot.camera, euroc::stamp(shot.time_ns));
        let path = |kind: &str| folder.join(format!("{kind}{camera}/data/{time}.png"));
        let mut frame = FrameFiles::default();
        frame.add_rgb(path("cam"), rgb);
        frame.add_depths(&depths, PER_METRE, path);
        frame.write(output)?;
        let body = &shot.world_from_mount;
        let [qx, qy, qz, qw] = quaternion(&body.rotation);
        let mut record = json!({
            "folder": folder.to_string_lossy(),
            "camera": camera,
            "time": time,
            "position": body.translation.to_array(),
            "orientation": [qw, qx, qy, qz],
            "biases": shot.imu_biases.unwrap_or_default().map(|bias| bias.to_array()),
            "sensor": sensor(view, lens, &(body.inverse() * view.world_from_camera)),
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
fn sensor(view: &FrameCamera, lens: Lens, body_from_camera: &RigidTransform) -> String {
    let (model, [a, b, c, d]) = match lens {
        Lens::Pinhole => ("radial-tangential", [0.0; 4]),
        Lens::Radial { k, p } => ("radial-tangential", [k[0], k[1], p[0], p[1]]),
        Lens::Fisheye(k) => ("equidistant", k),
    };
    let intrinsics = &view.camera.intrinsics;
    let [cx, cy] = center(intrinsics);
    format!(
        "sensor_type: camera\n{}resolution: [{}, {}]\ncamera_model: pinhole\n\
         intrinsics: [{:.9}, {:.9}, {cx:.9}, {cy:.9}]\ndistortion_model: {model}\n\
         distortion_coefficients: [{a:?}, {b:?}, {c:?}, {d:?}]\n",
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
    /// The states by time, nanoseconds.
    states: BTreeMap<u64, BodyState>,
    cameras: BTreeMap<u64, Camera>,
}

/// The state of the body.
#[derive(Default, Deserialize)]
struct BodyState {
    position: [f64; 3],
    /// w, x, y, z.
    orientation: [f64; 4],
    biases: [[f64; 3]; 2],
}

#[derive(Default)]
struct Camera {
    sensor: String,
    times: Vec<u64>,
}

impl Sequence {
    fn add(&mut self, record: &Value) {
        let time = number(record, "time");
        let state = BodyState::deserialize(record).unwrap_or_default();
        self.states.insert(time, state);
        let camera = self.cameras.entry(number(record, "camera")).or_default();
        text(record, "sensor").clone_into(&mut camera.sensor);
        camera.times.push(time);
    }

    fn write(&self, folder: &Path, output: &mut OutputFiles) -> Result<(), WriteError> {
        let place = folder.join("state_groundtruth_estimate0");
        output.write(&place.join("data.csv"), self.states().as_bytes())?;
        let sensor = "sensor_type: visual-inertial\ncomment: exact states of the device's body\n\
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

impl Sequence {
    /// The table of the states, with the velocities of the smooth motion through all poses.
    fn states(&self) -> String {
        let first = self.states.keys().next().copied().unwrap_or_default();
        #[expect(clippy::cast_precision_loss, reason = "times of a sequence")]
        let since_start = |time: u64| (time - first) as f64 * 1e-9;
        let pose = |(time, state): (&u64, &BodyState)| {
            let [w, x, y, z] = state.orientation;
            let rotation = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
            (
                since_start(*time),
                RigidTransform::new(rotation, state.position.into()),
            )
        };
        let poses: Vec<_> = self.states.iter().map(pose).collect();
        // A single pose has no velocity.
        let motion = Motion::new(&poses).ok();
        let mut table = format!("{STATES}\n");
        for (time, state) in &self.states {
            let velocity =
                (motion.as_ref()).map_or(DVec3::ZERO, |motion| motion.at(since_start(*time)).velocity);
            // Adding 0 makes −0 positive.
            let velocity = (velocity + 0.0).to_array();
            table += &time.to_string();
            for (values, digits) in [
                (&state.position[..], 9),
                (&state.orientation, 12),
                (&velocity, 9),
                (state.biases.as_flattened(), 12),
            ] {
                values
                    .iter()
                    .for_each(|value| table += &format!(",{value:.digits$}"));
            }
            table.push('\n');
        }
        table
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
