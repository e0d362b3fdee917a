//! Which opinion gives an attribute its value.
//!
//! The USD library prefers time samples of any layer to every default. OpenUSD asks the layers in the order of their
//! strength, and in each prefers animation to the default; clips follow the layer that has them.

use openusd::sdf::Path;
use openusd::usd;

use super::inspect::{CLIPS_FIELD, SAMPLES_FIELD};
use super::usda::SPLINE_FIELD;

/// The kind of an attribute's strongest opinion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OpinionKind {
    Default,
    /// Time samples or value clips.
    Samples,
    /// A spline, which is not read.
    Spline,
}

/// Returns the kind of the strongest opinion on an attribute; `None` without one.
pub(super) fn strongest(
    stage: &usd::Stage,
    attribute: &usd::Attribute,
    has_clips: bool,
) -> Option<OpinionKind> {
    for (name, path) in attribute.property_stack().ok()? {
        let Some(layer) = stage.layer(&name) else { continue };
        let has = |field: &str| layer.data().has_field(&path, field);
        if has(SAMPLES_FIELD) {
            return Some(OpinionKind::Samples);
        }
        if has(SPLINE_FIELD) {
            return Some(OpinionKind::Spline);
        }
        if has("default") {
            drop(layer);
            let is_weaker = has_clips && clips_are_stronger(stage, &attribute.path().prim_path(), &name);
            return Some(if is_weaker {
                OpinionKind::Samples
            } else {
                OpinionKind::Default
            });
        }
    }
    has_clips.then_some(OpinionKind::Samples)
}

/// Whether a prim or one of its ancestors has value clips in a layer that is stronger than `default`.
fn clips_are_stronger(stage: &usd::Stage, prim: &Path, default: &str) -> bool {
    let mut prim = Some(prim.clone());
    while let Some(path) = prim.filter(|path| !path.is_abs_root()) {
        let sites = stage.prim(path.clone()).prim_stack().unwrap_or_default();
        let clips = sites.iter().position(|(name, path)| {
            let layer = stage.layer(name);
            layer.is_some_and(|layer| layer.data().has_field(path, CLIPS_FIELD))
        });
        if let Some(clips) = clips {
            let default = sites.iter().position(|(name, _)| name == default);
            return default.is_none_or(|default| clips < default);
        }
        prim = path.parent();
    }
    false
}
