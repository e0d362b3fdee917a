use oaktwin_image::annotation::{Annotator, Boxes2d, PointCloud};
use oaktwin_image::{Image, exr, millimetres, npy, ply, png, preview};

use crate::file::{DatasetFile, Fault};
use crate::segmentation::{self, Kind};
use crate::{Options, Shot, boxes, cloud, json};

/// The files of one shot, being listed.
pub(crate) struct Files<'a> {
    pub(crate) options: Options,
    pub(crate) shot: Shot<'a>,
    pub(crate) list: Vec<DatasetFile<'a>>,
}

impl<'a> Files<'a> {
    pub(crate) fn push(
        &mut self,
        annotator: Annotator,
        stem: &str,
        extension: &str,
        encode: impl Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a,
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
    pub(crate) fn push_depth(&mut self, annotator: Annotator, metres: &'a Image<f32>) {
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

    /// What a depth sensor reports.
    pub(crate) fn push_depth_sensor(&mut self) {
        let frame = self.shot.frame;
        if let Some(distance) = &frame.depth_sensor_distance {
            self.push_depth(Annotator::DepthSensorDistance, &distance.0);
        }
        let colors = frame.depth_sensor_point_cloud_color.as_ref();
        if let Some(positions) = &frame.depth_sensor_point_cloud_position {
            let annotator = Annotator::DepthSensorPointCloudPosition;
            self.push(annotator, annotator.name(), "npy", move || {
                cloud::organized(positions)
            });
            if self.options.extras.ply {
                self.push(annotator, "depth_sensor_point_cloud", "ply", move || {
                    Ok(ply::encode_measured(positions, colors, |point| point)?)
                });
            }
        }
        if let Some(colors) = colors {
            let annotator = Annotator::DepthSensorPointCloudColor;
            self.push(annotator, annotator.name(), "npy", move || {
                cloud::organized(colors)
            });
        }
        if let Some(imager) = &frame.depth_sensor_imager {
            let annotator = Annotator::DepthSensorImager;
            self.push(annotator, annotator.name(), "npy", move || {
                let shape = [imager.height() as usize, imager.width() as usize];
                Ok(npy::encode(&shape, imager.pixels())?)
            });
        }
        if let Some(view) = &frame.depth_sensor_output_visualization {
            let annotator = Annotator::DepthSensorOutputVisualization;
            self.push(annotator, annotator.name(), "png", move || Ok(png::encode(view)?));
        }
    }

    pub(crate) fn push_ids(
        &mut self,
        annotator: Annotator,
        kind: Kind,
        ids: &'a Image<u32>,
        colorized: bool,
    ) {
        self.push(annotator, annotator.name(), "png", move || {
            Ok(if colorized {
                png::encode(&segmentation::colorize(kind, ids))?
            } else {
                png::encode(&segmentation::grey(ids)?)?
            })
        });
    }

    pub(crate) fn push_boxes(&mut self, annotator: Annotator, boxes: &'a Boxes2d) {
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
    pub(crate) fn push_cloud(&mut self, cloud: &'a PointCloud) {
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
    use super::folder;

    #[test]
    fn names_of_folders() {
        assert_eq!(
            ["..", "", "a/../b", "C:\\x"].map(folder),
            ["__", "_", "a_.._b", "C__x"]
        );
    }
}
