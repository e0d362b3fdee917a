use std::collections::HashMap;
use std::path::{Path as FilePath, PathBuf};

use oaktwin_scene::{ColorSpace, Texture, TextureSource};
use openusd::ar;
use openusd::sdf::{Path, Value};

use super::super::super::reader::Reader;
use super::super::super::value::text;
use super::super::findings::Findings;

const CODE: &str = "missing-texture";

/// The textures of a scene, without duplicates.
#[derive(Default)]
pub(in crate::stage::scene) struct Textures {
    known: HashMap<(String, ColorSpaceKey), u32>,
}

type ColorSpaceKey = u8;

impl Textures {
    /// Adds the image named by `attribute`'s value to the scene's textures and returns its index.
    #[expect(clippy::too_many_arguments, reason = "the state of reading a material")]
    pub(in crate::stage::scene) fn add(
        &mut self,
        reader: &Reader,
        value: Value,
        attribute: &Path,
        space: Option<&str>,
        place: &str,
        textures: &mut Vec<Texture>,
        findings: &mut Findings,
    ) -> Option<u32> {
        let Value::AssetPath(asset) = value else {
            findings.warn(
                CODE,
                place,
                "its texture is not an asset path",
                "author an image file",
            );
            return None;
        };
        let authored = asset.asset_path().to_owned();
        let Some(resolved) = asset
            .resolved_path()
            .map(str::to_owned)
            .or_else(|| first_tile(reader, attribute, &authored, place, findings))
        else {
            let message = format!("its texture @{authored}@ cannot be found");
            findings.warn(
                CODE,
                place,
                message,
                "put the file at that path, or correct the path",
            );
            return None;
        };
        let color_space = color_space(reader, attribute, space);
        let key = (resolved.clone(), color_space as ColorSpaceKey);
        if let Some(known) = self.known.get(&key) {
            return Some(*known);
        }
        let source = match ar::split_package_relative_path_outer(&resolved) {
            Some((package, entry)) => match reader.packages().entry(&package, &entry) {
                Ok(bytes) => TextureSource::Encoded {
                    name: resolved.clone(),
                    bytes,
                },
                Err(what) => {
                    findings.warn(
                        CODE,
                        place,
                        format!("its texture @{resolved}@ {what}"),
                        "package it again",
                    );
                    return None;
                }
            },
            None => TextureSource::File(PathBuf::from(&resolved)),
        };
        let index = u32::try_from(textures.len()).ok()?;
        textures.push(Texture { source, color_space });
        self.known.insert(key, index);
        Some(index)
    }
}

/// Returns an image's colour space, as authored on the node or else on the file attribute.
fn color_space(reader: &Reader, attribute: &Path, space: Option<&str>) -> ColorSpace {
    let authored = reader.field(attribute, "colorSpace").and_then(text);
    match space.filter(|space| *space != "auto").or(authored.as_deref()) {
        Some("sRGB" | "srgb_texture" | "srgb_rec709_scene" | "sRGB - Texture" | "srgb") => ColorSpace::Srgb,
        Some("raw" | "Raw" | "lin_rec709" | "lin_rec709_scene" | "linear" | "none") => ColorSpace::Raw,
        _ => ColorSpace::Auto,
    }
}

/// Returns the path of the first tile of a UDIM texture, relative to the layer that names it.
fn first_tile(
    reader: &Reader,
    attribute: &Path,
    authored: &str,
    place: &str,
    findings: &mut Findings,
) -> Option<String> {
    let first = authored
        .contains("<UDIM>")
        .then(|| authored.replace("<UDIM>", "1001"))?;
    let layers = reader.stage.attribute(attribute.clone()).property_stack().ok()?;
    let (layer, _) = layers.first()?;
    let path = FilePath::new(layer).parent()?.join(first);
    let path = path.canonicalize().ok()?;
    let message = format!("its texture @{authored}@ has UDIM tiles; only the first is used");
    findings.warn("udim-texture", place, message, "merge them into one image");
    path.to_str().map(str::to_owned)
}
