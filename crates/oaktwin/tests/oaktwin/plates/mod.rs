//! Uniformly lit plates in front of a camera at the origin that faces along x.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::sync::Arc;

use oaktwin::camera::math::DAffine3;
use oaktwin::image::Image;
use oaktwin::scene::{
    ColorSpace, Instance, Light, LightKind, Material, MaterialSpan, Mesh, MeshAttribute, Scene, Texture,
    TextureSource, TextureUse,
};

/// A room without plates; its pattern has `squares` squares per side, uniform grey or random.
pub(crate) fn room(squares: u32, grey: Option<u8>) -> Scene {
    let mut state = 1u32;
    let pixels = (0..squares * squares).map(|_| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let grey = grey.unwrap_or_else(|| u8::try_from(state >> 24).unwrap());
        [grey, grey, grey, 255]
    });
    Scene {
        materials: vec![Material {
            base_color_texture: Some(TextureUse::new(0)),
            roughness: 1.0,
            ..Material::default()
        }],
        textures: vec![Texture {
            source: TextureSource::Pixels(Arc::new(Image::new(squares, squares, pixels.collect()).unwrap())),
            color_space: ColorSpace::Srgb,
        }],
        lights: vec![Light {
            path: "/Sky".to_owned(),
            kind: LightKind::Dome { texture: None },
            radiance: [1.0; 3],
            normalize: false,
            world_from_light: DAffine3::IDENTITY,
        }],
        ..Scene::default()
    }
}

/// A rectangle at x = `x` metres, between `y[0]` and `y[1]` (left) and `z[0]` and `z[1]` (up); the width of its pattern is
/// `pattern` metres.
pub(crate) fn plate(scene: &mut Scene, x: f32, y: [f32; 2], z: [f32; 2], pattern: f32) {
    let corners = [[y[0], z[0]], [y[1], z[0]], [y[1], z[1]], [y[0], z[1]]];
    scene.instances.push(Instance {
        mesh: u32::try_from(scene.meshes.len()).unwrap(),
        path: format!("/Plate{}", scene.meshes.len()),
        world_from_mesh: DAffine3::IDENTITY,
        labels: Vec::new(),
        material_offset: 0,
    });
    scene.meshes.push(Mesh {
        positions: corners.map(|[y, z]| [x, y, z]).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        uvs: Some(MeshAttribute::Vertex(
            corners.map(|corner| corner.map(|c| c / pattern)).to_vec(),
        )),
        materials: vec![MaterialSpan {
            end: 2,
            material: Some(0),
        }],
        double_sided: true,
        ..Mesh::default()
    });
}
