//! Reflectances at 940 nm, and what comes back to a time-of-flight camera.

use oaktwin_image::annotation::Returns;
use oaktwin_scene::Opacity;

use super::optics::{add, dark_room, mirror};
use super::*;
use crate::{Beam, BeamPattern};

/// The luma of the sRGB of a linear grey.
fn estimated(grey: f32) -> f32 {
    f32::from(srgb_from_linear(grey)) / 255.0
}

fn matt(grey: f32, infrared: Option<f32>) -> Material {
    Material {
        base_color: Some([grey; 3]),
        roughness: 1.0,
        infrared,
        ..Material::default()
    }
}

/// The depths and the strengths of a pixel.
fn returns_at(returns: &Returns, [x, y]: [u32; 2]) -> [[f32; 2]; 2] {
    let at = |images: &[Image<f32>; 2]| images.each_ref().map(|image| *image.get(x, y).unwrap());
    [at(&returns.depths), at(&returns.strengths)]
}

fn returns(scene: &Scene, view: &View) -> Returns {
    Renderer::new(scene.clone()).returns(view, Backend::Auto).unwrap()
}

fn assert_close(found: f32, expected: f32, tolerance: f32) {
    assert!(
        (found - expected).abs() <= tolerance * expected,
        "{found} {expected}"
    );
}

struct Even;

impl BeamPattern for Even {
    fn luminance(&self, _: [f32; 2]) -> f32 {
        1.0
    }

    fn is_dark_around(&self, _: [f32; 2], _: f32) -> bool {
        false
    }
}

/// A black plate on the left and a white one on the right exchange their brightness, in the light of the room and of the projector, while
/// the colours stay.
#[test]
fn pairs_see_the_reflectance_and_colours_do_not() {
    let plates = |infrared: [Option<f32>; 2]| {
        let mut scene = dark_room();
        scene.lights[0].world_from_light = DAffine3::from_translation(DVec3::new(0.0, 0.0, -60.0));
        add(
            &mut scene,
            rectangle([-3.0, 0.0], [-3.0, 3.0], 2.0),
            matt(0.02, infrared[0]),
        );
        add(
            &mut scene,
            rectangle([0.0, 3.0], [-3.0, 3.0], 2.0),
            matt(0.8, infrared[1]),
        );
        scene
    };
    let (plain, other) = (plates([None; 2]), plates([Some(0.6), Some(0.05)]));
    assert_eq!(rgb(&plain, &view()), rgb(&other, &view()));
    let beam = Beam {
        world_from_beam: RigidTransform::IDENTITY,
        pattern: &Even,
    };
    let seen = |scene: &Scene| {
        let renderer = Renderer::new(scene.clone());
        let (light, _) = renderer.luminance(&view(), Backend::Auto, Some(&beam));
        let beam = light.beam.unwrap();
        [60, 140].map(|x| [*light.scene.get(x, 80).unwrap(), *beam.get(x, 80).unwrap()])
    };
    let (before, after) = (seen(&plain), seen(&other));
    for (plate, (colour, infrared)) in [(0.02, 0.6), (0.8, 0.05)].into_iter().enumerate() {
        // Rough surfaces also reflect 4 % of their surroundings, whatever their colour is.
        let [before, after] = [before[plate], after[plate]];
        assert_close(after[1] / before[1], infrared / colour, 1e-4);
        let least = 0.04 * 0.22;
        assert_close((after[0] - least) / (before[0] - least), infrared / colour, 0.05);
    }
    let renderer = Renderer::new(plain.clone());
    assert!(!renderer.has_infrared() && renderer.infrared(&view(), Backend::Auto).is_none());
    let picture = Renderer::new(other).infrared(&view(), Backend::Auto).unwrap();
    let [left, right] = [60, 140].map(|x| u32::from(picture.get(x, 80).unwrap()[1]));
    assert!(left > 2 * right && left > 120, "{left} {right}");
}

/// A textured surface becomes even.
#[test]
fn a_reflectance_replaces_the_texture() {
    let mut scene = dark_room();
    let pixels = Image::new(2, 1, vec![[255, 255, 255, 255], [0, 0, 0, 255]]).unwrap();
    scene.textures.push(Texture {
        source: TextureSource::Pixels(Arc::new(pixels)),
        color_space: ColorSpace::Auto,
    });
    let mut plate = rectangle([-3.0, 3.0], [-3.0, 3.0], 2.0);
    plate.uvs = Some(MeshAttribute::Vertex(vec![
        [0.0, 0.0],
        [0.0, 1.0],
        [1.0, 1.0],
        [1.0, 0.0],
    ]));
    let material = Material {
        base_color: None,
        base_color_texture: Some(TextureUse::new(0)),
        ..matt(0.0, Some(0.4))
    };
    add(&mut scene, plate, material);
    scene.lights[0].world_from_light = DAffine3::from_translation(DVec3::new(0.0, 0.0, -600.0));
    let (light, _) = Renderer::new(scene).luminance(&view(), Backend::Auto, None);
    let [left, right] = [60, 140].map(|x| *light.scene.get(x, 80).unwrap());
    assert_close(left, right, 1e-3);
}

#[test]
fn a_slanted_surface_returns_its_reflectance_times_the_cosine() {
    let mut scene = dark_room();
    let mut plate = rectangle([-2.0, 2.0], [-2.0, 2.0], 0.0);
    let slope = 0.5f32;
    for [x, _, z] in &mut plate.positions {
        *z = 2.0 + slope * *x;
    }
    add(&mut scene, plate, matt(0.02, Some(0.7)));
    add(
        &mut scene,
        rectangle([-9.0, 9.0], [-9.0, 9.0], 4.0),
        matt(0.5, None),
    );
    for view in [view(), fisheye()] {
        let found = returns(&scene, &view);
        let [[depth, other], [strength, nothing]] = returns_at(&found, [100, 80]);
        let at = DVec3::new(0.005, 0.005, 1.0);
        let normal = DVec3::new(-0.5, 0.0, 1.0).normalize();
        assert_close(strength, 0.7 * (at.normalize().dot(normal) as f32), 1e-3);
        assert!((depth - 2.005).abs() < 1e-3 && other.is_infinite() && nothing == 0.0);
        // The wall beside it is left to the engine.
        let [[depth, _], [strength, _]] = returns_at(&found, [190, 80]);
        assert!(strength.is_nan() && (depth - 4.0).abs() < 1e-4);
    }
    let plain = Scene {
        materials: vec![matt(0.5, None)],
        ..scene.clone()
    };
    assert!(Renderer::new(plain).returns(&view(), Backend::Auto).is_none());
}

/// Half of the light passes a veil, and half of what comes back passes it again.
#[test]
fn a_veil_and_the_wall_behind_it_both_return_light() {
    let mut scene = dark_room();
    let veil = Material {
        opacity: Opacity::new(0.5, None, 0.0),
        ..matt(0.6, None)
    };
    add(&mut scene, rectangle([-2.0, 2.0], [-2.0, 2.0], 1.5), veil);
    add(
        &mut scene,
        rectangle([-9.0, 9.0], [-9.0, 9.0], 2.0),
        matt(0.1, Some(0.9)),
    );
    let [depths, strengths] = returns_at(&returns(&scene, &view()), [100, 80]);
    let (near, far) = (0.5 * estimated(0.6), 0.25 * 0.9);
    assert!(near / 2.25 > far / 4.0);
    assert_close(strengths[0], near, 1e-3);
    assert_close(strengths[1], far, 1e-3);
    assert!(
        (depths[0] - 1.5).abs() < 1e-4 && (depths[1] - 2.0).abs() < 1e-4,
        "{depths:?}"
    );
}

/// Mirrors lengthen the path, and reflect light twice.
#[test]
fn a_mirror_returns_light_from_the_end_of_the_path() {
    let mut scene = dark_room();
    add(&mut scene, rectangle([-3.0, 3.0], [-3.0, 3.0], 2.0), mirror(0.8));
    add(
        &mut scene,
        rectangle([-9.0, 9.0], [-9.0, 9.0], -1.0),
        matt(0.3, None),
    );
    for view in [view(), fisheye()] {
        let [depths, strengths] = returns_at(&returns(&scene, &view), [100, 80]);
        assert!((depths[0] - 5.0).abs() < 1e-3, "{depths:?}");
        assert_close(strengths[0], 0.64 * estimated(0.3), 2e-3);
        assert_eq!(strengths[1], 0.0);
    }
}

/// Light takes longer in a block of glass: 0.4 m of index 1.5 count as 0.6 m.
#[test]
fn light_is_slower_in_glass() {
    let mut scene = dark_room();
    let glass = Material {
        base_color: Some([1.0; 3]),
        roughness: 0.0,
        transmission: Some(oaktwin_scene::Transmission {
            share: 1.0,
            mask: None,
            tint: Some([1.0; 3]),
            refracts: true,
        }),
        ..Material::default()
    };
    let mut block = cube();
    for [x, y, z] in &mut block.positions {
        (*x, *y, *z) = (3.0 * *x, 3.0 * *y, 1.2 + 0.2 * *z);
    }
    add(&mut scene, block, glass);
    add(
        &mut scene,
        rectangle([-9.0, 9.0], [-9.0, 9.0], 2.0),
        matt(0.1, Some(0.9)),
    );
    let [depths, strengths] = returns_at(&returns(&scene, &view()), [100, 80]);
    assert!((depths[0] - 2.2).abs() < 1e-3, "{depths:?}");
    // Each way, two surfaces reflect 0.04.
    assert_close(strengths[0], 0.9 * 0.96f32.powi(4), 5e-3);
}
