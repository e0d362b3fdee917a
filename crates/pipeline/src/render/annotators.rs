//! Annotators by name.

use oaktwin_diagnostic::nearest;
use oaktwin_image::annotation::Annotator;

/// What is rendered when nobody says what: a picture, the depth, and the camera that both are of.
pub const DEFAULT_ANNOTATORS: [Annotator; 3] = [
    Annotator::Rgb,
    Annotator::DistanceToImagePlane,
    Annotator::CameraParams,
];

/// A name that is no annotator's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no annotator `{name}`; {}", hint(nearest))]
pub struct UnknownAnnotator {
    /// The name.
    pub name: String,
    /// The nearest valid ones, best first.
    pub nearest: Vec<&'static str>,
}

fn hint(nearest: &[&str]) -> String {
    match nearest {
        [] => format!("there are {}", all().collect::<Vec<_>>().join(", ")),
        near => format!("did you mean {}?", near.join(" or ")),
    }
}

fn all() -> impl Iterator<Item = &'static str> {
    Annotator::ALL.into_iter().map(Annotator::name)
}

/// The annotator of Replicator's name.
///
/// # Errors
/// There is none; the error lists the nearest.
pub fn annotator(name: &str) -> Result<Annotator, UnknownAnnotator> {
    let found = Annotator::ALL
        .into_iter()
        .find(|annotator| annotator.name() == name);
    found.ok_or_else(|| UnknownAnnotator {
        name: name.to_owned(),
        nearest: nearest(name, all()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_name_finds_its_neighbours() {
        for one in Annotator::ALL {
            assert_eq!(annotator(one.name()), Ok(one));
        }
        let error = annotator("distance_to_image").unwrap_err().to_string();
        assert!(
            error.contains("did you mean distance_to_image_plane or"),
            "{error}"
        );
        let error = annotator("xyz").unwrap_err().to_string();
        assert!(error.contains("there are rgb, "), "{error}");
    }
}
