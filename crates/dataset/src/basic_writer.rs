use oaktwin_image::annotation::Annotator;
use oaktwin_image::png;
use serde_json::json;

use crate::file::DatasetFile;
use crate::listing::Files;
use crate::segmentation::{self, Kind};
use crate::{Options, Shot, json, normals};

/// The layout of Replicator's `BasicWriter` 0.0.2: names, types, shapes and keys.
///
/// # Extensions
/// What [`Extras`](crate::Extras) asks for has names that `BasicWriter` never writes (with `colorize_depth` it puts a grey
/// `distance_to_image_plane_0000.png` beside the array):
///
/// | file | what |
/// |---|---|
/// | `distance_to_image_plane_millimetres_0000.png` | 16-bit grey, see [`from_metres`](oaktwin_image::millimetres::from_metres) |
/// | `distance_to_image_plane_0000.exr` | `float32`, see [`exr`](oaktwin_image::exr) |
/// | `distance_to_image_plane_preview_0000.png` | a picture for people, see [`preview`](oaktwin_image::preview) |
/// | `pointcloud_0000.ply` | the point cloud with its normals and colours, scene units |
///
/// and the first three for `distance_to_camera` and `depth_sensor_distance` too. What a depth sensor reports, for which
/// `BasicWriter` has no files, has the names of Isaac Sim 6's annotators:
///
/// | file | what |
/// |---|---|
/// | `depth_sensor_distance_0000.npy` | `float32` (H, W), metres, 0 where nothing was measured |
/// | `depth_sensor_point_cloud_position_0000.npy` | `float32` (H, W, 4), see [`Frame`](oaktwin_image::annotation::Frame) |
/// | `depth_sensor_point_cloud_color_0000.npy` | `uint8` (H, W, 4) |
/// | `depth_sensor_imager_0000.npy` | `float32` (H, W) |
/// | `depth_sensor_output_visualization_0000.png` | RGBA |
/// | `depth_sensor_point_cloud_0000.ply` | an extra: the measured points, with their colours where those are there |
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BasicWriter {
    options: Options,
}

impl BasicWriter {
    /// A writer.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self { options }
    }

    /// `metadata.txt`, one for a data set. The colon within the key of the seed is `BasicWriter`'s own.
    #[must_use]
    pub fn metadata(&self) -> DatasetFile<'static> {
        let seed = self.options.seed;
        DatasetFile::new("metadata.txt".into(), move || {
            Ok(json::encode(&json!({
                "name": "BasicWriter",
                "version": "0.0.2",
                "replicator_global_seed:": seed,
            })))
        })
    }

    /// The files of one camera's frame.
    #[must_use]
    pub fn files<'a>(&self, shot: &Shot<'a>) -> Vec<DatasetFile<'a>> {
        let frame = shot.frame;
        let mut files = Files {
            options: self.options,
            shot: *shot,
            list: Vec::new(),
        };
        if let Some(rgb) = &frame.rgb {
            files.push(Annotator::Rgb, "rgb", "png", move || Ok(png::encode(rgb)?));
        }
        if let Some(depth) = &frame.distance_to_image_plane {
            files.push_depth(Annotator::DistanceToImagePlane, &depth.0);
        }
        if let Some(depth) = &frame.distance_to_camera {
            files.push_depth(Annotator::DistanceToCamera, &depth.0);
        }
        if let Some(image) = &frame.normals {
            files.push(Annotator::Normals, "normals", "png", move || {
                Ok(png::encode(&normals::colorize(image))?)
            });
        }
        if let Some(segmentation) = &frame.instance_id_segmentation {
            let colorized = self.options.colorize_instance_id_segmentation;
            let (annotator, kind) = (Annotator::InstanceIdSegmentation, Kind::InstanceId);
            files.push_ids(annotator, kind, &segmentation.ids, colorized);
            files.push(annotator, "instance_id_segmentation_mapping", "json", move || {
                Ok(json::encode(&segmentation::legend(
                    kind,
                    &segmentation.prim_paths,
                    colorized,
                )))
            });
        }
        if let Some(segmentation) = &frame.semantic_segmentation {
            let colorized = self.options.colorize_semantic_segmentation;
            let (annotator, kind) = (Annotator::SemanticSegmentation, Kind::Semantic);
            files.push_ids(annotator, kind, &segmentation.ids, colorized);
            files.push(annotator, "semantic_segmentation_labels", "json", move || {
                Ok(json::encode(&segmentation::legend(
                    kind,
                    &segmentation.labels,
                    colorized,
                )))
            });
        }
        if let Some(boxes) = &frame.bounding_box_2d_tight {
            files.push_boxes(Annotator::BoundingBox2dTight, boxes);
        }
        if let Some(boxes) = &frame.bounding_box_2d_loose {
            files.push_boxes(Annotator::BoundingBox2dLoose, boxes);
        }
        if let Some(cloud) = &frame.pointcloud {
            files.push_cloud(cloud);
        }
        files.push_depth_sensor();
        if let Some(params) = shot.camera_params {
            files.push(Annotator::CameraParams, "camera_params", "json", move || {
                Ok(json::encode(params))
            });
        }
        files.list
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::Extras;
    use oaktwin_image::annotation::{
        Box2d, Boxes2d, Frame, Labels, PointCloud, Segmentation, SemanticSegmentation,
    };
    use oaktwin_image::{Image, RangeDepth, ZDepth, npy, ply};

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
        }
    }

    fn paths(options: Options, render_product: Option<&str>, frame: &Frame) -> Vec<String> {
        let shot = Shot {
            frame,
            camera_params: None,
            number: 12,
            render_product,
        };
        let files = BasicWriter::new(options).files(&shot);
        files.iter().map(|file| file.path().to_owned()).collect()
    }

    #[test]
    fn one_camera_lies_flat() {
        assert_eq!(
            paths(Options::default(), None, &frame()),
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
            ]
        );
        assert_eq!(paths(Options::default(), None, &Frame::default()), [""; 0]);
    }

    #[test]
    fn several_have_a_folder_each() {
        let options = Options {
            frame_padding: 1,
            ..Options::default()
        };
        let only_boxes = Frame {
            bounding_box_2d_tight: frame().bounding_box_2d_tight,
            ..Frame::default()
        };
        assert_eq!(
            paths(options, Some("Camera left"), &only_boxes),
            [
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_12.npy",
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_labels_12.json",
                "Camera_left/bounding_box_2d_tight/bounding_box_2d_tight_prim_paths_12.json",
            ]
        );
    }

    #[test]
    fn extras_have_names_of_their_own() {
        let options = Options {
            extras: Extras {
                millimetres: true,
                exr: true,
                preview: true,
                ply: true,
            },
            ..Options::default()
        };
        let frame = frame();
        let plain = paths(Options::default(), None, &frame);
        let extra: Vec<String> = paths(options, None, &frame)
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
        let shot = Shot {
            frame: &frame,
            camera_params: None,
            number: 0,
            render_product: None,
        };
        for file in BasicWriter::new(options).files(&shot) {
            let bytes = file.bytes().unwrap();
            assert!(!bytes.is_empty());
            assert_eq!(file.bytes().unwrap(), bytes, "{file:?}");
        }
    }

    #[test]
    fn what_the_files_say() {
        let frame = frame();
        let shot = Shot {
            frame: &frame,
            camera_params: None,
            number: 0,
            render_product: None,
        };
        let writer = BasicWriter::default();
        let files = writer.files(&shot);
        let bytes = |path: &str| {
            files
                .iter()
                .find(|file| file.path() == path)
                .unwrap()
                .bytes()
                .unwrap()
        };
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
        assert_eq!(
            writer.metadata().bytes().unwrap(),
            br#"{"name": "BasicWriter", "version": "0.0.2", "replicator_global_seed:": 0}"#
        );
    }

    #[test]
    fn a_cloud_has_what_was_measured() {
        let frame = frame();
        let shot = Shot {
            frame: &frame,
            camera_params: None,
            number: 0,
            render_product: None,
        };
        let options = Options {
            extras: Extras {
                ply: true,
                ..Extras::default()
            },
            ..Options::default()
        };
        let files = BasicWriter::new(options).files(&shot);
        let cloud = files
            .iter()
            .find(|file| file.path() == "depth_sensor_point_cloud_0000.ply");
        let expected = ply::encode(&ply::Cloud {
            points: &[[0.5, 0.25, -1.25]],
            normals: None,
            rgb: Some(&[[7, 8, 9, 255]]),
        });
        assert_eq!(cloud.unwrap().bytes().unwrap(), expected.unwrap());
    }

    #[test]
    fn ids_that_do_not_fit_are_an_error() {
        let frame = frame();
        let shot = Shot {
            frame: &frame,
            camera_params: None,
            number: 0,
            render_product: None,
        };
        let options = Options {
            colorize_instance_id_segmentation: false,
            ..Options::default()
        };
        let files = BasicWriter::new(options).files(&shot);
        let file = files
            .iter()
            .find(|file| file.path() == "instance_id_segmentation_0000.png");
        assert_eq!(
            file.unwrap().bytes().unwrap_err().to_string(),
            "instance_id_segmentation_0000.png: the id 70000 does not fit in 16 bits; leave the segmentation \
             colorized, which holds any number of ids"
        );
    }
}
