use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_files as files;

use super::optics::Optics;
use super::words::{color, number};
use super::{names, rest};
use crate::import::MAX_BYTES;
use crate::import::builder::Builder;
use crate::import::text;
use crate::{ColorSpace, Material, Opacity, Texture, TextureMask, TextureSource, TextureUse, Wrap};

/// The format defines no threshold; images of cut-out surfaces are black and white.
const MASK_THRESHOLD: f32 = 0.5;

/// The materials of the MTL files that an OBJ file refers to.
///
/// `Kd` is a linear colour that multiplies `map_Kd`. Some programs write a black `Kd` beside an image: the image is then
/// used unchanged.
#[derive(Default)]
pub(super) struct Library {
    materials: BTreeMap<String, u32>,
    textures: BTreeMap<PathBuf, Option<u32>>,
}

impl Library {
    /// Reads one file, or several: names are separated by spaces, but may also contain spaces.
    pub(super) fn load(&mut self, statement: &str, folder: &Path, builder: &mut Builder) {
        let whole = existing(folder, statement);
        let files = if whole.is_file() {
            vec![whole]
        } else {
            let words = statement.split_whitespace();
            words
                .map(|name| (name, folder.join(local(name))))
                .take_while(|(name, file)| !name.starts_with('#') || file.is_file())
                .map(|(_, file)| file)
                .collect()
        };
        for file in files {
            if !file.is_file() {
                builder.warn(
                    "obj-material-library",
                    file.display().to_string(),
                    "does not exist: its materials are ignored",
                );
                continue;
            }
            match files::read_regular(&file, MAX_BYTES) {
                Ok(bytes) => self.read(&bytes, &file, builder),
                Err(error) => builder.warn(
                    "obj-material-library",
                    file.display().to_string(),
                    format!("cannot be read: {error}"),
                ),
            }
        }
    }

    /// Returns the material with this name; an undefined one is created, so that its faces stay separate.
    pub(super) fn find(&mut self, name: &str, builder: &mut Builder) -> u32 {
        let known = names(name).find(|name| self.materials.contains_key(*name));
        let name = known.unwrap_or(name);
        *self.materials.entry(name.into()).or_insert_with(|| {
            builder.add_material(Material {
                name: name.into(),
                ..Material::default()
            })
        })
    }

    fn read(&mut self, bytes: &[u8], file: &Path, builder: &mut Builder) {
        let folder = file.parent().unwrap_or(Path::new(""));
        let mut current: Option<(Material, Optics)> = None;
        for (_, line) in text::lines(&text::decoded(bytes)) {
            let line = line.trim_ascii();
            let mut words = text::words(line);
            let word = words.next().unwrap_or_default();
            if word == b"newmtl" {
                self.add(current.take(), builder);
                let material = Material {
                    name: rest(line, 6),
                    base_color: Some([1.0; 3]),
                    ..Material::default()
                };
                current = Some((material, Optics::default()));
                continue;
            }
            let Some((material, optics)) = &mut current else {
                continue;
            };
            optics.read(line);
            match word {
                b"Kd" => material.base_color = color(&mut words).or(material.base_color),
                b"Ke" => material.emissive = color(&mut words).unwrap_or_default(),
                b"Pm" => material.metallic = fraction(words.next()).unwrap_or(material.metallic),
                b"Pr" => material.roughness = fraction(words.next()).unwrap_or(material.roughness),
                b"map_Kd" => {
                    material.base_color_texture = self.texture(&rest(line, 6), folder, builder);
                }
                b"map_d" => {
                    let mask = self.texture(&rest(line, 5), folder, builder);
                    material.opacity = mask.and_then(|texture| {
                        Opacity::new(1.0, Some(TextureMask { texture, channel: 0 }), MASK_THRESHOLD)
                    });
                }
                _ => {}
            }
        }
        self.add(current, builder);
    }

    fn add(&mut self, read: Option<(Material, Optics)>, builder: &mut Builder) {
        let Some((mut material, optics)) = read else {
            return;
        };
        optics.apply(&mut material, builder);
        if material.base_color_texture.is_some() && material.base_color == Some([0.0; 3]) {
            material.base_color = Some([1.0; 3]);
        }
        // The opacity of the colours' image, or another image as a mask.
        let colors = material.base_color_texture.map(|used| used.texture);
        if let Some(mask) = material
            .opacity
            .as_mut()
            .and_then(|opacity| opacity.mask.as_mut())
            && colors == Some(mask.texture.texture)
        {
            mask.channel = 3;
        }
        // The first definition of a name takes precedence.
        if !self.materials.contains_key(&material.name) {
            let name = material.name.clone();
            self.materials.insert(name, builder.add_material(material));
        }
    }

    /// Parses a texture statement: options, then the name of the image.
    fn texture(&mut self, statement: &str, folder: &Path, builder: &mut Builder) -> Option<TextureUse> {
        let (name, options) = TextureOptions::split(statement);
        let file = existing(folder, name);
        let texture = self.textures.entry(file.clone()).or_insert_with(|| {
            if !file.is_file() {
                builder.warn(
                    "texture-missing",
                    file.display().to_string(),
                    "the image does not exist",
                );
                return None;
            }
            Some(builder.add_texture(Texture {
                source: TextureSource::File(file),
                color_space: ColorSpace::Auto,
            }))
        });
        let texture = (*texture)?;
        let wrap = if options.clamp { Wrap::Clamp } else { Wrap::Repeat };
        let ([su, sv], [ou, ov]) = (options.scale, options.offset);
        Some(TextureUse {
            image_from_uv: [[su, 0.0, ou], [0.0, sv, ov]],
            wrap_s: wrap,
            wrap_t: wrap,
            ..TextureUse::new(texture)
        })
    }
}

struct TextureOptions {
    scale: [f32; 2],
    offset: [f32; 2],
    clamp: bool,
}

impl TextureOptions {
    fn split(statement: &str) -> (&str, Self) {
        let mut options = Self {
            scale: [1.0; 2],
            offset: [0.0; 2],
            clamp: false,
        };
        let mut left = statement.trim();
        while let Some((option, after)) = left
            .strip_prefix('-')
            .and_then(|option| option.split_once(char::is_whitespace))
        {
            // The maximum number of arguments: numbers, of which the last may be missing, or one word.
            let (words, rest) = match option {
                "o" | "s" | "t" => leading_numbers(after, 3),
                "mm" => leading_numbers(after, 2),
                "bm" | "boost" | "texres" => leading_numbers(after, 1),
                "blendu" | "blendv" | "cc" | "clamp" | "imfchan" | "type" | "colorspace" => {
                    if after.trim_start().starts_with("on") {
                        options.clamp |= option == "clamp";
                    }
                    let rest = after
                        .trim_start()
                        .split_once(char::is_whitespace)
                        .map_or("", |split| split.1);
                    (Vec::new(), rest)
                }
                // Not an option: a name that starts with a hyphen.
                _ => break,
            };
            let target = match option {
                "o" => Some(&mut options.offset),
                "s" => Some(&mut options.scale),
                _ => None,
            };
            if let Some(target) = target {
                for (slot, number) in target.iter_mut().zip(words) {
                    *slot = number;
                }
            }
            left = rest.trim_start();
        }
        (left, options)
    }
}

fn leading_numbers(text: &str, max: usize) -> (Vec<f32>, &str) {
    let mut numbers = Vec::new();
    let mut left = text.trim_start();
    while numbers.len() < max {
        let (word, after) = left.split_once(char::is_whitespace).unwrap_or((left, ""));
        let Some(number) = word.parse().ok().filter(|number: &f32| number.is_finite()) else {
            break;
        };
        numbers.push(number);
        left = after.trim_start();
    }
    (numbers, left)
}

fn fraction(word: Option<&[u8]>) -> Option<f32> {
    number(word).map(|number| number.clamp(0.0, 1.0))
}

/// The file with a name, or with the name before a comment if only that exists.
fn existing(folder: &Path, name: &str) -> PathBuf {
    let mut files = names(name).map(|name| folder.join(local(name)));
    files
        .find(|file| file.is_file())
        .unwrap_or_else(|| folder.join(local(name)))
}

/// Converts a file name to this system's path separators.
fn local(name: &str) -> PathBuf {
    PathBuf::from(name.replace('\\', "/"))
}
