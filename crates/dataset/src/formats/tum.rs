use std::path::PathBuf;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use super::common::{
    Depths, FrameFiles, by_folder, camera_matrix, distortion, missing, quaternion, seconds, sequence_folder,
    text,
};
use crate::{Format, Records, Shot, WriteError, json as files};

const NAME: &str = "tum";
const PER_METRE: f32 = 5000.0;

/// The layout of TUM's RGB-D benchmark, one folder for each sequence: `rgb/TIME.png`, `depth/TIME.png` in 1/5000 m, `rgb.txt`, `depth.txt`,
/// `associations.txt` and `groundtruth.txt`; the intrinsics and the lens, for which the benchmark has no file, are in
/// `camera.json`.
#[derive(Debug, Default)]
pub(super) struct Tum;

impl Format for Tum {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let view = shot
            .view
            .as_ref()
            .ok_or_else(|| missing(NAME, "the camera of each frame"))?;
        let depths = Depths::of(shot);
        depths.main.ok_or_else(|| missing(NAME, "depth"))?;
        let (folder, time) = (sequence_folder(shot), seconds(shot.time_ns));
        let mut frame = FrameFiles::default();
        if let Some(rgb) = &shot.frame.rgb {
            frame.add_rgb(folder.join(format!("rgb/{time}.png")), rgb);
        }
        let file = format!("{time}.png");
        frame.add_depths(&depths, PER_METRE, |kind| folder.join(kind).join(&file));
        frame.write(output)?;
        let pose = &view.world_from_camera;
        let [x, y, z] = pose.translation.to_array();
        let [qx, qy, qz, qw] = quaternion(&pose.rotation);
        let size = view.camera.intrinsics.size;
        let mut record = json!({
            "folder": folder.to_string_lossy(),
            "time": time,
            "rgb": shot.frame.rgb.is_some(),
            "pose": format!("{time} {x:.9} {y:.9} {z:.9} {qx:.12} {qy:.12} {qz:.12} {qw:.12}"),
            "camera": {
                "width": size.width, "height": size.height, "camera_matrix": camera_matrix(&view.camera.intrinsics),
                "distortion": distortion(&view.camera.lens), "depth_per_metre": PER_METRE,
            },
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
            let folder = PathBuf::from(folder);
            for (name, header, lines) in [
                ("rgb.txt", "# timestamp filename", &sequence.rgb),
                ("depth.txt", "# timestamp filename", &sequence.depth),
                (
                    "associations.txt",
                    "# timestamp depth timestamp rgb",
                    &sequence.pairs,
                ),
                (
                    "groundtruth.txt",
                    "# timestamp tx ty tz qx qy qz qw",
                    &sequence.poses,
                ),
            ] {
                let text = format!("{header}\n{lines}");
                output.write(&folder.join(name), text.as_bytes())?;
            }
            output.write(&folder.join("camera.json"), &files::encode(&sequence.camera))?;
        }
        summary.finish(NAME, 13.107, output)
    }
}

/// The lines of a sequence's files.
#[derive(Default)]
struct Sequence {
    rgb: String,
    depth: String,
    pairs: String,
    poses: String,
    camera: Value,
}

impl Sequence {
    fn add(&mut self, record: &Value) {
        let time = text(record, "time");
        self.depth += &format!("{time} depth/{time}.png\n");
        if record["rgb"] == true {
            self.rgb += &format!("{time} rgb/{time}.png\n");
            self.pairs += &format!("{time} depth/{time}.png {time} rgb/{time}.png\n");
        }
        self.poses += &format!("{}\n", text(record, "pose"));
        self.camera = record["camera"].clone();
    }
}
