//! The models of objects, as formats describe them.

use std::sync::Arc;

use oaktwin_camera::math::DVec3;
use oaktwin_dataset::{Model, Paint};
use oaktwin_image::Image;
use oaktwin_image::srgb::{linear_from_srgb, srgb_from_linear};
use oaktwin_pipeline::render::texture_pixels;
use oaktwin_scene::{Material, Mesh, MeshAttribute, Scene};

use crate::arrange::Placed;
use crate::world::Triangles;

/// The grey of surfaces without a colour, as in renderings.
const GREY: f32 = 0.4;

/// Creates the model of a placed object: all of its meshes, in metres with the file's axes, and the file's own colours.
#[expect(
    clippy::cast_possible_truncation,
    reason = "geometry is float32, and numbers of files are u32"
)]
pub(crate) fn model_of(object: &Placed, name: &str) -> Model {
    let scene = &object.asset.scene;
    let Triangles { points, corners, .. } = Triangles::of(scene);
    let scaled = |point: DVec3| (point * object.scale).to_array().map(|x| x as f32);
    Model {
        id: object.entry as u32 + 1,
        name: name.to_owned(),
        label: object.label.clone(),
        positions: points.into_iter().map(scaled).collect(),
        triangles: corners,
        paint: textured(scene).unwrap_or_else(|| colored(scene)),
    }
}

/// Calls a function for each triangle of a scene, with its mesh and its material.
fn each_triangle<'a>(
    scene: &'a Scene,
    mut call: impl FnMut(&'a Mesh, usize, [u32; 3], Option<&'a Material>),
) {
    for instance in &scene.instances {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        for ((at, corners), index) in mesh.triangles.iter().enumerate().zip(0_u32..) {
            let material = instance.material(mesh.material(index));
            let material = material.and_then(|material| scene.materials.get(material as usize));
            call(mesh, at, *corners, material);
        }
    }
}

/// Returns the texture of a scene, if all triangles have the same one.
fn textured(scene: &Scene) -> Option<Paint> {
    let (mut uvs, mut common, mut is_common) = (Vec::new(), None, true);
    each_triangle(scene, |mesh, at, corners, material| {
        let used = material.and_then(|material| {
            material
                .base_color_texture
                .map(|used| (used, material.base_color))
        });
        let own = corners_of(mesh.uvs.as_ref(), at, corners);
        let (Some(used), Some(own)) = (used, own) else {
            is_common = false;
            return;
        };
        is_common &= *common.get_or_insert(used) == used;
        let [x, y] = used.0.image_from_uv;
        let place = |row: [f32; 3], [u, v]: [f32; 2]| row[0] * u + row[1] * v + row[2];
        uvs.push(own.map(|uv| [place(x, uv), place(y, uv)]));
    });
    let (used, color) = common.filter(|_| is_common)?;
    let texture = scene.textures.get(used.texture as usize)?;
    // A texture that cannot be read is reported when it is rendered.
    let image = texture_pixels(texture).ok()?;
    let tint = color.unwrap_or([1.0; 3]);
    let is_plain = tint == [1.0; 3] && used.scale == [1.0; 4] && used.bias == [0.0; 4];
    let image = if is_plain {
        image
    } else {
        let linear = linear_from_srgb();
        image.map(|[r, g, b, a]| {
            let read = [r, g, b].map(|byte| linear[usize::from(*byte)]);
            let [r, g, b] =
                [0, 1, 2].map(|i| srgb_from_linear((read[i] * used.scale[i] + used.bias[i]) * tint[i]));
            [r, g, b, *a]
        })
    };
    Some(Paint::Texture {
        uvs,
        image: Arc::<Image<[u8; 4]>>::new(image),
    })
}

/// Returns the colours of a scene without textures.
fn colored(scene: &Scene) -> Paint {
    let mut colors = Vec::new();
    each_triangle(scene, |mesh, at, corners, material| {
        let base = material.and_then(|material| material.base_color);
        let own = corners_of(mesh.colors.as_ref(), at, corners);
        let grey = base.unwrap_or([GREY; 3]);
        let corner = |color: [f32; 3]| color.map(srgb_from_linear);
        colors.push(match own {
            Some(own) => own.map(|color| {
                let factor = base.unwrap_or([1.0; 3]);
                corner([0, 1, 2].map(|i| color[i] * factor[i]))
            }),
            None => [corner(grey); 3],
        });
    });
    Paint::Corners(colors)
}

fn corners_of<T: Copy>(attribute: Option<&MeshAttribute<T>>, at: usize, corners: [u32; 3]) -> Option<[T; 3]> {
    attribute?.corners(at, corners)
}
