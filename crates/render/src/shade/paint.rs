//! Materials and textures at a point of a surface.

use glam::{DVec2, DVec3, Vec3};
use oaktwin_scene::{Material, Mesh, MicroTexture, Scene, TextureUse};
use oaktwin_simd::Level;

use super::filter::{Footprints, Wraps};
use super::grain;
use super::optic::Optic;
use super::pyramid::Pyramid;
use super::surfaces::{Columns, PacketSurfaces, Spot, corner_values, lane_of, set_lane};
use super::textures::Textures;

/// The linear colour of surfaces without one: a perceptual middle grey.
const GREY: Vec3 = Vec3::splat(0.4);

/// The light by which surfaces are seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Band {
    /// Colours.
    Visible,
    /// What stereo cameras and time of flight see: surfaces whose reflectance at 940 nm is given have it, and others their colours.
    Infrared,
}

/// A material with its decoded texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint<'a> {
    /// The reflectance at 940 nm, if it is given.
    infrared: Option<f32>,
    /// The colour instead of all others.
    even: Option<Vec3>,
    base_color: Option<Vec3>,
    texture: Option<(TextureUse, &'a Pyramid)>,
    is_texture_missing: bool,
    emissive: Vec3,
    metallic: f32,
    roughness: f32,
    optic: Option<Optic>,
}

/// The material properties at eight points.
#[derive(Clone, Debug, Default)]
pub(super) struct Finishes {
    pub(super) color: Columns,
    pub(super) emissive: Columns,
    pub(super) metallic: [f32; 8],
    pub(super) roughness: [f32; 8],
}

impl Finishes {
    #[inline]
    fn set_color(&mut self, lane: usize, color: Vec3) {
        set_lane(&mut self.color, lane, color);
    }

    /// Sets one of eight lanes to a paint with a base colour.
    #[inline]
    pub(super) fn set(&mut self, lane: usize, paint: &Paint<'_>, color: Vec3) {
        self.set_color(lane, color);
        set_lane(&mut self.emissive, lane, paint.emissive);
        self.metallic[lane & 7] = paint.metallic;
        self.roughness[lane & 7] = paint.roughness;
    }
}

impl<'a> Paint<'a> {
    /// The paint of a surface without a material.
    pub(super) const BARE: Self = Self {
        infrared: None,
        even: None,
        base_color: None,
        texture: None,
        is_texture_missing: false,
        emissive: Vec3::ZERO,
        metallic: 0.0,
        roughness: 0.6,
        optic: None,
    };

    pub(super) fn new(material: &Material, textures: &'a Textures, band: Band) -> Self {
        let infrared = material.infrared.filter(|value| (0.0..=1.0).contains(value));
        let even = infrared.filter(|_| band == Band::Infrared).map(Vec3::splat);
        let texture = material
            .base_color_texture
            .filter(|_| even.is_none())
            .and_then(|used| Some((used, textures.ready(used.texture)?)));
        let number = |value: f32| {
            if value.is_finite() {
                value.clamp(0.0, 1.0)
            } else {
                0.0
            }
        };
        Self {
            infrared,
            even,
            base_color: material.base_color.map(|color| sane(color.into())),
            texture,
            is_texture_missing: material.base_color_texture.is_some() && texture.is_none(),
            emissive: sane(material.emissive.into()),
            metallic: number(material.metallic),
            roughness: number(material.roughness),
            optic: Optic::new(material),
        }
    }

    /// Returns the colour at a place on a visible triangle.
    pub(super) fn color(&self, mesh: &Mesh, triangle: u32, spot: &Spot, level: Level) -> Vec3 {
        match self.fill(mesh, triangle, spot) {
            Fill::Color(color) => color,
            Fill::Texture([at, across, down]) => {
                let mut footprints = Footprints::default();
                footprints.set(0, at, across, down);
                self.tinted(lane_of(&self.filtered(&footprints, 1, level), 0))
            }
        }
    }

    /// Returns the reflectance at 940 nm, if it is given.
    pub(super) fn infrared(&self) -> Option<f32> {
        self.infrared
    }

    pub(super) fn metallic(&self) -> f32 {
        self.metallic
    }

    /// Returns the properties of a surface that reflects rays or lets them pass.
    #[inline]
    pub(super) fn optic(&self) -> Option<&Optic> {
        self.optic.as_ref()
    }

    /// Whether the colours of places are those of a texture.
    pub(super) const fn is_textured(&self) -> bool {
        self.texture.is_some()
    }

    #[inline]
    fn fill(&self, mesh: &Mesh, triangle: u32, spot: &Spot) -> Fill {
        if let Some(color) = self.even {
            return Fill::Color(color);
        }
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        if let Some((used, pyramid)) = &self.texture {
            // Without texture coordinates the mean of the texture is used.
            return match corner_values(mesh.uvs.as_ref(), mesh, triangle) {
                Some(corners) => Fill::Texture(footprint(used, corners, spot)),
                None => Fill::Color(self.tinted(pyramid.mean().into())),
            };
        }
        if self.is_texture_missing {
            return Fill::Color(factor * GREY);
        }
        Fill::Color(match corner_values(mesh.colors.as_ref(), mesh, triangle) {
            Some([a, b, c]) => {
                let (a, b, c) = (Vec3::from(a), Vec3::from(b), Vec3::from(c));
                let color = a + (b - a) * spot.at[0] + (c - a) * spot.at[1];
                sane(color) * factor
            }
            None => self.base_color.unwrap_or(GREY),
        })
    }

    /// Filters the texture over the footprints of the lanes with a bit in `used`.
    fn filtered(&self, footprints: &Footprints, used: u32, level: Level) -> Columns {
        self.texture
            .as_ref()
            .map_or(Columns::default(), |(texture, pyramid)| {
                let wraps = Wraps {
                    s: texture.wrap_s,
                    t: texture.wrap_t,
                };
                pyramid.filtered(level, footprints, wraps, used)
            })
    }

    /// Returns the colour of a texture's value.
    #[inline]
    fn tinted(&self, read: Vec3) -> Vec3 {
        let (scale, bias) = self
            .texture
            .as_ref()
            .map_or((Vec3::ONE, Vec3::ZERO), |(used, _)| {
                (rgb(used.scale), rgb(used.bias))
            });
        sane((read * scale + bias) * self.base_color.unwrap_or(Vec3::ONE))
    }

    /// Returns the mean linear colour of a triangle, from its whole texture or from its corners.
    pub(super) fn flat(&self, mesh: &Mesh, triangle: usize) -> Vec3 {
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        if let Some((_, pyramid)) = self.texture {
            return self.tinted(pyramid.mean().into());
        }
        let vertices = mesh.triangles.get(triangle).copied();
        let colors = vertices.and_then(|vertices| mesh.colors.as_ref()?.corners(triangle, vertices));
        match colors.filter(|_| !self.is_texture_missing) {
            Some(corners) => factor * corners.map(|color| sane(color.into())).into_iter().sum::<Vec3>() / 3.0,
            None => self
                .base_color
                .filter(|_| !self.is_texture_missing)
                .unwrap_or(factor * GREY),
        }
    }
}

/// The colour of a place, or the place's footprint in the texture: the coordinates and their differences to the pixels to the
/// right and below.
enum Fill {
    Color(Vec3),
    Texture([[f32; 2]; 3]),
}

/// Returns the properties at the surfaces of a packet.
#[inline]
pub(super) fn finishes(
    paints: &[Paint<'_>],
    found: &PacketSurfaces<'_, '_>,
    grain: Option<&MicroTexture>,
    level: Level,
) -> Finishes {
    let mut finishes = Finishes::default();
    let mut materials = [u32::MAX; 8];
    let mut footprints = Footprints::default();
    let mut textured = 0u32;
    for lane in 0..found.count() {
        let triangle = found.triangle(lane);
        let material = found.material(lane).unwrap_or(u32::MAX);
        materials[lane & 7] = material;
        let paint = paints.get(material as usize).unwrap_or(&Paint::BARE);
        let color = match paint.fill(found.mesh, triangle, &found.spot(lane)) {
            Fill::Color(color) => match (grain, found.grained(lane)) {
                (Some(grain), Some((point, footprint))) => {
                    color * grain::factor(grain, found.surface(), point, footprint)
                }
                _ => color,
            },
            Fill::Texture([at, across, down]) => {
                footprints.set(lane, at, across, down);
                textured |= 1 << lane;
                Vec3::ZERO
            }
        };
        finishes.set(lane, paint, color);
    }
    // One material at a time.
    while textured != 0 {
        let material = materials[textured.trailing_zeros() as usize & 7];
        let mut used = 0;
        for (lane, other) in materials.iter().enumerate() {
            used |= u32::from(*other == material) << lane;
        }
        used &= textured;
        textured &= !used;
        let Some(paint) = paints.get(material as usize) else {
            continue;
        };
        let read = paint.filtered(&footprints, used, level);
        for lane in 0..8 {
            if (used >> lane) & 1 != 0 {
                finishes.set_color(lane, paint.tinted(lane_of(&read, lane)));
            }
        }
    }
    finishes
}

/// Returns the texture coordinates of a place, and their differences to the pixels to the right and below.
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "texture coordinates are float32")]
fn footprint(used: &TextureUse, [a, b, c]: [[f32; 2]; 3], spot: &Spot) -> [[f32; 2]; 3] {
    let [a, b, c] = [wide(a), wide(b), wide(c)];
    // Relative to the first corner, so that large coordinates keep their fractions.
    let (ab, ac) = (b - a, c - a);
    let along = |[b, c]: [f32; 2]| ab * f64::from(b) + ac * f64::from(c);
    let [x, y] = used.image_from_uv;
    let (x, y) = (DVec3::from(x.map(f64::from)), DVec3::from(y.map(f64::from)));
    let turned = |uv: DVec2, w: f64| {
        let uv = uv.extend(w);
        [x.dot(uv) as f32, y.dot(uv) as f32]
    };
    [
        turned(a + along(spot.at), 1.0),
        turned(along(spot.across), 0.0),
        turned(along(spot.down), 0.0),
    ]
}

#[inline]
fn rgb([r, g, b, _]: [f32; 4]) -> Vec3 {
    Vec3::new(r, g, b)
}

#[inline]
fn wide([u, v]: [f32; 2]) -> DVec2 {
    DVec2::new(f64::from(u), f64::from(v))
}

/// Clamps a colour to 0 to 1e4; NaN and infinity become 0.
#[inline]
fn sane(color: Vec3) -> Vec3 {
    let sane = |value: f32| {
        if value.is_finite() {
            value.clamp(0.0, 1e4)
        } else {
            0.0
        }
    };
    Vec3::new(sane(color.x), sane(color.y), sane(color.z))
}

/// Returns the paints of a scene's materials.
pub(super) fn paints<'a>(scene: &Scene, textures: &'a Textures, band: Band) -> Vec<Paint<'a>> {
    (scene.materials.iter())
        .map(|material| Paint::new(material, textures, band))
        .collect()
}
