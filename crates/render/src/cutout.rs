//! Surfaces that are cut out by the opacity of their material, or let light pass.
//!
//! Single rays pass through the parts that are invisible, and on request through the clear ones. Images are rendered as if all surfaces
//! were solid; then `through` finds what lies behind.

mod mask;
mod transparent;

use std::collections::BTreeMap;
use std::sync::Arc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Opacity, Scene, TextureMask};

use self::mask::MaskImage;
pub use self::transparent::Transparent;
use crate::barycentric::clamped;
use crate::visibility::Hit;

/// A texture and one of its channels.
type Key = (u32, u8);

/// The masks of a scene's materials.
#[derive(Debug)]
pub(crate) struct Cutouts {
    cuts: Vec<Option<Cut>>,
    images: BTreeMap<Key, Result<Arc<MaskImage>, Finding>>,
}

/// The opacity of a material.
#[derive(Debug)]
struct Cut {
    opacity: Option<Opacity>,
    image: Option<Arc<MaskImage>>,
    /// The share of light that the solid parts transmit, which multiplies its mask if there is one.
    transmits: f32,
    transmission: Option<(TextureMask, Arc<MaskImage>)>,
}

/// The share of transmitted light above which a surface is clear: it casts no shadow, and what lies behind it can be the ground truth.
const CLEAR: f32 = 0.5;

impl Cutouts {
    /// Whether a scene has any surface that may be invisible or clear.
    pub(crate) fn are_in(scene: &Scene) -> bool {
        let mut materials = scene.materials.iter();
        materials.any(|material| material.opacity.is_some() || material.transmission.is_some())
    }

    /// Decodes the masks of a scene, except those known from an earlier state of it; `None` if all surfaces are solid.
    pub(crate) fn new(scene: &Scene, known: Option<Self>) -> Option<Self> {
        if !Self::are_in(scene) {
            return None;
        }
        let mut images = known.map(|known| known.images).unwrap_or_default();
        let cuts = scene.materials.iter().map(|material| {
            let (opacity, transmission) = (material.opacity, material.transmission);
            if opacity.is_none() && transmission.is_none() {
                return None;
            }
            let mut image = |mask: TextureMask, otherwise| {
                let key = (mask.texture.texture, mask.channel);
                let texture = scene.textures.get(mask.texture.texture as usize)?;
                let image = images
                    .entry(key)
                    .or_insert_with(|| MaskImage::new(texture, mask.channel, otherwise).map(Arc::new));
                image.as_ref().ok().cloned()
            };
            let of_opacity = opacity.and_then(|opacity| image(opacity.mask?, "the surface is solid"));
            let of_transmission = transmission.and_then(|transmission| {
                let mask = transmission.mask?;
                Some((
                    mask,
                    image(mask, "all of the surface transmits its share of light")?,
                ))
            });
            let transmits = transmission.map_or(0.0, |transmission| transmission.share.clamp(0.0, 1.0));
            Some(Cut {
                opacity,
                image: of_opacity,
                transmits: transmits * (1.0 - material.metallic.clamp(0.0, 1.0)),
                transmission: of_transmission,
            })
        });
        let cuts = cuts.collect();
        Some(Self { cuts, images })
    }

    /// Returns the masks that cannot be read.
    pub(crate) fn findings(&self) -> impl Iterator<Item = &Finding> {
        self.images.values().filter_map(|image| image.as_ref().err())
    }

    /// Whether some part of an instance may be invisible.
    pub(crate) fn cut_instance(&self, scene: &Scene, instance: u32) -> bool {
        let placed = scene.instances.get(instance as usize);
        let mesh = placed.and_then(|placed| scene.meshes.get(placed.mesh as usize));
        let (Some(placed), Some(mesh)) = (placed, mesh) else {
            return false;
        };
        let materials = (mesh.materials.iter()).filter_map(|span| placed.material(span.material));
        materials
            .filter_map(|material| self.cuts.get(material as usize))
            .any(Option::is_some)
    }

    /// Whether a triangle is visible where a ray in the world meets it. What does not exist counts as visible.
    #[inline]
    pub(crate) fn shows(
        &self,
        scene: &Scene,
        hit: Hit,
        origin: DVec3,
        direction: DVec3,
        transparent: Transparent,
    ) -> bool {
        let Some(cut) = self.cut(scene, hit) else {
            return true;
        };
        let opacity = cut.opacity_at(scene, hit, origin, direction);
        let transmits = || cut.transmits * cut.transmission_at(scene, hit, origin, direction);
        let passes = || 1.0 - opacity * (1.0 - transmits());
        opacity > 0.0 && (transparent == Transparent::Surface || passes() <= CLEAR)
    }

    /// Returns the opacity, from 0 to 1, of a triangle where a ray in the world meets it, without the light that it transmits, and the factor of
    /// its material's transmission there.
    #[inline]
    pub(crate) fn opacity(&self, scene: &Scene, hit: Hit, origin: DVec3, direction: DVec3) -> [f32; 2] {
        self.cut(scene, hit).map_or([1.0; 2], |cut| {
            [
                cut.opacity_at(scene, hit, origin, direction),
                cut.transmission_at(scene, hit, origin, direction),
            ]
        })
    }

    #[inline]
    fn cut(&self, scene: &Scene, hit: Hit) -> Option<&Cut> {
        let placed = scene.instances.get(hit.instance as usize)?;
        let mesh = scene.meshes.get(placed.mesh as usize)?;
        let material = placed.material(mesh.material(hit.triangle))?;
        self.cuts.get(material as usize)?.as_ref()
    }
}

impl Cut {
    fn opacity_at(&self, scene: &Scene, hit: Hit, origin: DVec3, direction: DVec3) -> f32 {
        let Some(opacity) = &self.opacity else {
            return 1.0;
        };
        let mask = || {
            let (mask, image) = (opacity.mask.as_ref()?, self.image.as_ref()?);
            Some(image.value(mask, uv_at(scene, hit, origin, direction)?))
        };
        opacity.at(mask().unwrap_or(1.0))
    }

    /// Returns the factor, from 0 to 1, of the light that passes the solid parts.
    fn transmission_at(&self, scene: &Scene, hit: Hit, origin: DVec3, direction: DVec3) -> f32 {
        let Some((mask, image)) = &self.transmission else {
            return 1.0;
        };
        let uv = uv_at(scene, hit, origin, direction);
        uv.map_or(1.0, |uv| image.value(mask, uv).clamp(0.0, 1.0))
    }
}

/// Returns the texture coordinates of a triangle where a ray in the world meets it.
fn uv_at(scene: &Scene, hit: Hit, origin: DVec3, direction: DVec3) -> Option<[f64; 2]> {
    let placed = scene.instances.get(hit.instance as usize)?;
    let mesh = scene.meshes.get(placed.mesh as usize)?;
    let index = hit.triangle as usize;
    let uvs = mesh.uvs.as_ref()?.corners(index, *mesh.triangles.get(index)?)?;
    let corners = mesh.corners(index)?.map(|p| {
        placed
            .world_from_mesh
            .transform_point3(DVec3::from(p.map(f64::from)))
    });
    let weights = weights(corners, origin, direction);
    Some([0, 1].map(|axis| (0..3).map(|i| f64::from(uvs[i][axis]) * weights[i]).sum()))
}

/// Returns the barycentric coordinates where a ray meets the plane of a triangle, clamped to the triangle.
#[inline]
fn weights([a, b, c]: [DVec3; 3], origin: DVec3, direction: DVec3) -> [f64; 3] {
    let [a, b, c] = [a - origin, b - origin, c - origin];
    let sides = [b.cross(c), c.cross(a), a.cross(b)].map(|side| side.dot(direction));
    let whole: f64 = sides.iter().sum();
    clamped(sides.map(|side| side / whole))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use oaktwin_image::Image;
    use oaktwin_scene::{
        Material, MaterialSpan, Mesh, MeshAttribute, Texture, TextureMask, TextureSource, TextureUse, Wrap,
    };

    use super::*;
    use crate::{Backend, Ray, Renderer, fixture};

    /// A card at 2 m whose right half is invisible, beside one that is invisible as a whole, in front of a wall at 3 m.
    fn scene() -> Scene {
        let mut scene = Scene::default();
        let cards = [
            ([-0.5, 0.5], 2.0, Some(0)),
            ([0.6, 0.9], 2.5, Some(1)),
            ([-9.0, 9.0], 3.0, None),
        ];
        for (x, z, material) in cards {
            let mesh = Mesh {
                uvs: Some(MeshAttribute::Vertex(vec![
                    [0.0, 0.0],
                    [0.0, 1.0],
                    [1.0, 1.0],
                    [1.0, 0.0],
                ])),
                materials: vec![MaterialSpan { end: 2, material }],
                ..fixture::rectangle(x, [-0.5 * z, 0.5 * z], z)
            };
            fixture::placed(&mut scene, "/Card", mesh);
        }
        let pixels = vec![[0, 0, 0, 255], [0, 0, 0, 0]];
        scene.textures = vec![Texture {
            source: TextureSource::Pixels(Arc::new(Image::new(2, 1, pixels).unwrap())),
            color_space: Default::default(),
        }];
        let texture = TextureUse {
            wrap_s: Wrap::Clamp,
            ..TextureUse::new(0)
        };
        let cut = Opacity::new(1.0, Some(TextureMask { texture, channel: 3 }), 0.5);
        scene.materials = [cut, Opacity::new(0.0, None, 0.0)]
            .map(|opacity| Material {
                opacity,
                ..Material::default()
            })
            .to_vec();
        scene
    }

    #[test]
    fn images_show_what_is_behind_invisible_parts() {
        let scene = scene();
        let renderer = Renderer::new(scene.clone());
        for view in [fixture::view(), fixture::fisheye()] {
            for backend in [Backend::Ray, Backend::Raster] {
                let seen = renderer.visibility(&view, backend);
                assert_eq!(renderer.depth(&view, backend), seen.z);
                let rays = crate::rays::Rays::new(&view);
                let mut counts = [0; 4];
                for (x, y) in (0..160).flat_map(|y| (0..200).map(move |x| (x, y))) {
                    let ray = rays.centre(x, y).unwrap();
                    let at = |z: f64| ray * (z / ray.z);
                    let is_within = |z: f64, x: [f64; 2]| {
                        let point = at(z);
                        ray.z > 0.0 && point.x >= x[0] && point.x <= x[1] && point.y.abs() <= 0.5 * z
                    };
                    let (z, instance) = if is_within(2.0, [-0.5, 0.0]) {
                        (2.0, 0)
                    } else if is_within(3.0, [-9.0, 9.0]) {
                        (3.0, 2)
                    } else {
                        (f32::INFINITY, u32::MAX)
                    };
                    let found = *seen.z.0.get(x, y).unwrap();
                    assert!(
                        found == z || (found - z).abs() < 1e-6 * z,
                        "{view:?} {backend:?} {x} {y}: {found} {z}"
                    );
                    let hit = *seen.hits.get(x, y).unwrap();
                    assert_eq!(hit.instance, instance);
                    counts[instance.min(3) as usize] += 1;
                }
                assert!(
                    counts[0] > 900 && counts[1] == 0 && counts[2] > 5000,
                    "{counts:?}"
                );
            }
        }
    }

    #[test]
    fn rays_pass_through_invisible_parts() {
        let renderer = Renderer::new(scene());
        let ray = |x: f64| Ray {
            origin: DVec3::ZERO,
            direction: DVec3::new(x, 0.1, 1.0),
            near: 0.0,
            far: 2.9,
        };
        let rays = [ray(-0.1), ray(0.1), ray(0.3)];
        assert_eq!(renderer.occluded(&rays), [true, false, false]);
        let found = renderer.cast_rays(&rays.map(|ray| Ray { far: 9.0, ..ray }));
        let distances: Vec<f64> = found.iter().map(|found| found.unwrap().0).collect();
        assert!((distances[0] - 2.0).abs() < 1e-6 && distances[1..].iter().all(|z| (z - 3.0).abs() < 1e-6));
    }

    #[test]
    fn silhouettes_have_no_invisible_parts() {
        let renderer = Renderer::new(scene());
        let groups = [vec![0], vec![1], vec![2]];
        let sizes: Vec<usize> = (renderer.silhouettes(&fixture::view(), &groups).iter())
            .map(Vec::len)
            .collect();
        // The card is 50 pixels wide and 100 high; its left half is visible.
        assert_eq!(sizes, [25 * 100, 0, 200 * 100]);
    }

    #[test]
    fn replaced_materials_are_cut_anew() {
        let mut solid = scene();
        let materials = std::mem::take(&mut solid.materials);
        solid.materials = vec![Material::default(); 2];
        let (instances, lights) = (solid.instances.clone(), solid.lights.clone());
        let mut renderer = Renderer::new(solid.clone());
        let view = fixture::view();
        let before = renderer.depth(&view, Backend::Ray);
        renderer.place(instances.clone(), materials, lights.clone());
        let cut = renderer.depth(&view, Backend::Ray);
        assert_eq!(cut, Renderer::new(scene()).depth(&view, Backend::Ray));
        assert_ne!(cut, before);
        renderer.place(instances, solid.materials, lights);
        assert_eq!(renderer.depth(&view, Backend::Ray), before);
    }

    #[test]
    fn unread_masks_are_reported_and_solid() {
        let mut scene = scene();
        scene.textures[0].source = TextureSource::File("none.png".into());
        let renderer = Renderer::new(scene);
        let depth = renderer.depth(&fixture::view(), Backend::Auto);
        assert_eq!(depth.0.get(110, 80), Some(&2.0));
        let findings = renderer.unread_masks();
        assert_eq!(findings.len(), 1);
        assert!(
            findings[0].message.to_string().contains("the surface is solid"),
            "{findings:?}"
        );
    }
}
