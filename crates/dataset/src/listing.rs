use oaktwin_image::annotation::{Annotator, Boxes2d, PointCloud};
use oaktwin_image::npy::Element;
use oaktwin_image::{Image, exr, millimetres, ply, png, preview};

use crate::file::{Array, Content, DatasetFile, Fault};
use crate::segmentation::{self, Kind};
use crate::{Extras, LayerData, Options, Shot, boxes, cloud, json, normals};

/// The files of a shot, in any layout.
pub(crate) fn list<'a>(shot: &'a Shot, options: &Options) -> Vec<DatasetFile<'a>> {
    let mut files = Files {
        extras: options.extras,
        list: Vec::new(),
    };
    files.push_ground_truth(shot, options);
    files.push_depth_sensor(shot);
    if let Some(params) = &shot.camera_params {
        let name = Annotator::CameraParams.name();
        files.push(name, name, "json", move || Ok(json::encode(params)));
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
                let point = |point| axes.from_usd(point);
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

    fn push_image<T: Element + Sync>(&mut self, folder: &'static str, name: &str, image: &'a Image<T>) {
        self.push_content(folder, name, "npy", Content::Array(Array::of_image(image)));
    }

    fn push_vectors<T: Element + Sync>(&mut self, name: &'static str, image: &'a Image<[T; 4]>) {
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
                let picture = preview::depth(metres, &preview::Options::default());
                Ok(png::encode(&picture)?)
            });
        }
    }

    fn push_ground_truth(&mut self, shot: &'a Shot, options: &Options) {
        let frame = &shot.frame;
        if let Some(rgb) = &frame.rgb {
            self.push("rgb", "rgb", "png", move || Ok(png::encode(rgb)?));
        }
        if let Some(depth) = &frame.distance_to_image_plane {
            self.push_depth("distance_to_image_plane", "distance_to_image_plane", &depth.0);
        }
        if let Some(depth) = &frame.distance_to_camera {
            self.push_depth("distance_to_camera", "distance_to_camera", &depth.0);
        }
        if let Some(image) = &frame.normals {
            self.push("normals", "normals", "png", move || {
                Ok(png::encode(&normals::colorize(image))?)
            });
        }
        if let Some(segmentation) = &frame.instance_id_segmentation {
            let colorized = options.colorize_instance_id_segmentation;
            let (annotator, kind) = (Annotator::InstanceIdSegmentation, Kind::InstanceId);
            self.push_ids(annotator, kind, &segmentation.ids, colorized);
            self.push(
                annotator.name(),
                "instance_id_segmentation_mapping",
                "json",
                move || {
                    Ok(json::encode(&segmentation::legend(
                        kind,
                        &segmentation.prim_paths,
                        colorized,
                    )))
                },
            );
        }
        if let Some(segmentation) = &frame.semantic_segmentation {
            let colorized = options.colorize_semantic_segmentation;
            let (annotator, kind) = (Annotator::SemanticSegmentation, Kind::Semantic);
            self.push_ids(annotator, kind, &segmentation.ids, colorized);
            self.push(
                annotator.name(),
                "semantic_segmentation_labels",
                "json",
                move || {
                    Ok(json::encode(&segmentation::legend(
                        kind,
                        &segmentation.labels,
                        colorized,
                    )))
                },
            );
        }
        if let Some(boxes) = &frame.bounding_box_2d_tight {
            self.push_boxes(Annotator::BoundingBox2dTight, boxes);
        }
        if let Some(boxes) = &frame.bounding_box_2d_loose {
            self.push_boxes(Annotator::BoundingBox2dLoose, boxes);
        }
        if let Some(cloud) = &frame.pointcloud {
            self.push_cloud(cloud);
        }
    }

    fn push_depth_sensor(&mut self, shot: &'a Shot) {
        let frame = &shot.frame;
        if let Some(distance) = &frame.depth_sensor_distance {
            let name = Annotator::DepthSensorDistance.name();
            self.push_depth(name, name, &distance.0);
        }
        let colors = frame.depth_sensor_point_cloud_color.as_ref();
        if let Some(positions) = &frame.depth_sensor_point_cloud_position {
            let name = Annotator::DepthSensorPointCloudPosition.name();
            self.push_vectors(name, positions);
            if self.extras.ply {
                self.push(name, "depth_sensor_point_cloud", "ply", move || {
                    Ok(ply::encode_measured(positions, colors, |point| point)?)
                });
            }
        }
        if let Some(colors) = colors {
            self.push_vectors(Annotator::DepthSensorPointCloudColor.name(), colors);
        }
        if let Some(imager) = &frame.depth_sensor_imager {
            let name = Annotator::DepthSensorImager.name();
            self.push_image(name, name, imager);
        }
        if let Some(view) = &frame.depth_sensor_output_visualization {
            let name = Annotator::DepthSensorOutputVisualization.name();
            self.push(name, name, "png", move || Ok(png::encode(view)?));
        }
    }

    fn push_ids(&mut self, annotator: Annotator, kind: Kind, ids: &'a Image<u32>, colorized: bool) {
        self.push(annotator.name(), annotator.name(), "png", move || {
            Ok(if colorized {
                png::encode(&segmentation::colorize(kind, ids))?
            } else {
                png::encode(&segmentation::grey(ids)?)?
            })
        });
    }

    fn push_boxes(&mut self, annotator: Annotator, boxes: &'a Boxes2d) {
        let name = annotator.name();
        self.push(name, name, "npy", move || boxes::encode(boxes));
        self.push(name, &format!("{name}_labels"), "json", move || {
            Ok(json::encode(&boxes.labels))
        });
        self.push(name, &format!("{name}_prim_paths"), "json", move || {
            Ok(json::encode(&boxes.prim_paths))
        });
    }

    /// The arrays of a cloud that are there: every one, where it has no points.
    fn push_cloud(&mut self, cloud: &'a PointCloud) {
        let annotator = Annotator::Pointcloud.name();
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
        if self.extras.ply {
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
