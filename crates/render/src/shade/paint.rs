//! What colour a surface has of itself.

use glam::Vec3;
use oaktwin_scene::{Material, Scene, TextureUse};

use super::pyramid::{Pyramid, Wraps};
use super::textures::Textures;
use crate::annotate::Surface;

/// What stands for a colour that nobody knows, linear: a middle grey to the eye.
const GREY: Vec3 = Vec3::splat(0.4);

/// A material with its textures at hand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint<'a> {
    base_color: Option<Vec3>,
    texture: Option<(TextureUse, &'a Pyramid)>,
    /// It has a texture, which is not there.
    is_torn: bool,
    emissive: Vec3,
    metallic: f32,
    roughness: f32,
}

/// A surface's own properties at a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finish {
    pub(super) color: Vec3,
    pub(super) emissive: Vec3,
    pub(super) metallic: f32,
    pub(super) roughness: f32,
}

impl<'a> Paint<'a> {
    /// Of a surface without a material.
    pub(super) const BARE: Self = Self {
        base_color: None,
        texture: None,
        is_torn: false,
        emissive: Vec3::ZERO,
        metallic: 0.0,
        roughness: 0.6,
    };

    pub(super) fn new(material: &Material, textures: &'a Textures) -> Self {
        let texture = material
            .base_color_texture
            .and_then(|used| Some((used, textures.ready(used.texture)?)));
        let number = |value: f32| {
            if value.is_finite() {
                value.clamp(0.0, 1.0)
            } else {
                0.0
            }
        };
        Self {
            base_color: material.base_color.map(sane),
            texture,
            is_torn: material.base_color_texture.is_some() && texture.is_none(),
            emissive: sane(material.emissive),
            metallic: number(material.metallic),
            roughness: number(material.roughness),
        }
    }

    /// At a place of a surface, `neighbours` being the shares of the triangle's corners where the next pixels' rays to
    /// the right and below meet its plane.
    pub(super) fn at(&self, surface: &Surface<'_>, triangle: u32, neighbours: [[f64; 3]; 2]) -> Finish {
        Finish {
            color: self.color(surface, triangle, neighbours),
            emissive: self.emissive,
            metallic: self.metallic,
            roughness: self.roughness,
        }
    }

    fn color(&self, surface: &Surface<'_>, triangle: u32, neighbours: [[f64; 3]; 2]) -> Vec3 {
        let triangle = triangle as usize;
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        let Some(vertices) = surface.mesh.triangles.get(triangle).copied() else {
            return factor * GREY;
        };
        if let Some((used, pyramid)) = self.texture {
            let uvs = surface.mesh.uvs.as_ref();
            // A texture without coordinates shows its mean.
            let corners = uvs.and_then(|uvs| uvs.corners(triangle, vertices));
            let read = match corners {
                Some(corners) => read(used, pyramid, surface, corners, neighbours),
                None => pyramid.mean(),
            };
            let scaled = Vec3::from(read) * Vec3::from(used.scale) + Vec3::from(used.bias);
            return sane((scaled * factor).to_array());
        }
        if self.is_torn {
            return factor * GREY;
        }
        let colors = surface.mesh.colors.as_ref();
        match colors.and_then(|colors| colors.corners(triangle, vertices)) {
            Some(corners) => {
                let [r, g, b] = surface.interpolated(corners);
                #[expect(clippy::cast_possible_truncation, reason = "colours are float32")]
                {
                    sane([r as f32, g as f32, b as f32]) * factor
                }
            }
            None => self.base_color.unwrap_or(GREY),
        }
    }
}

fn read(
    used: TextureUse,
    pyramid: &Pyramid,
    surface: &Surface<'_>,
    corners: [[f32; 2]; 3],
    neighbours: [[f64; 3]; 2],
) -> [f32; 3] {
    // Relative to the first corner, so that large coordinates keep their fractions.
    let [a, b, c] = corners.map(|uv| image_from_uv(&used, uv));
    let edges = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
    let offset = |weights: [f64; 3]| -> [f64; 2] {
        std::array::from_fn(|i| edges[0][i] * weights[1] + edges[1][i] * weights[2])
    };
    let here = offset(surface.weights);
    let [across, down] = neighbours.map(|weights| {
        let there = offset(weights);
        let step = glam::DVec2::new(there[0] - here[0], there[1] - here[1]);
        // A neighbour that does not meet the plane says nothing.
        if step.is_finite() {
            step.as_vec2()
        } else {
            glam::Vec2::ZERO
        }
    });
    let at = glam::DVec2::new(a[0] + here[0], a[1] + here[1]).as_vec2();
    let wraps = Wraps {
        s: used.wrap_s,
        t: used.wrap_t,
    };
    pyramid.filtered(at, across, down, wraps)
}

fn image_from_uv(used: &TextureUse, [u, v]: [f32; 2]) -> [f64; 2] {
    let (u, v) = (f64::from(u), f64::from(v));
    (used.image_from_uv).map(|[a, b, c]| f64::from(a) * u + f64::from(b) * v + f64::from(c))
}

/// Neither negative nor endless.
fn sane(color: [f32; 3]) -> Vec3 {
    Vec3::from(color.map(|value| {
        if value.is_finite() {
            value.clamp(0.0, 1e4)
        } else {
            0.0
        }
    }))
}

/// The materials of a scene, ready to paint with.
pub(super) fn paints<'a>(scene: &Scene, textures: &'a Textures) -> Vec<Paint<'a>> {
    (scene.materials.iter())
        .map(|material| Paint::new(material, textures))
        .collect()
}
