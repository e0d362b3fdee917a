//! Materials and textures at a point of a surface.

use glam::{DVec2, Vec2, Vec3};
use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Material, Mesh, Scene, TextureUse};

use super::pyramid::{Pyramid, Wraps};
use super::textures::Textures;
use crate::annotate::Surface;

/// The linear colour of surfaces without one: a perceptual middle grey.
const GREY: Vec3 = Vec3::splat(0.4);

/// A material with its decoded texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint<'a> {
    base_color: Option<Vec3>,
    texture: Option<(TextureUse, &'a Pyramid)>,
    is_texture_missing: bool,
    emissive: Vec3,
    metallic: f32,
    roughness: f32,
}

/// The material properties at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finish {
    pub(super) color: Vec3,
    pub(super) emissive: Vec3,
    pub(super) metallic: f32,
    pub(super) roughness: f32,
}

impl<'a> Paint<'a> {
    /// The paint of a surface without a material.
    pub(super) const BARE: Self = Self {
        base_color: None,
        texture: None,
        is_texture_missing: false,
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
            is_texture_missing: material.base_color_texture.is_some() && texture.is_none(),
            emissive: sane(material.emissive),
            metallic: number(material.metallic),
            roughness: number(material.roughness),
        }
    }

    /// Returns the layer of a visible triangle.
    pub(super) fn layer(&self, surface: &Surface<'_>, triangle: u32) -> Layer<'a> {
        Layer {
            fill: self.fill(surface, triangle),
            emissive: self.emissive,
            metallic: self.metallic,
            roughness: self.roughness,
        }
    }

    /// Returns the mean linear colour of a triangle: that of its whole texture, or that of its corners.
    pub(super) fn flat(&self, mesh: &Mesh, triangle: usize) -> Vec3 {
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        if let Some((used, pyramid)) = self.texture {
            return self.mean_of(&used, pyramid);
        }
        let vertices = mesh.triangles.get(triangle).copied();
        let colors = vertices.and_then(|vertices| mesh.colors.as_ref()?.corners(triangle, vertices));
        match colors.filter(|_| !self.is_texture_missing) {
            Some(corners) => factor * corners.map(sane).into_iter().sum::<Vec3>() / 3.0,
            None => self
                .base_color
                .filter(|_| !self.is_texture_missing)
                .unwrap_or(factor * GREY),
        }
    }

    fn mean_of(&self, used: &TextureUse, pyramid: &Pyramid) -> Vec3 {
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        let (scale, bias) = (Vec3::from(used.scale), Vec3::from(used.bias));
        sane(((Vec3::from(pyramid.mean()) * scale + bias) * factor).to_array())
    }

    fn fill(&self, surface: &Surface<'_>, triangle: u32) -> Fill<'a> {
        let mesh = surface.mesh;
        let triangle = triangle as usize;
        let factor = self.base_color.unwrap_or(Vec3::ONE);
        let Some(vertices) = mesh.triangles.get(triangle).copied() else {
            return Fill::Plain(factor * GREY);
        };
        if let Some((used, pyramid)) = self.texture {
            let uvs = mesh.uvs.as_ref();
            let scale = Vec3::from(used.scale);
            let bias = Vec3::from(used.bias);
            // Without texture coordinates the mean of the texture is used.
            return match uvs.and_then(|uvs| uvs.corners(triangle, vertices)) {
                Some(corners) => Fill::Texture(Picture {
                    pyramid,
                    wraps: Wraps {
                        s: used.wrap_s,
                        t: used.wrap_t,
                    },
                    corners: Corners::new(&used, corners, surface.sides),
                    scale,
                    bias,
                    factor,
                }),
                None => Fill::Plain(self.mean_of(&used, pyramid)),
            };
        }
        if self.is_texture_missing {
            return Fill::Plain(factor * GREY);
        }
        let colors = mesh.colors.as_ref();
        match colors.and_then(|colors| colors.corners(triangle, vertices)) {
            Some(corners) => Fill::Corners { corners, factor },
            None => Fill::Plain(self.base_color.unwrap_or(GREY)),
        }
    }
}

/// The paint of one triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layer<'a> {
    fill: Fill<'a>,
    emissive: Vec3,
    metallic: f32,
    roughness: f32,
}

#[derive(Clone, Copy, Debug)]
enum Fill<'a> {
    Plain(Vec3),
    /// Interpolated colours of the corners.
    Corners {
        corners: [[f32; 3]; 3],
        factor: Vec3,
    },
    Texture(Picture<'a>),
}

/// The texture of a triangle.
#[derive(Clone, Copy, Debug)]
struct Picture<'a> {
    pyramid: &'a Pyramid,
    wraps: Wraps,
    corners: Corners,
    scale: Vec3,
    bias: Vec3,
    factor: Vec3,
}

/// The texture coordinates of a triangle's corners, relative to the first one so that large coordinates keep their fractions.
#[derive(Clone, Copy, Debug)]
struct Corners {
    first: DVec2,
    edges: [DVec2; 2],
    /// The homogeneous transform from a camera ray to texture coordinates.
    from_ray: [DVec3; 3],
}

impl Corners {
    fn new(used: &TextureUse, corners: [[f32; 2]; 3], [a_side, b_side, c_side]: [DVec3; 3]) -> Self {
        let [a, b, c] = corners.map(|uv| image_from_uv(used, uv));
        let (ab, ac) = (b - a, c - a);
        Self {
            first: a,
            edges: [ab, ac],
            from_ray: [
                b_side * ab.x + c_side * ac.x,
                b_side * ab.y + c_side * ac.y,
                a_side + b_side + c_side,
            ],
        }
    }

    /// Returns the offset from the first corner at barycentric coordinates.
    #[inline]
    fn offset(&self, weights: [f64; 3]) -> DVec2 {
        self.edges[0] * weights[1] + self.edges[1] * weights[2]
    }

    /// Returns the offset where a ray meets the triangle's plane; NaN or infinite where it does not.
    #[inline]
    fn offset_of(&self, ray: DVec3) -> DVec2 {
        let [u, v, whole] = &self.from_ray;
        DVec2::new(ray.dot(*u), ray.dot(*v)) * (1.0 / ray.dot(*whole))
    }

    /// Returns the difference to the point where a neighbour's ray meets the plane; 0 where it does not.
    #[inline]
    fn step(&self, here: DVec2, ray: Option<DVec3>) -> Vec2 {
        if let Some(ray) = ray {
            let step = self.offset_of(ray) - here;
            if step.is_finite() {
                return step.as_vec2();
            }
        }
        Vec2::ZERO
    }
}

impl Layer<'_> {
    /// Returns the properties at a point; `next` returns the rays, in the camera frame, of the pixels to the right and below.
    #[inline]
    pub(super) fn at(&self, surface: &Surface<'_>, next: impl Fn() -> [Option<DVec3>; 2]) -> Finish {
        let color = match &self.fill {
            Fill::Plain(color) => *color,
            Fill::Corners { corners, factor } => {
                let [r, g, b] = surface.interpolated(*corners);
                #[expect(clippy::cast_possible_truncation, reason = "colours are float32")]
                {
                    sane([r as f32, g as f32, b as f32]) * *factor
                }
            }
            Fill::Texture(picture) => picture.at(surface, next()),
        };
        Finish {
            color,
            emissive: self.emissive,
            metallic: self.metallic,
            roughness: self.roughness,
        }
    }
}

impl Picture<'_> {
    #[inline]
    fn at(&self, surface: &Surface<'_>, next: [Option<DVec3>; 2]) -> Vec3 {
        let here = self.corners.offset(surface.weights);
        let [right, below] = next;
        let (across, down) = (self.corners.step(here, right), self.corners.step(here, below));
        let at = (self.corners.first + here).as_vec2();
        let read = self.pyramid.filtered(at, across, down, self.wraps);
        sane(((Vec3::from(read) * self.scale + self.bias) * self.factor).to_array())
    }
}

fn image_from_uv(used: &TextureUse, [u, v]: [f32; 2]) -> DVec2 {
    let (u, v) = (f64::from(u), f64::from(v));
    let [x, y] = (used.image_from_uv).map(|[a, b, c]| f64::from(a) * u + f64::from(b) * v + f64::from(c));
    DVec2::new(x, y)
}

/// Clamps a colour to 0 to 1e4; NaN and infinity become 0.
fn sane(color: [f32; 3]) -> Vec3 {
    Vec3::from(color.map(|value| {
        if value.is_finite() {
            value.clamp(0.0, 1e4)
        } else {
            0.0
        }
    }))
}

/// Returns the paints of a scene's materials.
pub(super) fn paints<'a>(scene: &Scene, textures: &'a Textures) -> Vec<Paint<'a>> {
    (scene.materials.iter())
        .map(|material| Paint::new(material, textures))
        .collect()
}
