//! Names of annotators.

use oaktwin_base::diagnostic::{nearest, suggestion};
use oaktwin_image::annotation::Annotator;

/// The annotators that are rendered by default.
pub const DEFAULT_ANNOTATORS: [Annotator; 3] = [
    Annotator::Rgb,
    Annotator::DistanceToImagePlane,
    Annotator::CameraParams,
];

/// An unknown annotator.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown annotator '{name}'; {}", suggestion(nearest, &all().collect::<Vec<_>>()))]
pub struct UnknownAnnotator {
    /// The name.
    pub name: String,
    /// The nearest names, best first.
    pub nearest: Vec<&'static str>,
}

fn all() -> impl Iterator<Item = &'static str> {
    Annotator::all().map(Annotator::name)
}

/// Returns the annotator with Replicator's name.
///
/// # Errors
/// Returns an error with the nearest names if there is none.
pub fn annotator(name: &str) -> Result<Annotator, UnknownAnnotator> {
    let found = Annotator::all().find(|annotator| annotator.name() == name);
    found.ok_or_else(|| UnknownAnnotator {
        name: name.to_owned(),
        nearest: nearest(name, all()),
    })
}

/// Lists of annotators in files, as their names: `#[serde(with = "annotator_names")]`.
pub(crate) mod annotator_names {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    use super::{Annotator, annotator};

    pub(crate) fn serialize<S: Serializer>(
        annotators: &[Annotator],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(annotators.iter().map(|annotator| annotator.name()))
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<Annotator>, D::Error> {
        let names = Vec::<String>::deserialize(deserializer)?;
        let annotators = names.iter().map(|name| annotator(name).map_err(D::Error::custom));
        annotators.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suggests_near_names() {
        for one in Annotator::all() {
            assert_eq!(annotator(one.name()), Ok(one));
        }
        let error = annotator("distance_to_image").unwrap_err().to_string();
        assert!(
            error.contains("did you mean 'distance_to_image_plane'"),
            "{error}"
        );
        let error = annotator("xyz").unwrap_err().to_string();
        assert!(error.contains("expected one of rgb, "), "{error}");
    }
}
