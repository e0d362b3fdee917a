//! Imports Collada 1.4 and 1.5: polygons, triangles, strips and fans with normals, texture coordinates, colours and materials, placed by the
//! nodes of the scene.
//!
//! The file states its unit, `<unit meter>`, which is multiplied by [`ImportOptions::scale`](super::ImportOptions::scale), and its up axis, which
//! turns nothing, as in all formats. Viewers of robots do the same: rviz applies the unit and omits the rotation to another up axis
//! (`buildMesh` in rviz's `mesh_loader.cpp`), so a mesh lies in the frame of its link as its numbers say.

mod document;
mod effect;
mod geometry;
mod node;
mod primitive;
mod source;

use std::collections::BTreeMap;
use std::path::Path;

use oaktwin_files::xml::Element;

use self::document::Document;
use self::effect::Effects;
use super::builder::Builder;
use super::error::{DAMAGED, Fault};
use super::{ImportOptions, text};
use crate::{MetersPerUnit, Up};

pub(super) fn read(
    bytes: &[u8],
    path: &Path,
    options: &ImportOptions,
    builder: &mut Builder,
) -> Result<(), Fault> {
    let root = Element::parse(&text::decoded(bytes), path, DAMAGED)?;
    if root.tag != "COLLADA" {
        let message = format!("a Collada file begins with <COLLADA>, not with <{}>", root.tag);
        return Err(root.wrong(message, "use a Collada file").into());
    }
    read_asset(&root, options, builder)?;
    let document = Document::new(&root);
    let mut effects = Effects::new(path);
    let mut left_out = BTreeMap::new();
    node::read(&document, &mut effects, &mut left_out, builder)?;
    if root.child("library_animations").is_some() {
        *left_out.entry("animations").or_default() += 1;
    }
    for (what, count) in left_out {
        builder.note("dae-unsupported", what, format!("not supported: {count} skipped"));
    }
    Ok(())
}

/// Reads the unit and the up axis.
fn read_asset(root: &Element, options: &ImportOptions, builder: &mut Builder) -> Result<(), Fault> {
    let Some(asset) = root.child("asset") else {
        return Ok(());
    };
    if let Some(unit) = asset.child("unit")
        && let Some(meters) = unit.number("meter")?
    {
        if meters <= 0.0 {
            let message = format!("the unit is {meters} metres");
            return Err(unit.wrong(message, "write a number above 0").into());
        }
        builder.set_unit(MetersPerUnit(meters * options.scale));
    }
    let Some(axis) = asset.child("up_axis").filter(|_| options.up.is_none()) else {
        return Ok(());
    };
    match axis.text.trim() {
        "Y_UP" => builder.set_up(Up::Y),
        "Z_UP" => builder.set_up(Up::Z),
        other => {
            let message = format!("the up axis is {other}, which is not supported: y is taken to be up");
            builder.warn("dae-up-axis", axis.place(), message);
        }
    }
    Ok(())
}
