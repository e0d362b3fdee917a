//! Colours and ground truth that the sensor does not need.

use std::fmt::Write;

use oaktwin::camera::ImageSize;
use oaktwin::render::Transparent;

use super::{option, quoted};
use crate::protocol::{Failure, OakState};

/// Adds the options that make recorded colours, and the ground truth behind clear surfaces.
pub(super) fn arguments(state: &OakState, words: &mut Vec<String>) -> Result<(), Failure> {
    if state.transparent()? != Transparent::default() {
        option(words, "transparent", &state.transparent);
    }
    if let Some(changed) = &state.color_imager {
        if changed.is_empty() {
            option(words, "rgb-imager", "on");
        }
        for (name, value) in changed {
            option(words, "rgb-imager", &format!("{name}={value}"));
        }
    }
    Ok(())
}

/// The lines that make recorded colours, and the ground truth behind clear surfaces; none for exact colours and the surfaces themselves.
pub(super) fn images(state: &OakState, size: Option<ImageSize>) -> Result<String, Failure> {
    let mut more = String::new();
    if let Some(changed) = &state.color_imager {
        let changed = changed
            .iter()
            .map(|(name, value)| format!("{}: {}", quoted(name), quoted(value)));
        let _ = match changed.len() {
            0 => write!(more, ", rgb_imager=True"),
            _ => write!(
                more,
                ", rgb_imager={{{}}}",
                changed.collect::<Vec<_>>().join(", ")
            ),
        };
    }
    if state.transparent()? != Transparent::default() {
        let _ = write!(more, ", transparent={}", quoted(&state.transparent));
    }
    if more.is_empty() {
        return Ok(more);
    }
    let size = size.map_or_else(String::new, |size| {
        format!(", size=({}, {})", size.width, size.height)
    });
    Ok(format!(
        "rig = oaktwin.Rig(\n    device, cameras=[{}]{size}, annotators=[\"rgb\", \"distance_to_image_plane\"], seed={}{more}\n)\n\
         (images,) = rig.shoot(scene, world_from_body, frame={}).values()\n",
        quoted(&state.sensor),
        state.seed,
        state.frame
    ))
}
