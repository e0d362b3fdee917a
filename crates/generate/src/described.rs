//! Objects as formats describe them: their models, and their pixels.

use std::collections::BTreeMap;

use oaktwin_camera::{Camera, ImageSize, Intrinsics, OpenCv, PixelPoint};
use oaktwin_dataset::{Extent, Object, ObjectMask};
use oaktwin_image::annotation::Segmentation;
use oaktwin_pipeline::render::View;

use crate::arrange::{Arrangement, Placed, Stage};
use crate::context::Context;
use crate::object_model::model_of;

/// Returns the objects of a frame with their masks.
pub(crate) fn objects(
    context: &Context,
    arrangement: &Arrangement,
    stage: &Stage,
    view: &View,
    ids: Option<&Segmentation>,
) -> Vec<Object> {
    let groups: Vec<Vec<u32>> = (stage.objects.iter())
        .map(|instances| {
            instances
                .clone()
                .filter_map(|index| u32::try_from(index).ok())
                .collect()
        })
        .collect();
    let size = view.camera.intrinsics.size;
    let silhouettes = stage.renderer().silhouettes(&extended(view), &groups);
    let visible = visible(&arrangement.objects, ids);
    let found = arrangement.objects.iter().zip(silhouettes).zip(visible);
    found
        .map(|((object, silhouette), visible)| {
            let inside = silhouette.iter().filter_map(|[x, y]| {
                let (x, y) = (x.checked_sub(size.width)?, y.checked_sub(size.height)?);
                (x < size.width && y < size.height).then_some([x, y])
            });
            // Both have the same rules, but not the same rounding.
            let inside: Vec<[u32; 2]> = inside.chain(visible.places()).collect();
            let whole = ObjectMask::from_places(&silhouette);
            let [left, top, width, height] = whole.bounding_box().unwrap_or_default().map(i64::from);
            Object {
                extent: Extent {
                    count: (silhouette.len() as u64).max(visible.count() as u64),
                    rectangle: [
                        left - i64::from(size.width),
                        top - i64::from(size.height),
                        width,
                        height,
                    ],
                },
                model: (context.models).get((object.entry, object.scale.to_bits()), || {
                    model_of(object, &context.object_files.entries[object.entry].name)
                }),
                path: object.path.clone(),
                world_from_model: object.world_from_object,
                silhouette: ObjectMask::from_places(&inside),
                visible,
            }
        })
        .collect()
}

/// Returns a view of the surroundings, too: the image is extended by its own size on all sides.
fn extended(view: &View) -> View {
    let intrinsics = view.camera.intrinsics;
    let size = intrinsics.size;
    let moved = |value: f64, by: u32| value + f64::from(by);
    let center = intrinsics.principal_point::<OpenCv>();
    let center = PixelPoint::<OpenCv>::new(moved(center.x, size.width), moved(center.y, size.height));
    let larger = ImageSize::new(3 * size.width, 3 * size.height);
    let intrinsics = Intrinsics::new(larger, intrinsics.fx, intrinsics.fy, center);
    View {
        camera: Camera::new(intrinsics, view.camera.lens),
        ..*view
    }
}

/// Returns the visible pixels of each object.
fn visible(objects: &[Placed], ids: Option<&Segmentation>) -> Vec<ObjectMask> {
    let mut places: Vec<Vec<[u32; 2]>> = vec![Vec::new(); objects.len()];
    let Some(Segmentation { ids, prim_paths }) = ids else {
        return vec![ObjectMask::default(); objects.len()];
    };
    let of_path: BTreeMap<&str, usize> = objects
        .iter()
        .enumerate()
        .map(|(at, object)| (&*object.path, at))
        .collect();
    let object_of = |path: &str| {
        let parent = path.rsplit_once("/part_").map_or(path, |(parent, _)| parent);
        of_path.get(path).or_else(|| of_path.get(parent)).copied()
    };
    let of_id: BTreeMap<u32, usize> = (prim_paths.iter())
        .filter_map(|(id, path)| Some((*id, object_of(path)?)))
        .collect();
    let width = ids.width().max(1);
    let mut last = (0, None);
    for (index, id) in (0u32..).zip(ids.pixels()) {
        if last.0 != *id {
            last = (*id, of_id.get(id).copied());
        }
        if let Some(object) = last.1 {
            places[object].push([index % width, index / width]);
        }
    }
    places
        .iter()
        .map(|places| ObjectMask::from_places(places))
        .collect()
}
