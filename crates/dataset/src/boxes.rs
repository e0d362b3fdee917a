use oaktwin_image::annotation::{Box2d, Boxes2d};
use oaktwin_image::npy::{self, Field};

use crate::file::Fault;

/// The fields of Replicator's packed record of a two-dimensional box.
const FIELDS: [Field; 6] = [
    Field::of::<u32>("semanticId"),
    Field::of::<i32>("x_min"),
    Field::of::<i32>("y_min"),
    Field::of::<i32>("x_max"),
    Field::of::<i32>("y_max"),
    Field::of::<f32>("occlusionRatio"),
];

/// Encodes boxes as a structured array.
pub(crate) fn encode(boxes: &Boxes2d) -> Result<Vec<u8>, Fault> {
    let record = |b: &Box2d| {
        [
            b.semantic_id.to_le_bytes(),
            b.x_min.to_le_bytes(),
            b.y_min.to_le_bytes(),
            b.x_max.to_le_bytes(),
            b.y_max.to_le_bytes(),
            b.occlusion_ratio.to_le_bytes(),
        ]
    };
    let bytes: Vec<[[u8; 4]; 6]> = boxes.boxes.iter().map(record).collect();
    let bytes = bytes.as_flattened().as_flattened();
    Ok(npy::encode_records(&FIELDS, boxes.boxes.len(), bytes)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn writes_records_of_24_bytes() {
        let one = Box2d {
            semantic_id: 2,
            x_min: 10,
            y_min: -1,
            x_max: 20,
            y_max: 7,
            occlusion_ratio: 0.5,
        };
        let boxes = Boxes2d {
            boxes: vec![one, one],
            ..Boxes2d::default()
        };
        let Ok(file) = encode(&boxes) else {
            panic!("not encoded")
        };
        let text = String::from_utf8_lossy(&file);
        assert!(text.contains(
            "{'descr': [('semanticId', '<u4'), ('x_min', '<i4'), ('y_min', '<i4'), ('x_max', '<i4'), \
             ('y_max', '<i4'), ('occlusionRatio', '<f4')], 'fortran_order': False, 'shape': (2,), }"
        ));
        let record = [
            2, 0, 0, 0, 10, 0, 0, 0, 255, 255, 255, 255, 20, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0, 63,
        ];
        assert!(file.ends_with(&[record, record].concat()));
        assert_eq!(file.len() % 64, 48);
    }
}
