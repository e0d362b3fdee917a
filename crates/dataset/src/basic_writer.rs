use oaktwin_image::annotation::{Annotator, Boxes2d, Frame, PointCloud};
use oaktwin_image::{Image, exr, millimetres, npy, ply, png, preview};
use serde_json::json;

use crate::file::DatasetFile;
use crate::segmentation::{self, Kind};
use crate::{CameraParams, boxes, cloud, json, normals};

/// The layout of Replicator's `BasicWriter` 0.0.2: names, types, shapes and keys.
///
/// # Extensions
/// What [`Extras`] asks for has names that `BasicWriter` never writes (with `colorize_depth` it puts a grey
/// `distance_to_image_plane_0000.png` beside the array):
///
/// | file | what |
/// |---|---|
/// | `distance_to_image_plane_millimetres_0000.png` | 16-bit grey, see [`millimetres::from_metres`] |
/// | `distance_to_image_plane_0000.exr` | `float32`, see [`exr`] |
/// | `distance_to_image_plane_preview_0000.png` | a picture for people, see [`preview`] |
/// | `pointcloud_0000.ply` | the point cloud with its normals and colours, scene units |
///
/// and the first three for `distance_to_camera` too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BasicWriter {
    options: Options,
}

/// The arguments of `BasicWriter` that matter here, and what is written beside its own files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// Digits of the frame's number.
    pub frame_padding: usize,
    /// Semantic segmentation as colours, or as ids in 16 bits.
    pub colorize_semantic_segmentation: bool,
    /// Instance id segmentation as colours, or as ids in 16 bits.
    pub colorize_instance_id_segmentation: bool,
    /// The seed that `metadata.txt` names; nothing here is random.
    pub seed: u64,
    /// What is written beside `BasicWriter`'s own files.
    pub extras: Extras,
}

impl Default for Options {
    /// `BasicWriter`'s defaults, and no extras.
    fn default() -> Self {
        Self {
            frame_padding: 4,
            colorize_semantic_segmentation: true,
            colorize_instance_id_segmentation: true,
            seed: 0,
            extras: Extras::default(),
        }
    }
}

/// Files beside `BasicWriter`'s own: see [`BasicWriter`] for their names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "each is a file")]
pub struct Extras {
    /// Depth as 16-bit PNG in millimetres.
    pub millimetres: bool,
    /// Depth as `OpenEXR`.
    pub exr: bool,
    /// Depth as a picture for people.
    pub preview: bool,
    /// The point cloud as PLY.
    pub ply: bool,
}

/// One camera's frame, to be written.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    /// The annotations; those that are there are written.
    pub frame: &'a Frame,
    /// The camera, where `camera_params` is asked for.
    pub camera_params: Option<&'a CameraParams>,
    /// The frame's number, from 0.
    pub number: u64,
    /// The render product's name where several cameras are written, each into a folder of its own; `None` for one
    /// camera, whose files lie flat. It is one folder's name: other characters than letters, digits, `_`, `-` and `.`
    /// become `_`.
    pub render_product: Option<&'a str>,
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
        if let Some(params) = shot.camera_params {
            files.push(Annotator::CameraParams, "camera_params", "json", move || {
                Ok(json::encode(params))
            });
        }
        files.list
    }
}

/// The files of one shot, being listed.
struct Files<'a> {
    options: Options,
    shot: Shot<'a>,
    list: Vec<DatasetFile<'a>>,
}

impl<'a> Files<'a> {
    fn push(
        &mut self,
        annotator: Annotator,
        stem: &str,
        extension: &str,
        encode: impl Fn() -> Result<Vec<u8>, crate::file::Fault> + Send + Sync + 'a,
    ) {
        let (number, padding) = (self.shot.number, self.options.frame_padding);
        let file = format!("{stem}_{number:0padding$}.{extension}");
        let path = match self.shot.render_product {
            None => file,
            Some(product) => format!("{}/{}/{file}", folder(product), annotator.name()),
        };
        self.list.push(DatasetFile::new(path, encode));
    }

    /// The array of a depth image, and what is asked for beside it.
    fn push_depth(&mut self, annotator: Annotator, metres: &'a Image<f32>) {
        let stem = annotator.name();
        let extras = self.options.extras;
        self.push(annotator, stem, "npy", move || {
            let shape = [metres.height() as usize, metres.width() as usize];
            Ok(npy::encode(&shape, metres.pixels())?)
        });
        if extras.millimetres {
            self.push(annotator, &format!("{stem}_millimetres"), "png", move || {
                Ok(png::encode(&millimetres::from_metres(metres))?)
            });
        }
        if extras.exr {
            self.push(annotator, stem, "exr", move || Ok(exr::encode(metres)?));
        }
        if extras.preview {
            self.push(annotator, &format!("{stem}_preview"), "png", move || {
                let picture = preview::depth(metres, &preview::Options::default());
                Ok(png::encode(&picture)?)
            });
        }
    }

    fn push_ids(&mut self, annotator: Annotator, kind: Kind, ids: &'a Image<u32>, colorized: bool) {
        self.push(annotator, annotator.name(), "png", move || {
            Ok(if colorized {
                png::encode(&segmentation::colorize(kind, ids))?
            } else {
                png::encode(&segmentation::grey(ids)?)?
            })
        });
    }

    fn push_boxes(&mut self, annotator: Annotator, boxes: &'a Boxes2d) {
        let stem = annotator.name();
        self.push(annotator, stem, "npy", move || boxes::encode(boxes));
        self.push(annotator, &format!("{stem}_labels"), "json", move || {
            Ok(json::encode(&boxes.labels))
        });
        self.push(annotator, &format!("{stem}_prim_paths"), "json", move || {
            Ok(json::encode(&boxes.prim_paths))
        });
    }

    /// The arrays of a cloud that are there: every one, where it has no points.
    fn push_cloud(&mut self, cloud: &'a PointCloud) {
        let annotator = Annotator::Pointcloud;
        let all = cloud.points.is_empty();
        let given = move |length: usize| all || length > 0;
        self.push(annotator, "pointcloud", "npy", move || {
            cloud::points(&cloud.points)
        });
        if given(cloud.rgb.len()) {
            self.push(annotator, "pointcloud_rgb", "npy", move || cloud::rgb(&cloud.rgb));
        }
        if given(cloud.normals.len()) {
            self.push(annotator, "pointcloud_normals", "npy", move || {
                cloud::normals(&cloud.normals)
            });
        }
        if given(cloud.semantic.len()) {
            self.push(annotator, "pointcloud_semantic", "npy", move || {
                cloud::ids(&cloud.semantic)
            });
        }
        if given(cloud.instance.len()) {
            self.push(annotator, "pointcloud_instance", "npy", move || {
                cloud::ids(&cloud.instance)
            });
        }
        if self.options.extras.ply {
            self.push(annotator, "pointcloud", "ply", move || {
                Ok(ply::encode(&ply::Cloud {
                    points: &cloud.points,
                    normals: given(cloud.normals.len()).then_some(&cloud.normals),
                    rgb: given(cloud.rgb.len()).then_some(&cloud.rgb),
                })?)
            });
        }
    }
}

/// A name as one folder's.
fn folder(name: &str) -> String {
    let kept = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '.');
    let name: String = name.chars().map(|c| if kept(c) { c } else { '_' }).collect();
    // Neither this folder nor the one above, nor none at all.
    if name.trim_matches('.').is_empty() {
        return "_".repeat(name.len().max(1));
    }
    name
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use oaktwin_image::annotation::{Box2d, Labels, Segmentation, SemanticSegmentation};
    use oaktwin_image::{RangeDepth, ZDepth};

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
        assert_eq!(
            ["..", "", "a/../b", "C:\\x"].map(folder),
            ["__", "_", "a_.._b", "C__x"]
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
        let depth = npy::decode(&bytes("distance_to_image_plane_0000.npy")).unwrap();
        assert_eq!(depth.shape, [1, 2]);
        assert_eq!(
            writer.metadata().bytes().unwrap(),
            br#"{"name": "BasicWriter", "version": "0.0.2", "replicator_global_seed:": 0}"#
        );
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
