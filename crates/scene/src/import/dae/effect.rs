//! Materials: the common profile of effects.
//!
//! Colours are taken to be sRGB, as viewers show them; the format does not say.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_files::xml::{Element, XmlError};
use oaktwin_image::srgb;

use super::super::builder::Builder;
use super::super::error::DAMAGED;
use super::super::uri::{Folder, ResolvedUri};
use super::document::{Document, name};
use crate::{ColorSpace, Material, Opacity, Texture, TextureMask, TextureSource, TextureUse};

/// The format defines no threshold; images of cut-out surfaces are black and white.
const MASK_THRESHOLD: f32 = 0.5;

/// A material of the scene.
#[derive(Clone)]
pub(super) struct EffectMaterial {
    pub(super) material: u32,
    /// The name by which the effect refers to the texture coordinates of its image.
    pub(super) coordinates: Option<String>,
    /// Whether it has a colour or an image, so that the colours of the mesh are not used.
    pub(super) has_color: bool,
}

/// The materials that were read.
pub(super) struct Effects {
    folder: Folder,
    known: BTreeMap<String, EffectMaterial>,
    images: BTreeMap<PathBuf, Option<u32>>,
}

/// A colour, or an image.
enum Paint<'a> {
    Color([f32; 4]),
    Image {
        texture: u32,
        coordinates: Option<&'a str>,
    },
}

impl Effects {
    /// `file` is the Collada file.
    pub(super) fn new(file: &Path) -> Self {
        Self {
            folder: Folder::of(file, true),
            known: BTreeMap::new(),
            images: BTreeMap::new(),
        }
    }

    /// Returns what a `<material>` describes.
    pub(super) fn material(
        &mut self,
        material: &Element,
        document: &Document<'_>,
        builder: &mut Builder,
    ) -> Result<EffectMaterial, XmlError> {
        let id = material.get("id").unwrap_or_default();
        if let Some(known) = self.known.get(id) {
            return Ok(known.clone());
        }
        let made = self.read(material, document, builder)?;
        self.known.insert(id.to_owned(), made.clone());
        Ok(made)
    }

    fn read(
        &mut self,
        material: &Element,
        document: &Document<'_>,
        builder: &mut Builder,
    ) -> Result<EffectMaterial, XmlError> {
        let mut made = Material {
            name: name(material).to_owned(),
            ..Material::default()
        };
        let instance = material
            .child("instance_effect")
            .ok_or_else(|| material.wrong("<instance_effect> is missing", DAMAGED))?;
        let effect = document.follow(instance, "url", "effect")?;
        let profile = effect.child("profile_COMMON");
        let model = profile
            .and_then(|profile| profile.child("technique"))
            .and_then(|technique| {
                let is_model =
                    |child: &&Element| ["phong", "lambert", "blinn", "constant"].contains(&&*child.tag);
                technique.children.iter().find(is_model)
            });
        let (Some(profile), Some(model)) = (profile, model) else {
            builder.warn("dae-effect", effect.place(), "has no common material: it is grey");
            return Ok(EffectMaterial {
                material: builder.add_material(made),
                coordinates: None,
                has_color: false,
            });
        };
        let mut reader = Reader {
            effects: self,
            document,
            effect,
            profile,
            builder,
        };
        let mut coordinates = None;
        match reader.paint(model, "diffuse")? {
            Some(Paint::Color([r, g, b, _])) => {
                made.base_color = Some(reader.shares("diffuse", &made.name, [r, g, b]));
            }
            Some(Paint::Image {
                texture,
                coordinates: set,
            }) => {
                made.base_color = Some([1.0; 3]);
                made.base_color_texture = Some(TextureUse::new(texture));
                coordinates = set.map(str::to_owned);
            }
            None if model.tag == "constant" => made.base_color = Some([0.0; 3]),
            None => {}
        }
        if let Some(Paint::Color([r, g, b, _])) = reader.paint(model, "emission")? {
            made.emissive = reader.shares("emission", &made.name, [r, g, b]);
        }
        made.opacity = reader.opacity(model, &made.name)?;
        if let Some(index) = reader.float(model, "index_of_refraction")?
            && index > 1.0
        {
            made.index = index;
        }
        Ok(EffectMaterial {
            has_color: made.base_color.is_some(),
            material: reader.builder.add_material(made),
            coordinates,
        })
    }

    /// Returns the texture of an `<image>`; `None` if its file cannot be used, which is reported.
    fn image(&mut self, image: &Element, builder: &mut Builder) -> Option<u32> {
        let source = image.child("init_from");
        let uri = source.map_or("", |source| source.child("ref").unwrap_or(source).text.trim());
        let texture = |source| Texture {
            source,
            color_space: ColorSpace::Auto,
        };
        match self.folder.resolve(&uri.replace('\\', "/")) {
            ResolvedUri::File(file) | ResolvedUri::Outside(file) => {
                *self.images.entry(file.clone()).or_insert_with(|| {
                    if file.is_file() {
                        return Some(builder.add_texture(texture(TextureSource::File(file))));
                    }
                    let shown = file.display().to_string();
                    builder.warn("texture-missing", shown, "the image does not exist");
                    None
                })
            }
            ResolvedUri::Data(bytes) => Some(builder.add_texture(texture(TextureSource::Encoded {
                name: name(image).to_owned(),
                bytes: bytes.into(),
            }))),
            ResolvedUri::Unsupported(why) => {
                builder.warn("texture-missing", image.place(), format!("its file is {why}"));
                None
            }
        }
    }
}

/// Reads one effect.
struct Reader<'a, 'b> {
    effects: &'b mut Effects,
    document: &'b Document<'a>,
    effect: &'a Element,
    profile: &'a Element,
    builder: &'b mut Builder,
}

impl<'a> Reader<'a, '_> {
    /// Returns a parameter of the effect.
    fn parameter(&self, sid: &str) -> Option<&'a Element> {
        let technique = self.profile.child("technique");
        let scopes = [Some(self.profile), technique, Some(self.effect)];
        let mut parameters = scopes
            .into_iter()
            .flatten()
            .flat_map(|scope| scope.all("newparam"));
        parameters.find(|parameter| parameter.get("sid") == Some(sid))
    }

    /// Returns a linear colour, and reports components that are not within 0 and 1.
    fn shares(&mut self, channel: &str, name: &str, color: [f32; 3]) -> [f32; 3] {
        let outside = color
            .iter()
            .find_map(|share| Material::not_a_share(channel, *share));
        if let Some(problem) = outside {
            self.builder.warn("material-value", name, problem);
        }
        color.map(|share| srgb::linear(share.clamp(0.0, 1.0)))
    }

    /// Reads a number of a model.
    fn float(&self, model: &'a Element, name: &str) -> Result<Option<f32>, XmlError> {
        let Some(element) = model.child(name) else {
            return Ok(None);
        };
        let reference = element.child("param").and_then(|param| param.get("ref"));
        let element = match reference {
            Some(sid) => self.parameter(sid).unwrap_or(element),
            None => element,
        };
        let Some(float) = element.child("float") else {
            return Ok(None);
        };
        #[expect(clippy::cast_possible_truncation, reason = "materials store single precision")]
        let first = float.text_numbers()?.first().map(|number| *number as f32);
        Ok(first)
    }

    /// Reads the colour or the image of a channel of a model.
    fn paint(&mut self, model: &'a Element, channel: &str) -> Result<Option<Paint<'a>>, XmlError> {
        let Some(element) = model.child(channel) else {
            return Ok(None);
        };
        if let Some(texture) = element.child("texture") {
            let image = self.image_of(texture)?;
            let image = image.and_then(|image| self.effects.image(image, self.builder));
            return Ok(image.map(|used| Paint::Image {
                texture: used,
                coordinates: texture.get("texcoord"),
            }));
        }
        let reference = element.child("param").and_then(|param| param.get("ref"));
        let parameter = reference.and_then(|sid| self.parameter(sid));
        let color = element.child("color").or_else(|| {
            let tags = ["color", "float4", "float3"];
            parameter.and_then(|parameter| tags.iter().find_map(|tag| parameter.child(tag)))
        });
        let Some(color) = color else {
            return Ok(None);
        };
        #[expect(clippy::cast_possible_truncation, reason = "materials store single precision")]
        let numbers: Vec<f32> = color.text_numbers()?.iter().map(|x| *x as f32).collect();
        match *numbers.as_slice() {
            [r, g, b] => Ok(Some(Paint::Color([r, g, b, 1.0]))),
            [r, g, b, a, ..] => Ok(Some(Paint::Color([r, g, b, a]))),
            _ => Err(color.wrong(format!("a colour of {} numbers", numbers.len()), DAMAGED)),
        }
    }

    /// Follows a `<texture>` through its sampler and surface to an `<image>`. Some exporters name the image itself.
    fn image_of(&mut self, texture: &Element) -> Result<Option<&'a Element>, XmlError> {
        let named = texture.required("texture")?;
        let sampler = self
            .parameter(named)
            .and_then(|parameter| parameter.child("sampler2D"));
        let found = match sampler {
            None => self.document.find(named),
            Some(sampler) => match sampler.child("instance_image") {
                Some(instance) => Some(self.document.follow(instance, "url", "image")?),
                None => {
                    let surface = sampler
                        .child("source")
                        .and_then(|source| self.parameter(source.text.trim()));
                    let from = surface
                        .and_then(|parameter| parameter.child("surface"))
                        .and_then(|surface| surface.child("init_from"));
                    from.and_then(|from| self.document.find(from.text.trim()))
                }
            },
        };
        let image = found.filter(|found| found.tag == "image");
        if image.is_none() {
            let message = format!("'{named}' leads to no image: it is ignored");
            self.builder.warn("dae-texture", texture.place(), message);
        }
        Ok(image)
    }

    /// Reads the transparency in one of the modes of the format. A surface never disappears because of it: exporters write 0 for `A_ONE`, and 1
    /// for `RGB_ZERO`, for solid materials too.
    fn opacity(&mut self, model: &'a Element, name: &str) -> Result<Option<Opacity>, XmlError> {
        let factor = self.float(model, "transparency")?;
        let transparent = model.child("transparent");
        if factor.is_none() && transparent.is_none() {
            return Ok(None);
        }
        let factor = factor.unwrap_or(1.0);
        let mode = transparent
            .and_then(|element| element.get("opaque"))
            .unwrap_or("A_ONE");
        let opacity = match self.paint(model, "transparent")? {
            Some(Paint::Image { texture, .. }) if mode == "A_ONE" => {
                let texture = TextureUse::new(texture);
                let mask = TextureMask { texture, channel: 3 };
                return Ok(Opacity::new(factor, Some(mask), MASK_THRESHOLD));
            }
            Some(Paint::Image { .. }) => {
                let message = format!("an image as opacity of mode {mode} is not supported: it is solid");
                self.builder.warn("dae-opacity", name, message);
                return Ok(None);
            }
            paint => {
                let [r, g, b, a] = match paint {
                    Some(Paint::Color(color)) => color,
                    _ => [1.0; 4],
                };
                // The weights are the format's.
                let luminance = 0.212_671 * r + 0.715_16 * g + 0.072_169 * b;
                match mode {
                    "A_ONE" => a * factor,
                    "A_ZERO" => 1.0 - a * factor,
                    "RGB_ONE" => luminance * factor,
                    "RGB_ZERO" => 1.0 - luminance * factor,
                    _ => {
                        let message = format!("unknown mode of opacity {mode}: it is solid");
                        self.builder.warn("dae-opacity", name, message);
                        1.0
                    }
                }
            }
        };
        if let Some(problem) = Material::not_a_share("opacity", opacity) {
            self.builder.warn("material-value", name, problem);
        }
        if opacity <= 0.0 {
            let message =
                "its transparency makes it invisible, which is also written for solid materials: it is solid";
            self.builder.note("opaque", name, message);
            return Ok(None);
        }
        Ok(Opacity::new(opacity, None, 0.0))
    }
}
