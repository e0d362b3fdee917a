#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "coordinates of tests"
)]

mod infrared;
mod lights;
mod optics;
mod shadows;

use std::path::PathBuf;
use std::sync::Arc;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_image::Image;
use oaktwin_image::annotation::Annotator;
use oaktwin_image::srgb::{linear_from_srgb, srgb_from_linear};
use oaktwin_scene::{
    ColorSpace, Light, LightKind, Material, MaterialSpan, Mesh, MeshAttribute, Scene, Texture, TextureSource,
    TextureUse, Up,
};

use self::lights::{floor_and_box, sun};
use super::tone::tone;
use crate::fixture::{cube, fisheye, look_at, placed, rectangle, view};
use crate::{AnnotateOptions, Backend, Renderer, View};

fn rgb(scene: &Scene, view: &View) -> Image<[u8; 4]> {
    let (rgb, codes) = rgb_and_codes(scene, view);
    assert!(codes.is_empty(), "{codes:?}");
    rgb
}

fn rgb_and_codes(scene: &Scene, view: &View) -> (Image<[u8; 4]>, Vec<String>) {
    let renderer = Renderer::new(scene.clone());
    let options = AnnotateOptions::default();
    let (frame, findings) = renderer.annotate(view, &[Annotator::Rgb], Backend::Auto, &options);
    let findings = findings.iter().map(ToString::to_string).collect();
    (frame.rgb.unwrap(), findings)
}

fn dome(radiance: f32) -> Light {
    Light {
        path: "/Dome".to_owned(),
        kind: LightKind::Dome { texture: None },
        radiance: [radiance; 3],
        normalize: false,
        world_from_light: DAffine3::IDENTITY,
    }
}

fn texture(image: Image<[u8; 4]>) -> Texture {
    Texture {
        source: TextureSource::Pixels(Arc::new(image)),
        color_space: ColorSpace::Auto,
    }
}

/// Adds a rectangle at 2 m that fills the view, with u to the right and v up in the image.
fn screen(scene: &mut Scene, material: Material) {
    // A pixel is 2 cm; the view has 200 × 160.
    let mut mesh = rectangle([-2.0, 2.0], [-1.6, 1.6], 2.0);
    // The corners are upper left, lower left, lower right, upper right.
    mesh.uvs = Some(MeshAttribute::Vertex(vec![
        [0.0, 1.0],
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
    ]));
    mesh.materials = vec![MaterialSpan {
        end: 2,
        material: Some(u32::try_from(scene.materials.len()).unwrap()),
    }];
    scene.materials.push(material);
    placed(scene, "/Screen", mesh);
}

fn rough(texture: Option<u32>) -> Material {
    Material {
        base_color_texture: texture.map(TextureUse::new),
        roughness: 1.0,
        ..Material::default()
    }
}

/// An image of distinct colours.
fn card() -> Image<[u8; 4]> {
    let pixels = (0..160u8).flat_map(|y| (0..200u8).map(move |x| [x, y, (x ^ y) / 2, 255]));
    Image::new(200, 160, pixels.collect()).unwrap()
}

#[test]
fn textures_at_their_own_size_show_each_texel() {
    let mut scene = Scene {
        lights: vec![dome(1000.0)],
        textures: vec![texture(card())],
        ..Scene::default()
    };
    screen(&mut scene, rough(Some(0)));
    let seen = rgb(&scene, &view());
    // A white screen would be 0.8 under a dome alone; indirect light and reflections add to it.
    let lit = 0.8 * 1.22f32;
    for (x, y) in [(0, 0), (199, 0), (0, 159), (199, 159), (100, 80), (37, 121)] {
        let [r, g, b, coverage] = *seen.get(x, y).unwrap();
        let texel = card().get(x, y).copied().unwrap();
        let linear = linear_from_srgb();
        for (got, value) in [r, g, b].into_iter().zip(texel) {
            let expected =
                |gloss: f32| srgb_from_linear(tone((linear[usize::from(value)] * 0.999 + gloss) * lit));
            let range = expected(0.03)..=expected(0.09);
            assert!(range.contains(&got), "{x} {y}: {got} of {value}, {range:?}");
        }
        assert_eq!(coverage, 255);
    }
    // Equal texels have equal colours everywhere.
    let scene_of = |image| {
        let mut scene = Scene {
            lights: vec![dome(1.0)],
            textures: vec![texture(image)],
            ..Scene::default()
        };
        screen(&mut scene, rough(Some(0)));
        rgb(&scene, &view())
    };
    let plain = scene_of(Image::filled(200, 160, [90, 120, 30, 255]));
    let near = |a: u8, b: u8| a.abs_diff(b) <= 2;
    let first = plain.pixels()[0];
    assert!(
        plain
            .pixels()
            .iter()
            .all(|pixel| near(pixel[0], first[0]) && near(pixel[1], first[1]))
    );
}

#[test]
fn exposure_compensates_the_brightness_of_the_lights() {
    let picture = |radiance| {
        let mut scene = Scene {
            lights: vec![dome(radiance)],
            textures: vec![texture(card())],
            ..Scene::default()
        };
        screen(&mut scene, rough(Some(0)));
        rgb(&scene, &view())
    };
    let (dim, bright) = (picture(0.5), picture(2048.0));
    for (a, b) in dim.pixels().iter().zip(bright.pixels()) {
        assert!(a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= 1));
    }
}

#[test]
fn both_images_of_a_stereo_pair_have_the_same_colours() {
    let mut scene = floor_and_box(vec![sun(), dome(300.0)]);
    // A coarse texture, so that both cameras resolve the same detail.
    let pixels = (0..16 * 16u32).map(|i| {
        let (x, y) = (i % 16, i / 16);
        let value = |seed: u32| ((x * 97 + y * 57 + seed).wrapping_mul(2_654_435_761) >> 24) as u8;
        [value(1), value(2), value(3), 255]
    });
    scene.textures = vec![texture(Image::new(16, 16, pixels.collect()).unwrap())];
    screen(&mut scene, rough(Some(0)));
    let baseline = 0.08;
    let right = View {
        world_from_camera: RigidTransform::new(
            view().world_from_camera.rotation,
            DVec3::new(baseline, 0.0, 0.0),
        ),
        ..view()
    };
    let (left, right) = (rgb(&scene, &view()), rgb(&scene, &right));
    // 100 px · 8 cm / 2 m.
    let disparity = 4;
    let mut differences = Vec::new();
    for y in 5..75 {
        for x in 10..190 {
            let (a, b) = (left.get(x, y).unwrap(), right.get(x - disparity, y).unwrap());
            differences.push(a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap());
        }
    }
    differences.sort_unstable();
    let count = differences.len();
    assert!(differences[count / 2] <= 1, "{}", differences[count / 2]);
    assert!(
        differences[count * 99 / 100] <= 3,
        "{}",
        differences[count * 99 / 100]
    );
}

#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let scene = floor_and_box(vec![sun(), dome(300.0)]);
    for view in [view(), fisheye()] {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| rgb(&scene, &view))
        };
        let one = with(1);
        assert_eq!(one, with(2));
        assert_eq!(one, with(5));
    }
}

#[test]
fn broken_textures_are_reported_and_grey() {
    let mut scene = Scene {
        lights: vec![dome(1.0)],
        ..Scene::default()
    };
    let cases = [
        TextureSource::File(PathBuf::from("/nowhere/wood.png")),
        TextureSource::Encoded {
            name: "room.usdz[wood.png]".to_owned(),
            bytes: Arc::from(*b"\x89PNG\r\n\x1a\nno more"),
        },
    ];
    for source in cases {
        scene.textures = vec![Texture {
            source,
            color_space: ColorSpace::Auto,
        }];
        scene.meshes.clear();
        scene.instances.clear();
        scene.materials.clear();
        screen(&mut scene, rough(Some(0)));
        let (seen, findings) = rgb_and_codes(&scene, &view());
        assert_eq!(findings.len(), 1, "{findings:?}");
        assert!(
            findings[0].starts_with("warning[texture-missing]: "),
            "{findings:?}"
        );
        assert!(findings[0].contains("wood.png"), "{findings:?}");
        let [r, g, b, _] = seen.pixels()[0];
        assert!(r == g && g == b && (120..230).contains(&r), "{r}");
        // Textures of invisible surfaces are not read.
        let away = look_at(view(), DVec3::ZERO, DVec3::new(1.0, 0.0, -5.0));
        assert_eq!(rgb_and_codes(&scene, &away).1, Vec::<String>::new());
    }
}

#[test]
fn non_finite_properties_are_accepted() {
    let mut scene = floor_and_box(vec![sun(), dome(300.0)]);
    scene.textures = vec![texture(card())];
    let mut material = rough(Some(0));
    material.base_color = Some([f32::NAN, f32::INFINITY, -1.0]);
    material.emissive = [f32::NAN, 0.0, 0.0];
    material.roughness = 0.0;
    material.metallic = f32::NAN;
    scene.materials = vec![material, Material::default()];
    let span = |material| {
        vec![MaterialSpan {
            end: 12,
            material: Some(material),
        }]
    };
    let odd = [f32::NAN, 1e38];
    for (uvs, material) in [
        (None, 0),
        (Some(MeshAttribute::Constant(odd)), 0),
        (Some(MeshAttribute::Constant([0.5; 2])), 0),
        (Some(MeshAttribute::Vertex(vec![odd])), 0),
        (None, 1),
        (None, 99),
    ] {
        let mesh = &mut scene.meshes[1];
        mesh.uvs = uvs;
        mesh.materials = span(material);
        mesh.normals = Some(MeshAttribute::Constant([0.0; 3]));
        mesh.colors = Some(MeshAttribute::Constant([f32::NAN; 3]));
        let seen = rgb(&scene, &view());
        assert!(seen.pixels().iter().any(|pixel| pixel[3] == 255));
    }
    for light in &mut scene.lights {
        light.world_from_light = DAffine3::from_scale(DVec3::new(0.0, 1.0, f64::NAN));
    }
    let _ = rgb(&scene, &view());
    let _ = rgb(&Scene::default(), &view());
}

#[test]
fn outlines_are_antialiased() {
    let mut scene = Scene {
        lights: vec![dome(1.0)],
        ..Scene::default()
    };
    let mut dark = rectangle([-3.0, 0.31], [-3.0, 3.0], 2.0);
    dark.colors = Some(MeshAttribute::Constant([0.02; 3]));
    let mut light = rectangle([-3.0, 3.0], [-3.0, 3.0], 3.0);
    light.colors = Some(MeshAttribute::Constant([0.9; 3]));
    // Tilted, so that all coverages of a pixel occur.
    for position in &mut dark.positions {
        position[0] += position[1] * 0.05;
    }
    placed(&mut scene, "/Dark", dark);
    placed(&mut scene, "/Light", light);
    let seen = rgb(&scene, &view());
    let between = seen
        .pixels()
        .iter()
        .filter(|pixel| (80..200).contains(&pixel[1]))
        .count();
    assert!(between > 80, "{between}");
    let renderer = Renderer::new(scene);
    let options = AnnotateOptions {
        smooth_edges: false,
        ..AnnotateOptions::default()
    };
    let (frame, _) = renderer.annotate(&view(), &[Annotator::Rgb], Backend::Auto, &options);
    let hard = frame.rgb.unwrap();
    assert!(hard.pixels().iter().all(|pixel| !(80..200).contains(&pixel[1])));
}

#[test]
fn infinite_rays_hit_like_long_rays() {
    use crate::Ray;
    let scene = floor_and_box(Vec::new());
    let renderer = Renderer::new(scene);
    let mut rays = Vec::new();
    for i in 0..4000u32 {
        let f =
            |k: u32| f64::from((i.wrapping_mul(2_654_435_761).rotate_left(k) >> 8) & 0xffff) / 65536.0 - 0.5;
        rays.push(Ray {
            origin: DVec3::new(f(1) * 3.0, 0.99, 3.0 + f(9) * 3.0),
            direction: DVec3::new(f(5), -f(13).abs() - 0.1, f(17)),
            near: 0.0,
            far: f64::INFINITY,
        });
    }
    let endless = renderer.occluded(&rays);
    for ray in &mut rays {
        ray.far = 1e6;
    }
    assert!(endless.iter().any(|o| *o));
    assert_eq!(endless, renderer.occluded(&rays));
}
