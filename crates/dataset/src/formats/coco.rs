use std::path::PathBuf;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use super::common::{FrameFiles, Pieces, coco_info, in_product, number, rgb, text};
use super::rle;
use crate::{Format, Records, Shot, WriteError};

const NAME: &str = "coco";

/// COCO's instances: `images/00000000.png` and `annotations/instances.json` with the visible pixels of each object as compressed runs.
///
/// The id of a category is its place among the sorted labels of the data set, whether or not an image shows it, so that parts that
/// are made separately agree.
#[derive(Debug)]
pub(super) struct Coco {
    /// The labels of the data set, sorted.
    pub(super) labels: Vec<String>,
}

impl Format for Coco {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let rgb = rgb(NAME, shot)?;
        let (width, height) = (rgb.width(), rgb.height());
        let file = in_product(shot, format!("{:08}.png", shot.number));
        let mut frame = FrameFiles::default();
        frame.add_rgb(PathBuf::from("images").join(&file), rgb);
        frame.write(output)?;
        let visible = shot.objects.iter().filter(|object| object.visible.count() > 0);
        let objects: Vec<Value> = visible
            .map(|object| {
                json!({
                    "label": object.model.label,
                    "bbox": object.visible.bounding_box(),
                    "area": object.visible.count(),
                    "counts": rle::compressed(&rle::runs(&object.visible, width, height)),
                })
            })
            .collect();
        Ok(json!({"file": file, "size": [width, height], "objects": objects}))
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        // Annotations are written as they come, because there are most of them.
        let mut file = Pieces::create(output, "annotations/instances.json".as_ref())?;
        file.write("{\"annotations\": [")?;
        let mut images: Vec<Value> = Vec::new();
        let mut labels = self.labels.clone();
        let mut annotation = 0u64;
        for record in records {
            let record = record?;
            let image = images.len() + 1;
            let [width, height] = [0, 1].map(|axis| record["size"][axis].as_u64().unwrap_or_default());
            images.push(
                json!({"id": image, "file_name": text(&record, "file"), "width": width, "height": height}),
            );
            for object in record["objects"].as_array().into_iter().flatten() {
                annotation += 1;
                let label = text(object, "label");
                let known = labels.iter().position(|known| known == label);
                let category = 1 + known.unwrap_or_else(|| {
                    labels.push(label.to_owned());
                    labels.len() - 1
                });
                let value = json!({
                    "id": annotation, "image_id": image, "category_id": category, "iscrowd": 0,
                    "area": number(object, "area"), "bbox": object["bbox"],
                    "segmentation": {"size": [height, width], "counts": object["counts"]},
                });
                file.element(&value.to_string())?;
            }
        }
        let categories: Vec<Value> = (1..)
            .zip(&labels)
            .map(|(id, name)| json!({"id": id, "name": name, "supercategory": "object"}))
            .collect();
        let (images, categories) = (Value::from(images), Value::from(categories));
        file.write(&format!(
            "\n],\n\"images\": {images},\n\"categories\": {categories},\n\"info\": {},\n\"licenses\": []}}\n",
            coco_info()
        ))?;
        file.finish(output)?;
        Ok(Vec::new())
    }
}
