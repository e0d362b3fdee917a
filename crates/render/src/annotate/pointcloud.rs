use oaktwin_image::Image;
use oaktwin_image::annotation::PointCloud;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::segmentation::instance_id;
use super::semantics::{Semantics, UNLABELLED};
use super::surface::SurfaceFinder;
use crate::rays::Rays;
use crate::{View, Visibility};

/// Returns the points that the pixels see, row by row, computed from the triangles in double precision and rounded once.
#[expect(clippy::cast_possible_truncation, reason = "points are float32")]
pub(super) fn pointcloud(
    scene: &Scene,
    semantics: &Semantics,
    view: &View,
    rays: &Rays,
    seen: &Visibility,
    rgb: Option<&Image<[u8; 4]>>,
    unlabelled: bool,
) -> PointCloud {
    let units_per_metre = 1.0 / scene.meters_per_unit.0;
    let rows: Vec<PointCloud> = (0..seen.hits.height())
        .into_par_iter()
        .map(|y| {
            let mut finder = SurfaceFinder::new(scene, view);
            let mut row = PointCloud::default();
            for x in 0..seen.hits.width() {
                let (Some(hit), Some(z)) = (seen.hits.get(x, y), seen.z.0.get(x, y)) else {
                    continue;
                };
                let semantic = semantics.of_instance(hit.instance);
                if hit.is_miss() || (semantic == UNLABELLED && !unlabelled) {
                    continue;
                }
                let surface = rays.centre(x, y).and_then(|ray| finder.find(*hit, ray, *z));
                let Some(surface) = surface else {
                    continue;
                };
                let point = surface.point * units_per_metre;
                row.points.push(point.to_array().map(|p| p as f32));
                row.normals.push(surface.normal.to_array().map(|n| n as f32));
                row.rgb.extend(rgb.and_then(|rgb| rgb.get(x, y)));
                row.semantic.push(semantic);
                row.instance.push(instance_id(*hit));
            }
            row
        })
        .collect();
    let mut cloud = PointCloud::default();
    for row in rows {
        cloud.points.extend(row.points);
        cloud.normals.extend(row.normals);
        cloud.rgb.extend(row.rgb);
        cloud.semantic.extend(row.semantic);
        cloud.instance.extend(row.instance);
    }
    cloud
}
