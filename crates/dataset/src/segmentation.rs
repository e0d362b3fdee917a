//! Segmentations in the format of `BasicWriter`: an image and a legend of its values.
//!
//! If colorized, pixels are RGBA and the JSON keys are `"(r, g, b, a)"`. Otherwise pixels are ids in 16-bit grey, the maximum of
//! PNG (`BasicWriter` passes 32 bits to its encoder, which truncates them), and the keys are ids.

use std::collections::BTreeMap;

use oaktwin_image::{Image, colormap};
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::file::Fault;

/// The label of the background.
const BACKGROUND: &str = "BACKGROUND";

/// The label of prims without labels.
const UNLABELLED: &str = "UNLABELLED";

/// The kind of ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum IdKind {
    /// Ids of prims; 0 is the background.
    InstanceId,
    /// Ids of sets of labels; 0 is the background, 1 means unlabelled.
    Semantic,
}

impl IdKind {
    /// Returns the colour of an id, which is the same in all images.
    fn color(self, id: u32) -> [u8; 4] {
        match (self, id) {
            (_, 0) => [0; 4],
            (Self::InstanceId, id) => colormap::distinct(id - 1),
            (Self::Semantic, 1) => [0, 0, 0, 255],
            (Self::Semantic, id) => colormap::distinct(id - 2),
        }
    }

    fn named(self, name: &str) -> Value {
        match self {
            Self::InstanceId => json!(name),
            Self::Semantic => json!({ "class": name }),
        }
    }
}

/// Converts ids to RGBA.
pub(crate) fn colorize(kind: IdKind, ids: &Image<u32>) -> Image<[u8; 4]> {
    let mut last = (0, kind.color(0));
    ids.map(|&id| {
        if id != last.0 {
            last = (id, kind.color(id));
        }
        last.1
    })
}

/// Converts ids to 16 bits.
pub(crate) fn grey(ids: &Image<u32>) -> Result<Image<u16>, Fault> {
    if let Some(&id) = ids.pixels().iter().find(|&&id| id > u32::from(u16::MAX)) {
        return Err(Fault::IdTooLarge(id));
    }
    #[expect(clippy::cast_possible_truncation, reason = "checked above")]
    let grey = ids.map(|&id| id as u16);
    Ok(grey)
}

/// Returns the legend of the image's values. As in Replicator, it always contains the background and, if colorized, the
/// unlabelled value.
pub(crate) fn legend<T: Serialize>(kind: IdKind, names: &BTreeMap<u32, T>, colorized: bool) -> Value {
    let key = |id: u32| {
        if colorized {
            let [r, g, b, a] = kind.color(id);
            format!("({r}, {g}, {b}, {a})")
        } else {
            id.to_string()
        }
    };
    let unlabelled = if colorized {
        "(0, 0, 0, 255)".to_owned()
    } else {
        key(1)
    };
    let mut legend = Map::new();
    legend.insert(key(0), kind.named(BACKGROUND));
    legend.insert(unlabelled, kind.named(UNLABELLED));
    for (&id, name) in names {
        // Strings and maps of strings can always be serialized.
        legend.insert(key(id), serde_json::to_value(name).unwrap_or_default());
    }
    Value::Object(legend)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn legends_name_colors() {
        let ids = Image::new(3, 1, vec![0, 3, 2]).unwrap();
        let picture = colorize(IdKind::Semantic, &ids);
        assert_eq!(picture.pixels()[0], [0; 4]);
        assert_eq!(picture.pixels()[2], [255, 25, 25, 255]);
        let labels = |class: &str| BTreeMap::from([("class".to_owned(), class.to_owned())]);
        let names = BTreeMap::from([(2, labels("cup")), (3, labels("table"))]);
        let [r, g, b, a] = picture.pixels()[1];
        assert_eq!(
            legend(IdKind::Semantic, &names, true),
            json!({
                "(0, 0, 0, 0)": {"class": "BACKGROUND"},
                "(0, 0, 0, 255)": {"class": "UNLABELLED"},
                "(255, 25, 25, 255)": {"class": "cup"},
                format!("({r}, {g}, {b}, {a})"): {"class": "table"},
            })
        );
        assert_eq!(
            legend(IdKind::Semantic, &names, false).to_string(),
            r#"{"0":{"class":"BACKGROUND"},"1":{"class":"UNLABELLED"},"2":{"class":"cup"},"3":{"class":"table"}}"#
        );
    }

    #[test]
    fn legends_of_prims_contain_paths() {
        let names = BTreeMap::from([(1, "/World/Cup".to_owned())]);
        assert_eq!(
            legend(IdKind::InstanceId, &names, true).to_string(),
            r#"{"(0, 0, 0, 0)":"BACKGROUND","(0, 0, 0, 255)":"UNLABELLED","(255, 25, 25, 255)":"/World/Cup"}"#
        );
        assert_eq!(
            legend(IdKind::InstanceId, &names, false).to_string(),
            r#"{"0":"BACKGROUND","1":"/World/Cup"}"#
        );
    }

    #[test]
    fn rejects_ids_above_16_bits() {
        let fits = Image::new(2, 1, vec![0, 65535]).unwrap();
        assert!(matches!(grey(&fits), Ok(grey) if grey.pixels() == [0, 65535]));
        let too_large = Image::new(2, 1, vec![65536, 70000]).unwrap();
        assert!(matches!(grey(&too_large), Err(Fault::IdTooLarge(65536))));
    }
}
