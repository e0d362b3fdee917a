use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_files::OutputFiles;
use oaktwin_image::{CodecError, Image, png};
use serde_json::{Map, Value, json};

use super::common::{
    self, DepthSummary, Depths, FrameFiles, camera_matrix, missing, number, pinhole, rows, text,
};
use super::{bop_model, rle};
use crate::file::Fault;
use crate::{Format, Model, Object, Records, Shot, WriteError, json as files};

/// Depth in millimetres.
const PER_METRE: f32 = 1000.0;
const NAME: &str = "bop";
/// The visible fraction below which evaluation ignores an object.
const MIN_VISIBLE: f64 = 0.1;

/// The scenewise layout of the BOP benchmark: `train/000000/{rgb,depth,mask,mask_visib}`, `scene_gt.json` and so on, and models in
/// millimetres with their textures or colours.
///
/// A sequence is a scene, and an image has the number of its frame. `mask_visib` is exact: the pixels in which the object is rendered,
/// and not those in which measured depth is within 15 mm of its surface. `px_count_all` counts pixels up to one image size beyond the
/// borders, as in the benchmark's own tools. If depth is measured, `depth` has the measurement and `depth_exact` the truth.
#[derive(Debug, Default)]
pub(super) struct Bop {
    /// Descriptions of models by their number.
    models: Mutex<BTreeMap<u32, Value>>,
}

impl Bop {
    /// Returns the description of a model, whose file is written on first use.
    fn model(&self, model: &Arc<Model>, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let known = self
            .models
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .get(&model.id)
            .cloned();
        if let Some(info) = known {
            return Ok(info);
        }
        let info = bop_model::info(model);
        if bop_model::paths(model.id.into(), &info)
            .iter()
            .any(|path| !output.root().join(path).exists())
        {
            let fault = |error: CodecError| Fault::from(error).at("models".as_ref());
            for (path, bytes) in bop_model::files(model).map_err(fault)? {
                output.write(&path, &bytes)?;
                // The file belongs to the whole data set, and not to this frame.
                output.forget(&path);
            }
        }
        let mut models = self.models.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(models.entry(model.id).or_insert(info).clone())
    }
}

fn split(shot: &Shot) -> String {
    shot.render_product
        .as_ref()
        .map_or("train".to_owned(), |product| format!("train_{product}"))
}

impl Format for Bop {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let view = pinhole(NAME, shot)?;
        let depths = Depths::of(shot);
        let main = depths.main.ok_or_else(|| missing(NAME, "depth"))?;
        let size = view.camera.intrinsics.size;
        let (split, image) = (split(shot), shot.number);
        let scene = format!("{split}/{:06}", shot.sequence);
        let mut frame = FrameFiles::default();
        if let Some(rgb) = &shot.frame.rgb {
            frame.add_rgb(format!("{scene}/rgb/{image:06}.png"), rgb);
        }
        frame.add_depths(&depths, PER_METRE, |folder| {
            format!("{scene}/{folder}/{image:06}.png").into()
        });
        let (mut poses, mut infos, mut masks) = (Vec::new(), Vec::new(), Vec::new());
        let camera_from_world = view.world_from_camera.inverse();
        let mut models = Map::new();
        for (index, object) in shot.objects.iter().enumerate() {
            for (folder, mask) in [("mask", &object.silhouette), ("mask_visib", &object.visible)] {
                let path = format!("{scene}/{folder}/{image:06}_{index:06}.png");
                frame.add(path, move || {
                    Ok(png::encode(&mask.image(size.width, size.height))?)
                });
            }
            let model = self.model(&object.model, output)?;
            models.insert(object.model.id.to_string(), model);
            poses.push(pose(object, &(camera_from_world * object.world_from_model)));
            infos.push(visibility(object, main));
            masks.push(json!({
                "runs": rle::runs(&object.visible, size.width, size.height),
                "box": object.silhouette.bounding_box().map(|found| narrowed(found.map(i64::from))),
                "area": object.visible.count(),
                "label": object.model.label,
            }));
        }
        frame.write(output)?;
        let mut record = json!({
            "split": split,
            "scene": shot.sequence,
            "image": image,
            "size": [size.width, size.height],
            "camera": {
                "cam_K": camera_matrix(&view.camera.intrinsics),
                "depth_scale": 1.0,
                "cam_R_w2c": rows(&camera_from_world.rotation),
                "cam_t_w2c": millimetres(&camera_from_world),
            },
            "gt": poses,
            "gt_info": infos,
            "masks": masks,
            "models": models,
        });
        depths.add_losses(PER_METRE, &mut record);
        Ok(record)
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        let mut scenes: BTreeMap<String, Scene> = BTreeMap::new();
        let mut models: BTreeMap<u64, Value> = BTreeMap::new();
        let (mut camera, mut summary) = (None, DepthSummary::default());
        for record in records {
            let record = record?;
            let folder = format!("{}/{:06}", text(&record, "split"), number(&record, "scene"));
            // Records are in the order of frames: a new scene means that the one before is complete.
            if !scenes.contains_key(&folder) {
                let split = format!("{}/", text(&record, "split"));
                let done: Vec<String> = scenes
                    .keys()
                    .filter(|folder| folder.starts_with(&split))
                    .cloned()
                    .collect();
                for done in done {
                    if let Some(scene) = scenes.remove(&done) {
                        scene.write(&done, output)?;
                    }
                }
            }
            for (id, model) in record["models"].as_object().into_iter().flatten() {
                models
                    .entry(id.parse().unwrap_or_default())
                    .or_insert_with(|| model.clone());
            }
            camera.get_or_insert_with(|| camera_file(&record));
            summary.add(&record);
            scenes.entry(folder).or_default().add(&record);
        }
        for (folder, scene) in scenes {
            scene.write(&folder, output)?;
        }
        for (id, model) in &models {
            for path in bop_model::paths(*id, model) {
                output.list(&path)?;
            }
        }
        let infos: Map<String, Value> = (models.iter())
            .map(|(id, model)| (id.to_string(), model["info"].clone()))
            .collect();
        output.write("models/models_info.json".as_ref(), &files::encode(&infos))?;
        let names: Map<String, Value> = (models.iter())
            .map(|(id, model)| {
                (
                    id.to_string(),
                    json!({"name": model["name"], "label": model["label"]}),
                )
            })
            .collect();
        output.write("models/models_names.json".as_ref(), &files::encode(&names))?;
        if let Some(camera) = camera {
            output.write("camera.json".as_ref(), &files::encode(&camera))?;
        }
        summary.finish(NAME, 65.535, output)
    }
}

/// The files of a scene.
#[derive(Default)]
struct Scene {
    camera: Map<String, Value>,
    gt: Map<String, Value>,
    gt_info: Map<String, Value>,
    images: Vec<Value>,
    annotations: Vec<Value>,
    labels: BTreeMap<u64, String>,
}

impl Scene {
    fn add(&mut self, record: &Value) {
        let image = number(record, "image");
        let (width, height) = (&record["size"][0], &record["size"][1]);
        self.camera.insert(image.to_string(), record["camera"].clone());
        self.gt.insert(image.to_string(), record["gt"].clone());
        self.gt_info.insert(image.to_string(), record["gt_info"].clone());
        self.images.push(json!({
            "id": image, "file_name": format!("rgb/{image:06}.png"), "width": width, "height": height,
        }));
        let list = |name: &str| record[name].as_array().into_iter().flatten();
        for ((pose, info), mask) in list("gt").zip(list("gt_info")).zip(list("masks")) {
            let id = number(pose, "obj_id");
            self.labels
                .entry(id)
                .or_insert_with(|| text(mask, "label").to_owned());
            // The tools of the benchmark write no annotation for an object without visible pixels.
            if number(mask, "area") == 0 {
                continue;
            }
            self.annotations.push(json!({
                // pycocotools takes an annotation with the id 0 for a missing one.
                "id": self.annotations.len() + 1,
                "image_id": image,
                "category_id": id,
                "iscrowd": 0,
                "area": mask["area"],
                "bbox": mask["box"],
                "segmentation": {"size": [height, width], "counts": mask["runs"]},
                "width": width,
                "height": height,
                "ignore": info["visib_fract"].as_f64().unwrap_or_default() < MIN_VISIBLE,
            }));
        }
    }

    fn write(self, folder: &str, output: &mut OutputFiles) -> Result<(), WriteError> {
        let categories = self.labels.iter();
        let categories: Vec<Value> = categories
            .map(|(id, label)| json!({"id": id, "name": id.to_string(), "supercategory": label}))
            .collect();
        let coco = json!({
            "info": common::coco_info(), "licenses": [],
            "images": self.images, "annotations": self.annotations, "categories": categories,
        });
        for (name, contents) in [
            ("scene_camera", Value::Object(self.camera)),
            ("scene_gt", Value::Object(self.gt)),
            ("scene_gt_info", Value::Object(self.gt_info)),
            ("scene_gt_coco", coco),
        ] {
            let path = PathBuf::from(format!("{folder}/{name}.json"));
            output.write(&path, &files::encode(&contents))?;
        }
        Ok(())
    }
}

fn camera_file(record: &Value) -> Value {
    let matrix = &record["camera"]["cam_K"];
    json!({
        "fx": matrix[0], "fy": matrix[4], "cx": matrix[2], "cy": matrix[5],
        "width": record["size"][0], "height": record["size"][1], "depth_scale": 1.0,
    })
}

fn millimetres(transform: &RigidTransform) -> [f64; 3] {
    (transform.translation * 1000.0).to_array()
}

fn pose(object: &Object, camera_from_model: &RigidTransform) -> Value {
    json!({
        "cam_R_m2c": rows(&camera_from_model.rotation),
        "cam_t_m2c": millimetres(camera_from_model),
        "obj_id": object.model.id,
    })
}

#[expect(clippy::cast_precision_loss, reason = "numbers of pixels")]
fn visibility(object: &Object, depth: &Image<f32>) -> Value {
    let whole = &object.silhouette;
    let is_valid = |[x, y]: &[u32; 2]| depth.get(*x, *y).is_some_and(|z| *z > 0.0 && z.is_finite());
    let visible = object.visible.count();
    // The benchmark's tools have no boxes for objects that cannot be seen.
    let none = [-1; 4];
    let visible_box = object.visible.bounding_box();
    let whole_box = visible_box.map_or(none, |_| narrowed(object.extent.rectangle));
    json!({
        "bbox_obj": whole_box,
        "bbox_visib": visible_box.map_or(none, |found| narrowed(found.map(i64::from))),
        "px_count_all": object.extent.count,
        "px_count_valid": whole.places().filter(is_valid).count(),
        "px_count_visib": visible,
        "visib_fract": if object.extent.count > 0 { visible as f64 / object.extent.count as f64 } else { 0.0 },
    })
}

/// Returns a box as the benchmark's tools define it: its size is the difference between the first and the last pixel.
fn narrowed([x, y, width, height]: [i64; 4]) -> [i64; 4] {
    [x, y, width - 1, height - 1]
}
