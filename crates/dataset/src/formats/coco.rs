use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::OutputFiles;
use serde_json::{Value, json};

use super::common::{FrameFiles, Pieces, in_product, number, rgb, text};
use super::rle;
use crate::{Format, Records, Shot, WriteError};

const NAME: &str = "coco";

/// COCO's instances: `images/00000000.png` and `annotations/instances.json` with the visible pixels of each object as compressed runs.
#[derive(Debug, Default)]
pub(super) struct Coco;

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
        let mut categories: BTreeMap<String, usize> = BTreeMap::new();
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
                let next = categories.len() + 1;
                let category = *categories.entry(text(object, "label").to_owned()).or_insert(next);
                let value = json!({
                    "id": annotation, "image_id": image, "category_id": category, "iscrowd": 0,
                    "area": number(object, "area"), "bbox": object["bbox"],
                    "segmentation": {"size": [height, width], "counts": object["counts"]},
                });
                file.element(&value.to_string())?;
            }
        }
        let mut named: Vec<(usize, String)> = categories.into_iter().map(|(name, id)| (id, name)).collect();
        named.sort_unstable();
        let categories: Vec<Value> = named
            .iter()
            .map(|(id, name)| json!({"id": id, "name": name}))
            .collect();
        let (images, categories) = (Value::from(images), Value::from(categories));
        file.write(&format!(
            "\n],\n\"images\": {images},\n\"categories\": {categories}}}\n"
        ))?;
        file.finish(output)?;
        Ok(Vec::new())
    }
}
