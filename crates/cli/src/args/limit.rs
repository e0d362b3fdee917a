//! The limits on what a scene may compose.

use oaktwin::usd::stage::SceneLimit;

pub(super) const HELP: &str =
    "Multiply the limits on a USD scene's prims, references and instances by this factor";

/// Parses the factor.
pub(super) fn parse(text: &str) -> Result<SceneLimit, String> {
    let factor = text.parse().ok().and_then(SceneLimit::new);
    factor.ok_or_else(|| "must be a finite number > 0".to_owned())
}
