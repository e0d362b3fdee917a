use std::path::PathBuf;
use std::sync::OnceLock;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use crate::file::write_all;
use crate::listing::list;
use crate::{Format, Records, Shot, WriteError, WriterOptions, json};

/// The file that describes the whole data set.
const METADATA: &str = "metadata.txt";

/// The layout of Replicator's `BasicWriter` 0.0.2: names, types, shapes and keys.
///
/// # Extensions
/// The files of [`Extras`](crate::Extras) have names that `BasicWriter` never uses (its `colorize_depth` writes a grey
/// `distance_to_image_plane_0000.png` beside the array):
///
/// | file | contents |
/// |---|---|
/// | `distance_to_image_plane_millimetres_0000.png` | 16-bit grey, see [`from_metres`](oaktwin_image::millimetres::from_metres) |
/// | `distance_to_image_plane_0000.exr` | `float32`, see [`exr`](oaktwin_image::exr) |
/// | `distance_to_image_plane_preview_0000.png` | a colour-mapped image, see [`preview`](oaktwin_image::preview) |
/// | `pointcloud_0000.ply` | the point cloud with its normals and colours, scene units |
///
/// and the first three also for `distance_to_camera` and `depth_sensor_distance`. Sensor outputs, for which `BasicWriter` has no
/// files, have the names of Isaac Sim 6's annotators:
///
/// | file | contents |
/// |---|---|
/// | `depth_sensor_distance_0000.npy` | `float32` (H, W), metres, 0 where nothing was measured |
/// | `depth_sensor_point_cloud_position_0000.npy` | `float32` (H, W, 4), see [`Frame`](oaktwin_image::annotation::Frame) |
/// | `depth_sensor_point_cloud_color_0000.npy` | `uint8` (H, W, 4) |
/// | `depth_sensor_imager_0000.npy` | `float32` (H, W) |
/// | `depth_sensor_output_visualization_0000.png` | RGBA |
/// | `depth_sensor_reason_0000.png` | 8-bit grey: codes |
/// | `depth_sensor_reason_legend_0000.json` | the name and the meaning of each code |
/// | `depth_sensor_confidence_0000.png` | 16-bit grey |
/// | `depth_sensor_point_cloud_0000.ply` | an extra: the measured points, with their colours if those are rendered |
#[derive(Clone, Debug, Default)]
pub struct BasicWriter {
    options: WriterOptions,
    has_metadata: OnceLock<()>,
}

impl BasicWriter {
    /// Creates a writer.
    #[must_use]
    pub fn new(options: WriterOptions) -> Self {
        Self {
            options,
            has_metadata: OnceLock::new(),
        }
    }

    /// Writes the file that describes the whole data set once, without listing it among the files of a frame.
    fn write_metadata(&self, output: &mut OutputFiles) -> Result<(), WriteError> {
        if self.has_metadata.set(()).is_err() {
            return Ok(());
        }
        // The colon within the last key is `BasicWriter`'s own.
        let metadata = json::encode(&json!({
            "name": "BasicWriter",
            "version": "0.0.2",
            "replicator_global_seed:": self.options.seed,
        }));
        output.write(METADATA.as_ref(), &metadata)?;
        output.forget(METADATA.as_ref());
        Ok(())
    }

    fn path(&self, shot: &Shot, annotator: &str, name: &str, extension: &str) -> PathBuf {
        let (number, padding) = (shot.number, self.options.frame_padding);
        let file = format!("{name}_{number:0padding$}.{extension}");
        match &shot.render_product {
            None => file.into(),
            Some(product) => [&folder(product), annotator, &file].iter().collect(),
        }
    }
}

impl Format for BasicWriter {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        self.write_metadata(output)?;
        let files = list(shot, &self.options).into_iter();
        let files = files.map(|file| (self.path(shot, file.folder, &file.name, file.extension), file));
        write_all(&files.collect::<Vec<_>>(), output)?;
        Ok(Value::Null)
    }

    fn finish(
        &self,
        _records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        self.write_metadata(output)?;
        output.list(METADATA.as_ref())?;
        Ok(Vec::new())
    }
}

/// A name as the name of a single folder.
pub(crate) fn folder(name: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let name: String = name.chars().map(|c| if kept(c) { c } else { '_' }).collect();
    // Neither `.`, `..` nor an empty name.
    if name.trim_matches('.').is_empty() {
        return "_".repeat(name.len().max(1));
    }
    name
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;
    use std::path::Path;

    use super::*;
    use crate::{Extras, FormatWriter, Writer};
    use oaktwin_image::annotation::{
        Box2d, Boxes2d, Frame, Labels, PointCloud, ReasonLabel, Reasons, Segmentation, SemanticSegmentation,
    };
    use oaktwin_image::{Image, RangeDepth, ZDepth, npy, ply, png};

    fn label(name: &str) -> ReasonLabel {
        ReasonLabel {
            name: name.to_owned(),
            documentation: "A sentence.".to_owned(),
        }
    }

    fn frame() -> Frame {
        let depth = Image::new(2, 1, vec![1.5f32, f32::INFINITY]).unwrap();
        let labels: BTreeMap<u32, Labels> = [(2, Labels::from([("class".into(), "cup".into())]))].into();
        let boxes = Boxes2d {
            boxes: vec![Box2d {
                semantic_id: 2,
                x_min: 0,
                y_min: 0,
                x_max: 0,
                y_max: 0,
                occlusion_ratio: 0.0,
            }],
            prim_paths: vec!["/World/Cup".into()],
            labels: labels.clone(),
        };
        Frame {
            apparent_depth: None,
            light: None,
            returns: None,
            infrared: None,
            radial_velocities: None,
            rgb: Some(Image::filled(2, 1, [1, 2, 3, 255])),
            distance_to_image_plane: Some(ZDepth(depth.clone())),
            distance_to_camera: Some(RangeDepth(depth)),
            normals: Some(Image::filled(2, 1, [0.0, 0.0, 1.0])),
            instance_id_segmentation: Some(Segmentation {
                ids: Image::new(2, 1, vec![70_000, 0]).unwrap(),
                prim_paths: [(70_000, "/World/Cup".into())].into(),
            }),
            semantic_segmentation: Some(SemanticSegmentation {
                ids: Image::new(2, 1, vec![2, 0]).unwrap(),
                labels,
            }),
            bounding_box_2d_tight: Some(boxes.clone()),
            bounding_box_2d_loose: Some(boxes),
            pointcloud: Some(PointCloud {
                points: vec![[0.0, 0.0, 1.5]],
                normals: vec![[0.0, 0.0, 1.0]],
                rgb: vec![[1, 2, 3, 255]],
                semantic: vec![2],
                instance: vec![1],
            }),
            depth_sensor_distance: Some(ZDepth(Image::new(2, 1, vec![0.0, 1.25]).unwrap())),
            depth_sensor_point_cloud_position: Some(
                Image::new(2, 1, vec![[0.0; 4], [0.5, 0.25, -1.25, 1.0]]).unwrap(),
            ),
            depth_sensor_point_cloud_color: Some(Image::new(2, 1, vec![[0; 4], [7, 8, 9, 255]]).unwrap()),
            depth_sensor_imager: Some(Image::filled(2, 1, 0.5)),
            depth_sensor_output_visualization: Some(Image::filled(2, 1, [4, 5, 6, 255])),
            depth_sensor_reason: Some(Reasons {
                codes: Image::new(2, 1, vec![2, 0]).unwrap(),
                legend: [(2, label("too_near"))].into(),
            }),
            depth_sensor_confidence: Some(Image::new(2, 1, vec![0, 300]).unwrap()),
        }
    }

    /// The paths and bytes of a shot's files, without `metadata.txt`.
    fn written(options: WriterOptions, shot: &Shot) -> Vec<(String, Vec<u8>)> {
        let folder = tempfile::tempdir().unwrap();
        let mut output = OutputFiles::in_folder(folder.path()).unwrap();
        BasicWriter::new(options).frame(shot, &mut output).unwrap();
        let name = |path: &Path| path.strip_prefix(folder.path()).unwrap().display().to_string();
        let files = output.files().iter();
        let files = files.map(|file| (name(&file.path), fs::read(&file.path).unwrap()));
        files.filter(|(name, _)| name != "metadata.txt").collect()
    }

    fn paths(options: WriterOptions, render_product: Option<&str>, frame: Frame) -> Vec<String> {
        let shot = Shot {
            render_product: render_product.map(str::to_owned),
            ..Shot::new(frame, 12)
        };
        let files = written(options, &shot);
        files.into_iter().map(|(path, _)| path).collect()
    }

    #[test]
    fn a_single_camera_has_no_folder() {
        assert_eq!(
            paths(WriterOptions::default(), None, frame()),
            [
                "rgb_0012.png",
                "distance_to_image_plane_0012.npy",
                "distance_to_camera_0012.npy",
                "normals_0012.png",
                "instance_id_segmentation_0012.png",
                "instance_id_segmentation_mapping_0012.json",
                "semantic_segmentation_0012.png",
                "semantic_segmentation_labels_0012.json",
                "bounding_box_2d_tight_0012.npy",
                "bounding_box_2d_tight_labels_0012.json",
                "bounding_box_2d_tight_prim_paths_0012.json",
                "bounding_box_2d_loose_0012.npy",
                "bounding_box_2d_loose_labels_0012.json",
                "bounding_box_2d_loose_prim_paths_0012.json",
                "pointcloud_0012.npy",
                "pointcloud_rgb_0012.npy",
                "pointcloud_normals_0012.npy",
                "pointcloud_semantic_0012.npy",
                "pointcloud_instance_0012.npy",
                "depth_sensor_distance_0012.npy",
                "depth_sensor_point_cloud_position_0012.npy",
                "depth_sensor_point_cloud_color_0012.npy",
                "depth_sensor_imager_0012.npy",
                "depth_sensor_output_visualization_0012.png",
                "depth_sensor_reason_0012.png",
                "depth_sensor_reason_legend_0012.json",
                "depth_sensor_confidence_0012.png",
            ]
        );
        assert_eq!(paths(WriterOptions::default(), None, Frame::default()), [""; 0]);
    }

    #[test]
    fn several_cameras_have_folders() {
        let options = WriterOptions {
            frame_padding: 1,
            ..WriterOptions::default()
        };
        let only_boxes = Frame {
            bounding_box_2d_tight: frame().bounding_box_2d_tight,
            ..Frame::default()
        };
        assert_eq!(
            paths(options, Some("Camera left"), only_boxes),
            [
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_12.npy",
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_labels_12.json",
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_prim_paths_12.json",
            ]
        );
    }

    #[test]
    fn extras_have_their_own_names() {
        let options = WriterOptions {
            extras: Extras {
                millimetres: true,
                exr: true,
                preview: true,
                ply: true,
            },
            ..WriterOptions::default()
        };
        let frame = frame();
        let plain = paths(WriterOptions::default(), None, frame.clone());
        let extra: Vec<String> = paths(options, None, frame.clone())
            .into_iter()
            .filter(|path| !plain.contains(path))
            .collect();
        assert_eq!(
            extra,
            [
                "distance_to_image_plane_millimetres_0012.png",
                "distance_to_image_plane_0012.exr",
                "distance_to_image_plane_preview_0012.png",
                "distance_to_camera_millimetres_0012.png",
                "distance_to_camera_0012.exr",
                "distance_to_camera_preview_0012.png",
                "pointcloud_0012.ply",
                "depth_sensor_distance_millimetres_0012.png",
                "depth_sensor_distance_0012.exr",
                "depth_sensor_distance_preview_0012.png",
                "depth_sensor_point_cloud_0012.ply",
            ]
        );
        let shot = Shot::new(frame, 0);
        let files = written(options, &shot);
        assert!(files.iter().all(|(_, bytes)| !bytes.is_empty()));
        assert_eq!(written(options, &shot), files);
    }

    #[test]
    fn encodes_labels_and_arrays() {
        let files = written(WriterOptions::default(), &Shot::new(frame(), 0));
        let bytes = |path: &str| files.iter().find(|(name, _)| name == path).unwrap().1.clone();
        let text = |path: &str| String::from_utf8(bytes(path)).unwrap();
        assert_eq!(
            text("bounding_box_2d_tight_labels_0000.json"),
            r#"{"2": {"class": "cup"}}"#
        );
        assert_eq!(
            text("bounding_box_2d_tight_prim_paths_0000.json"),
            r#"["/World/Cup"]"#
        );
        assert_eq!(
            text("semantic_segmentation_labels_0000.json"),
            r#"{"(0, 0, 0, 0)": {"class": "BACKGROUND"}, "(0, 0, 0, 255)": {"class": "UNLABELLED"}, "(255, 25, 25, 255)": {"class": "cup"}}"#
        );
        assert_eq!(
            text("depth_sensor_reason_legend_0000.json"),
            r#"{"2": {"name": "too_near", "documentation": "A sentence."}}"#
        );
        let codes = png::decode::<u8>(&bytes("depth_sensor_reason_0000.png")).unwrap();
        assert_eq!(codes.pixels(), [2, 0]);
        let confidence = png::decode::<u16>(&bytes("depth_sensor_confidence_0000.png")).unwrap();
        assert_eq!(confidence.pixels(), [0, 300]);
        let semantic = png::decode::<[u8; 4]>(&bytes("semantic_segmentation_0000.png")).unwrap();
        assert_eq!(semantic.pixels(), [[255, 25, 25, 255], [0; 4]]);
        for (name, shape) in [
            ("distance_to_image_plane", &[1, 2][..]),
            ("depth_sensor_distance", &[1, 2]),
            ("depth_sensor_point_cloud_position", &[1, 2, 4]),
            ("depth_sensor_point_cloud_color", &[1, 2, 4]),
            ("depth_sensor_imager", &[1, 2]),
        ] {
            let array = npy::decode(&bytes(&format!("{name}_0000.npy"))).unwrap();
            assert_eq!(array.shape, shape, "{name}");
        }
    }

    #[test]
    fn writes_metadata_once() {
        let folder = tempfile::tempdir().unwrap();
        let mut output = OutputFiles::in_folder(folder.path()).unwrap();
        let mut writer = FormatWriter::new(Box::new(BasicWriter::default()));
        for number in 0..2 {
            writer
                .write(&Shot::new(Frame::default(), number), &mut output)
                .unwrap();
        }
        writer.finish(&mut output).unwrap();
        assert_eq!(output.files().len(), 1);
        assert_eq!(
            fs::read(folder.path().join("metadata.txt")).unwrap(),
            br#"{"name": "BasicWriter", "version": "0.0.2", "replicator_global_seed:": 0}"#
        );
    }

    #[test]
    fn clouds_contain_the_measured_points() {
        let options = WriterOptions {
            extras: Extras {
                ply: true,
                ..Extras::default()
            },
            ..WriterOptions::default()
        };
        let files = written(options, &Shot::new(frame(), 0));
        let cloud = files
            .iter()
            .find(|(path, _)| path == "depth_sensor_point_cloud_0000.ply");
        let expected = ply::encode(&ply::Cloud {
            points: &[[0.5, 0.25, -1.25]],
            normals: None,
            rgb: Some(&[[7, 8, 9, 255]]),
        });
        assert_eq!(cloud.unwrap().1, expected.unwrap());
    }

    #[test]
    fn rejects_ids_above_16_bits() {
        let options = WriterOptions {
            colorize_instance_id_segmentation: false,
            ..WriterOptions::default()
        };
        let folder = tempfile::tempdir().unwrap();
        let mut output = OutputFiles::in_folder(folder.path()).unwrap();
        let error = BasicWriter::new(options)
            .frame(&Shot::new(frame(), 0), &mut output)
            .unwrap_err();
        assert_eq!(
            error.to_string(),
            "instance_id_segmentation_0000.png: the id 70000 does not fit in 16 bits; leave the segmentation \
             colorized, which holds any number of ids"
        );
    }

    #[test]
    fn cleans_folder_names() {
        assert_eq!(
            ["..", "", "a/../b", "C:\\x"].map(folder),
            ["__", "_", "a_.._b", "C__x"]
        );
    }
}
