use std::path::PathBuf;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{RigidTransform, Usd};
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use super::common::{Depths, FrameFiles, by_folder, matrix, rgb, sequence_folder};
use super::lens::{Lens, lens};
use crate::{Format, Records, Shot, WriteError, json as files};

const NAME: &str = "nerfstudio";
const PER_METRE: f32 = 1000.0;

/// nerfstudio's `transforms.json`, one folder for each sequence, with `images/` and `depth/` in millimetres. Cameras have OpenGL's axes, and the
/// centre of the first pixel is at 0.5. Each frame has the terms of its lens.
#[derive(Debug, Default)]
pub(super) struct Nerfstudio;

impl Format for Nerfstudio {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let (view, lens) = lens(NAME, shot, 3)?;
        let rgb = rgb(NAME, shot)?;
        let depths = Depths::of(shot);
        let (folder, number) = (sequence_folder(shot), shot.number);
        let image = format!("images/{number:06}.png");
        let mut frame = FrameFiles::default();
        frame.add_rgb(folder.join(&image), rgb);
        let mut record = json!({"file_path": image});
        let file = format!("{number:06}.png");
        frame.add_depths(&depths, PER_METRE, |kind| folder.join(kind).join(&file));
        if depths.main.is_some() {
            record["depth_file_path"] = format!("depth/{file}").into();
        }
        frame.write(output)?;
        // From OpenGL's axes to OpenCV's.
        let flip = RigidTransform::new(DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0)), DVec3::ZERO);
        record["transform_matrix"] = json!(matrix(&(view.world_from_camera * flip)));
        let intrinsics = &view.camera.intrinsics;
        let center = intrinsics.principal_point::<Usd>();
        for (name, value) in [
            ("fl_x", intrinsics.fx),
            ("fl_y", intrinsics.fy),
            ("cx", center.x),
            ("cy", center.y),
        ] {
            record[name] = value.into();
        }
        let (model, terms) = match lens {
            Lens::Pinhole => ("OPENCV", [0.0; 6]),
            Lens::Radial { k, p } => ("OPENCV", [k[0], k[1], k[2], 0.0, p[0], p[1]]),
            Lens::Fisheye([k1, k2, k3, k4]) => ("OPENCV_FISHEYE", [k1, k2, k3, k4, 0.0, 0.0]),
        };
        for (name, term) in ["k1", "k2", "k3", "k4", "p1", "p2"].into_iter().zip(terms) {
            record[name] = term.into();
        }
        record["w"] = intrinsics.size.width.into();
        record["h"] = intrinsics.size.height.into();
        let mut record = json!({"folder": folder.to_string_lossy(), "model": model, "frame": record});
        depths.add_losses(PER_METRE, &mut record);
        Ok(record)
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        let add = |(model, frames): &mut (Value, Vec<Value>), record: &Value| {
            record["model"].clone_into(model);
            frames.push(record["frame"].clone());
        };
        let (sequences, summary) = by_folder(records, add)?;
        for (folder, (model, frames)) in sequences {
            let transforms = json!({
                "camera_model": model,
                "depth_unit_scale_factor": 0.001,
                "frames": frames,
            });
            output.write(
                &PathBuf::from(folder).join("transforms.json"),
                &files::encode(&transforms),
            )?;
        }
        summary.finish(NAME, 65.535, output)
    }
}
