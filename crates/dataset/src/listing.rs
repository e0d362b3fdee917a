use std::collections::BTreeMap;

use oaktwin_image::annotation::{
    AnnotationRef, Annotator, Boxes2d, Frame, PointCloud, ReasonLabel, Reasons, Segmentation,
    SemanticSegmentation,
};
use oaktwin_image::npy::NpyElement;
use oaktwin_image::{Image, exr, millimetres, ply, png, preview};
use serde::Serialize;
use serde_json::{Value, json};

use crate::file::{Array, Content, DatasetFile, Fault};
use crate::segmentation::{self, IdKind};
use crate::{Extras, LayerData, Shot, WriterOptions, boxes, cloud, json, normals};

/// The name of the parameters of the depth sensor's camera.
pub(crate) const SENSOR_PARAMS: &str = "depth_sensor_camera_params";

/// The files of a shot, in any layout.
pub(crate) fn list<'a>(shot: &'a Shot, options: &WriterOptions) -> Vec<DatasetFile<'a>> {
    let mut files = Files {
        extras: options.extras,
        list: Vec::new(),
    };
    files.push_annotations(&shot.frame, options);
    if let Some(params) = &shot.camera_params {
        let name = Annotator::CameraParams.name();
        files.push(name, name, "json", move || Ok(json::encode(params)));
    }
    if let Some(params) = &shot.sensor_params {
        files.push(SENSOR_PARAMS, SENSOR_PARAMS, "json", move || {
            Ok(json::encode(params))
        });
    }
    for layer in &shot.layers {
        let (folder, name) = (layer.folder, layer.name.as_str());
        match &layer.data {
            LayerData::Depth(metres) => files.push_depth(folder, name, metres),
            LayerData::Float(image) => files.push_image(folder, name, image),
            LayerData::Byte(image) => files.push_image(folder, name, image),
            LayerData::Png(encode) => files.push(folder, name, "png", move || Ok(encode()?)),
            LayerData::Cloud {
                positions,
                colors,
                axes,
            } => files.push(folder, name, "ply", move || {
                let point = |point| axes.convert_usd(point);
                Ok(ply::encode_measured(positions, colors.as_ref(), point)?)
            }),
        }
    }
    files.list
}

struct Files<'a> {
    extras: Extras,
    list: Vec<DatasetFile<'a>>,
}

impl<'a> Files<'a> {
    fn push(
        &mut self,
        folder: &'static str,
        name: &str,
        extension: &'static str,
        encode: impl Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a,
    ) {
        self.push_content(folder, name, extension, Content::Whole(Box::new(encode)));
    }

    fn push_content(
        &mut self,
        folder: &'static str,
        name: &str,
        extension: &'static str,
        content: Content<'a>,
    ) {
        self.list.push(DatasetFile {
            folder,
            name: name.to_owned(),
            extension,
            content,
        });
    }

    fn push_image<T: NpyElement + Sync>(&mut self, folder: &'static str, name: &str, image: &'a Image<T>) {
        self.push_content(folder, name, "npy", Content::Array(Array::of_image(image)));
    }

    fn push_vectors<T: NpyElement + Sync>(&mut self, name: &'static str, image: &'a Image<[T; 4]>) {
        self.push_content(name, name, "npy", Content::Array(Array::of_vectors(image)));
    }

    /// The array of a depth image, and its extras.
    fn push_depth(&mut self, folder: &'static str, name: &str, metres: &'a Image<f32>) {
        let extras = self.extras;
        self.push_image(folder, name, metres);
        if extras.millimetres {
            self.push(folder, &format!("{name}_millimetres"), "png", move || {
                Ok(png::encode(&millimetres::from_metres(metres))?)
            });
        }
        if extras.exr {
            self.push(folder, name, "exr", move || Ok(exr::encode(metres)?));
        }
        if extras.preview {
            self.push(folder, &format!("{name}_preview"), "png", move || {
                let picture = preview::depth(metres, &preview::PreviewOptions::default());
                Ok(png::encode(&picture)?)
            });
        }
    }

    fn push_annotations(&mut self, frame: &'a Frame, options: &WriterOptions) {
        for (annotator, data) in frame.annotations() {
            let name = annotator.name();
            match data {
                AnnotationRef::Color(image) => {
                    self.push(name, name, "png", move || Ok(png::encode(image)?));
                }
                AnnotationRef::ZDepth(depth) => self.push_depth(name, name, &depth.0),
                AnnotationRef::RangeDepth(depth) => self.push_depth(name, name, &depth.0),
                AnnotationRef::Normals(image) => self.push(name, name, "png", move || {
                    Ok(png::encode(&normals::colorize(image))?)
                }),
                AnnotationRef::InstanceIds(Segmentation { ids, prim_paths }) => {
                    let legend = &format!("{name}_mapping");
                    let colorized = options.colorize_instance_id_segmentation;
                    self.push_ids(name, legend, IdKind::InstanceId, ids, prim_paths, colorized);
                }
                AnnotationRef::SemanticIds(SemanticSegmentation { ids, labels }) => {
                    let legend = &format!("{name}_labels");
                    let colorized = options.colorize_semantic_segmentation;
                    self.push_ids(name, legend, IdKind::Semantic, ids, labels, colorized);
                }
                AnnotationRef::Boxes(boxes) => self.push_boxes(name, boxes),
                AnnotationRef::Points(cloud) => self.push_cloud(name, cloud),
                AnnotationRef::PixelPoints(positions) => {
                    self.push_vectors(name, positions);
                    if self.extras.ply {
                        let colors = frame.depth_sensor_point_cloud_color.as_ref();
                        self.push(name, "depth_sensor_point_cloud", "ply", move || {
                            Ok(ply::encode_measured(positions, colors, |point| point)?)
                        });
                    }
                }
                AnnotationRef::PixelColors(colors) => self.push_vectors(name, colors),
                AnnotationRef::Scalar(image) => self.push_image(name, name, image),
                AnnotationRef::Levels(image) => self.push(name, name, "png", move || Ok(png::encode(image)?)),
                AnnotationRef::Reasons(Reasons { codes, legend }) => {
                    self.push(name, name, "png", move || Ok(png::encode(codes)?));
                    self.push(name, &format!("{name}_legend"), "json", move || {
                        Ok(json::encode(&reason_legend(legend)))
                    });
                }
            }
        }
    }

    fn push_ids<T: Serialize + Sync>(
        &mut self,
        name: &'static str,
        legend: &str,
        kind: IdKind,
        ids: &'a Image<u32>,
        names: &'a BTreeMap<u32, T>,
        colorized: bool,
    ) {
        self.push(name, name, "png", move || {
            Ok(if colorized {
                png::encode(&segmentation::colorize(kind, ids))?
            } else {
                png::encode(&segmentation::grey(ids)?)?
            })
        });
        self.push(name, legend, "json", move || {
            Ok(json::encode(&segmentation::legend(kind, names, colorized)))
        });
    }

    fn push_boxes(&mut self, name: &'static str, boxes: &'a Boxes2d) {
        self.push(name, name, "npy", move || boxes::encode(boxes));
        self.push(name, &format!("{name}_labels"), "json", move || {
            Ok(json::encode(&boxes.labels))
        });
        self.push(name, &format!("{name}_prim_paths"), "json", move || {
            Ok(json::encode(&boxes.prim_paths))
        });
    }

    /// The arrays of a cloud that are there: every one, where it has no points.
    fn push_cloud(&mut self, name: &'static str, cloud: &'a PointCloud) {
        let all = cloud.points.is_empty();
        let given = move |length: usize| all || length > 0;
        self.push(name, "pointcloud", "npy", move || cloud::points(&cloud.points));
        if given(cloud.rgb.len()) {
            self.push(name, "pointcloud_rgb", "npy", move || cloud::rgb(&cloud.rgb));
        }
        if given(cloud.normals.len()) {
            self.push(name, "pointcloud_normals", "npy", move || {
                cloud::normals(&cloud.normals)
            });
        }
        if given(cloud.semantic.len()) {
            self.push(name, "pointcloud_semantic", "npy", move || {
                cloud::ids(&cloud.semantic)
            });
        }
        if given(cloud.instance.len()) {
            self.push(name, "pointcloud_instance", "npy", move || {
                cloud::ids(&cloud.instance)
            });
        }
        if self.extras.ply {
            self.push(name, "pointcloud", "ply", move || {
                Ok(ply::encode(&ply::Cloud {
                    points: &cloud.points,
                    normals: given(cloud.normals.len()).then_some(&cloud.normals),
                    rgb: given(cloud.rgb.len()).then_some(&cloud.rgb),
                })?)
            });
        }
    }
}

/// The legend of reasons: `{"2": {"name": …, "documentation": …}}`.
pub(crate) fn reason_legend(legend: &BTreeMap<u8, ReasonLabel>) -> Value {
    let entry = |(code, label): (&u8, &ReasonLabel)| {
        let label = json!({"name": label.name, "documentation": label.documentation});
        (code.to_string(), label)
    };
    Value::Object(legend.iter().map(entry).collect())
}
