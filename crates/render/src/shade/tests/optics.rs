//! Mirrors and glass, compared with closed forms.

use oaktwin_camera::math::DVec3;
use oaktwin_image::annotation::Frame;
use oaktwin_scene::{ColorSpace, TextureMask, TextureSource, TextureUse, Transmission, Wrap};

use super::*;
use crate::Transparent;

/// A lamp far away, beside which the background is black.
fn far_lamp() -> Light {
    Light {
        path: "/Lamp".to_owned(),
        kind: LightKind::Sphere { radius: 0.1 },
        radiance: [1.0; 3],
        normalize: false,
        world_from_light: DAffine3::from_translation(DVec3::new(0.0, -90.0, 0.0)),
    }
}

/// What a dull black surface reflects of its surroundings at normal incidence: 0.04 of the indirect light, which is 0.22 of white.
const GLANCE: f32 = 0.04 * 0.22 * 0.8;

/// A black surface that emits light of a luminance.
fn glowing(emitted: f32) -> Material {
    Material {
        base_color: Some([0.0; 3]),
        emissive: [emitted; 3],
        roughness: 1.0,
        ..Material::default()
    }
}

fn clear(tint: f32) -> Material {
    Material {
        roughness: 0.0,
        transmission: Some(Transmission {
            share: 1.0,
            mask: None,
            tint: Some([tint; 3]),
            refracts: false,
        }),
        ..Material::default()
    }
}

pub(super) fn mirror(color: f32) -> Material {
    Material {
        base_color: Some([color; 3]),
        metallic: 1.0,
        roughness: 0.0,
        ..Material::default()
    }
}

/// Adds a mesh of one material.
pub(super) fn add(scene: &mut Scene, mut mesh: Mesh, material: Material) {
    mesh.materials = vec![MaterialSpan {
        end: u32::try_from(mesh.triangles.len()).unwrap(),
        material: Some(u32::try_from(scene.materials.len()).unwrap()),
    }];
    scene.materials.push(material);
    placed(scene, "/Part", mesh);
}

pub(super) fn dark_room() -> Scene {
    Scene {
        lights: vec![far_lamp()],
        ..Scene::default()
    }
}

/// The luminance of a pixel; 0.8 is the emission of 1.
fn luminance_at(scene: &Scene, pixel: [u32; 2]) -> f32 {
    let renderer = Renderer::new(scene.clone());
    let (light, findings) = renderer.luminance(&view(), Backend::Auto, None);
    assert!(findings.is_empty());
    light.scene.get(pixel[0], pixel[1]).unwrap() * 0.8
}

fn annotated(scene: &Scene, view: &View, transparent: Transparent) -> Frame {
    let options = AnnotateOptions {
        transparent,
        ..AnnotateOptions::default()
    };
    let annotators = [Annotator::Rgb, Annotator::DistanceToImagePlane];
    let renderer = Renderer::new(scene.clone());
    renderer.annotate(view, &annotators, Backend::Auto, &options).0
}

#[test]
fn a_mirror_shows_what_is_in_front_of_it_at_the_length_of_the_path() {
    let mut scene = dark_room();
    add(&mut scene, rectangle([-3.0, 3.0], [-3.0, 3.0], 2.0), mirror(0.9));
    add(&mut scene, rectangle([0.0, 9.0], [-9.0, 9.0], -1.0), glowing(0.5));
    for (column, seen) in [(150, 0.9 * (0.5 + GLANCE)), (50, 0.0)] {
        let found = luminance_at(&scene, [column, 80]);
        assert!((found - seen).abs() < 3e-3, "{column}: {found} {seen}");
    }
    for view in [view(), fisheye()] {
        let frame = annotated(&scene, &view, Transparent::Surface);
        let (z, apparent) = (
            frame.distance_to_image_plane.unwrap(),
            frame.apparent_depth.unwrap(),
        );
        assert!((z.0.get(120, 80).unwrap() - 2.0).abs() < 1e-5);
        assert!(
            (apparent.0.get(120, 80).unwrap() - 5.0).abs() < 1e-4,
            "{:?}",
            apparent.0.get(120, 80)
        );
        // The black background is not brighter than the mirror itself.
        assert!((apparent.0.get(80, 80).unwrap() - 2.0).abs() < 1e-5);
    }
}

#[test]
fn panes_reflect_and_tint_what_lies_behind_them() {
    let mut scene = dark_room();
    add(&mut scene, rectangle([-5.0, 5.0], [-5.0, 5.0], 3.0), glowing(0.5));
    let alone = luminance_at(&scene, [100, 80]);
    assert!((alone - 0.5 - GLANCE).abs() < 1e-3, "{alone}");
    for z in [1.0, 1.5] {
        add(&mut scene, rectangle([-2.0, 2.0], [-2.0, 2.0], z), clear(0.6));
    }
    // Each pane transmits 1 - 2R / (1 + R) with R = 0.04, and its tint; a share R² of what is reflected between them returns.
    let (reflected, passed) = (0.08 / 1.04, 0.6 * 0.96 / 1.04);
    let expected = alone * passed * passed * (1.0 + reflected * reflected);
    let found = luminance_at(&scene, [100, 80]);
    assert!((found - expected).abs() < 5e-3 * expected, "{found} {expected}");
    // A wall behind the camera is seen by reflection too.
    add(
        &mut scene,
        rectangle([-9.0, 9.0], [-9.0, 9.0], -1.0),
        glowing(1.0),
    );
    let more = luminance_at(&scene, [100, 80]);
    let first = (1.0 + GLANCE) * (reflected + passed * passed * reflected);
    assert!(
        (more - found - first).abs() < 0.02 * first + 1e-3,
        "{more} {found} {first}"
    );
}

#[test]
fn a_mask_decides_where_a_pane_is_clear() {
    let pane = |material: Material| {
        let mut scene = dark_room();
        add(&mut scene, rectangle([-5.0, 5.0], [-5.0, 5.0], 3.0), glowing(0.5));
        let mesh = Mesh {
            uvs: Some(MeshAttribute::Vertex(vec![
                [0.0, 0.0],
                [0.0, 1.0],
                [1.0, 1.0],
                [1.0, 0.0],
            ])),
            ..rectangle([-0.5, 0.5], [-2.0, 2.0], 1.0)
        };
        add(&mut scene, mesh, material);
        let pixels = vec![[255, 0, 0, 255], [0, 255, 255, 255]];
        scene.textures = vec![Texture {
            source: TextureSource::Pixels(Arc::new(Image::new(2, 1, pixels).unwrap())),
            color_space: ColorSpace::Raw,
        }];
        scene
    };
    let texture = TextureUse {
        wrap_s: Wrap::Clamp,
        ..TextureUse::new(0)
    };
    let material = |share: f32, mask: Option<TextureMask>| Material {
        base_color: Some([0.0; 3]),
        transmission: Some(Transmission {
            share,
            mask,
            tint: Some([0.6; 3]),
            refracts: false,
        }),
        ..clear(0.6)
    };
    let masked = pane(material(1.0, Some(TextureMask { texture, channel: 0 })));
    let [whole, none] = [1.0, 0.0].map(|share| pane(material(share, None)));
    for (column, same, other) in [(60, &whole, &none), (140, &none, &whole)] {
        let [found, same, other] = [&masked, same, other].map(|scene| luminance_at(scene, [column, 80]));
        assert!((found - same).abs() < 1e-6, "{column}: {found} {same}");
        assert!((found - other).abs() > 0.1, "{column}: {found} {other}");
    }
    let frame = annotated(&masked, &view(), Transparent::Through);
    let z = frame.distance_to_image_plane.unwrap();
    let seen = [60, 140].map(|column| *z.0.get(column, 80).unwrap());
    assert!(
        (seen[0] - 3.0).abs() < 1e-5 && (seen[1] - 1.0).abs() < 1e-5,
        "{seen:?}"
    );
}

#[test]
fn partial_opacity_mixes_a_surface_with_what_lies_behind_it() {
    let mut scene = dark_room();
    add(&mut scene, rectangle([-5.0, 5.0], [-5.0, 5.0], 3.0), glowing(0.5));
    let veil = Material {
        opacity: oaktwin_scene::Opacity::new(0.25, None, 0.0),
        ..glowing(0.2)
    };
    add(&mut scene, rectangle([-2.0, 2.0], [-2.0, 2.0], 1.0), veil);
    let found = luminance_at(&scene, [100, 80]);
    assert!(
        (found - (0.25 * 0.2 + 0.75 * 0.5 + GLANCE)).abs() < 2e-3,
        "{found}"
    );
}

#[test]
fn a_solid_of_glass_bends_light_and_brings_nearer_what_lies_behind_it() {
    let mut scene = dark_room();
    let solid = Material {
        transmission: Some(Transmission {
            share: 1.0,
            mask: None,
            tint: Some([1.0; 3]),
            refracts: true,
        }),
        ..clear(1.0)
    };
    // A wall that glows on the right of x = 0.8, behind a cube from 3 to 5 m.
    add(&mut scene, rectangle([0.8, 9.0], [-9.0, 9.0], 7.0), glowing(0.5));
    add(&mut scene, rectangle([-9.0, 0.8], [-9.0, 9.0], 7.0), glowing(0.1));
    add(&mut scene, cube(), solid);
    scene.instances[2].world_from_mesh = DAffine3::from_translation(DVec3::new(0.0, 0.0, 4.0));
    // Near the axis a ray of slope s meets the wall at s (3 + 2 / 1.5 + 2).
    let edge = |scene: &Scene| (100..140).find(|x| luminance_at(scene, [*x, 80]) > 0.25).unwrap();
    let bent = edge(&scene);
    let first_beyond = |depth: f64| (100.0 + 100.0 * 0.8 / depth - 0.5).ceil() as u32;
    assert_eq!(bent, first_beyond(5.0 + 2.0 / 1.5));
    let straight = Material {
        transmission: clear(1.0).transmission,
        ..scene.materials[2].clone()
    };
    let mut thin = scene.clone();
    thin.materials[2] = straight;
    assert_eq!(edge(&thin), first_beyond(7.0));
    assert_ne!(edge(&thin), bent);
    let centre = |scene: &Scene| {
        let apparent = annotated(scene, &view(), Transparent::Surface)
            .apparent_depth
            .unwrap();
        *apparent.0.get(104, 80).unwrap()
    };
    assert!(
        (centre(&scene) - (5.0 + 2.0 / 1.5)).abs() < 0.02,
        "{}",
        centre(&scene)
    );
    assert!((centre(&thin) - 7.0).abs() < 1e-3);
}

#[test]
fn no_light_is_gained_in_a_white_furnace() {
    let mut furnace = Scene {
        lights: vec![dome(1.0)],
        ..Scene::default()
    };
    let solid = Material {
        transmission: Some(Transmission {
            share: 1.0,
            mask: None,
            tint: Some([1.0; 3]),
            refracts: true,
        }),
        ..clear(1.0)
    };
    add(&mut furnace, cube(), solid);
    furnace.instances[0].world_from_mesh = DAffine3::from_translation(DVec3::new(-0.5, 0.2, 4.0));
    add(&mut furnace, rectangle([0.0, 3.0], [-1.0, 1.0], 2.0), clear(1.0));
    add(&mut furnace, rectangle([-3.0, 3.0], [1.5, 4.0], 6.0), mirror(1.0));
    let renderer = Renderer::new(furnace);
    let (light, _) = renderer.luminance(&view(), Backend::Auto, None);
    let background = *light.scene.get(0, 0).unwrap();
    let (mut least, mut most) = (f32::INFINITY, 0.0_f32);
    for pixel in light.scene.pixels() {
        (least, most) = (least.min(*pixel), most.max(*pixel));
    }
    // Lost are the paths that carry too little light to be followed.
    assert!(most <= background * 1.001, "{most} {background}");
    assert!(least >= background * 0.9, "{least} {background}");
}

#[test]
fn rough_mirrors_blur() {
    let mut scene = dark_room();
    let rough = Material {
        roughness: 0.3,
        ..mirror(1.0)
    };
    add(&mut scene, rectangle([-3.0, 3.0], [-3.0, 3.0], 2.0), rough);
    add(&mut scene, rectangle([0.0, 9.0], [-9.0, 9.0], -1.0), glowing(0.5));
    let across = [60, 99, 101, 140].map(|x| luminance_at(&scene, [x, 80]));
    assert!(across[0] < 0.1 && across[3] > 0.4, "{across:?}");
    assert!(across[1] > 0.15 && across[2] < 0.35, "{across:?}");
}

#[test]
fn clear_surfaces_cast_no_shadow_and_can_be_looked_through() {
    // A sun behind the camera, whose highlight is elsewhere.
    let sun = Light {
        world_from_light: DAffine3::from_rotation_y(std::f64::consts::PI - 0.7),
        ..sun()
    };
    let mut scene = Scene {
        lights: vec![sun],
        ..Scene::default()
    };
    let grey = Material {
        base_color: Some([0.5; 3]),
        roughness: 1.0,
        ..Material::default()
    };
    add(&mut scene, rectangle([-5.0, 5.0], [-5.0, 5.0], 3.0), grey);
    let before = luminance_at(&scene, [100, 80]);
    add(&mut scene, rectangle([-2.0, 2.0], [-2.0, 2.0], 1.0), clear(1.0));
    let found = luminance_at(&scene, [100, 80]);
    assert!(
        before > 0.1 && (found / before - 0.96 / 1.04).abs() < 0.03,
        "{found} {before}"
    );
    for (transparent, z) in [(Transparent::Surface, 1.0), (Transparent::Through, 3.0)] {
        let frame = annotated(&scene, &view(), transparent);
        assert!((frame.distance_to_image_plane.unwrap().0.get(100, 80).unwrap() - z).abs() < 1e-5);
        assert!((frame.apparent_depth.unwrap().0.get(100, 80).unwrap() - 3.0).abs() < 1e-4);
    }
}

#[test]
fn the_bytes_do_not_depend_on_the_number_of_threads() {
    let mut scene = Scene::default();
    add(&mut scene, rectangle([-3.0, 0.0], [-3.0, 3.0], 2.0), mirror(0.9));
    add(&mut scene, rectangle([0.0, 2.0], [-2.0, 2.0], 1.5), clear(0.8));
    add(&mut scene, cube(), Material::default());
    scene.instances[2].world_from_mesh = DAffine3::from_translation(DVec3::new(0.5, 0.5, 4.0));
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            let frame = annotated(&scene, &view(), Transparent::Surface);
            (frame.rgb.unwrap(), frame.apparent_depth.unwrap())
        })
    };
    assert!(run(1) == run(3));
}

/// An edge 1 m behind a rough pane is blurred with the distribution of the facets, whose slopes along x have the cumulative distribution
/// (1 + s / √(w² + s²)) / 2 for a width w, and each facet deflects light by twice its slope. Uniform light does not change.
#[test]
fn rough_panes_blur_what_lies_behind_them() {
    let roughness = 0.3f32;
    let seen = |roughness: f32, left: f64| {
        let mut scene = dark_room();
        let pane = Material {
            roughness,
            ..clear(1.0)
        };
        add(&mut scene, rectangle([left, 9.0], [-9.0, 9.0], 2.0), glowing(1.0));
        add(&mut scene, rectangle([-9.0, 9.0], [-9.0, 9.0], 1.0), pane);
        luminance_at(&scene, [100, 80])
    };
    let even = seen(roughness, -90.0);
    // A pane this rough has no reflection of its own.
    assert!((even - 1.0 - GLANCE).abs() < 0.02, "{even}");
    let width = f64::from(roughness * roughness);
    for edge in [-0.4, -0.15, -0.05, 0.0, 0.05, 0.15, 0.4] {
        // The ray meets the wall at 0.01 m.
        let slope = (0.01 - edge) / 2.0;
        let expected = 0.5 * (1.0 + slope / (width * width + slope * slope).sqrt());
        let found = f64::from(seen(roughness, edge) / even);
        assert!((found - expected).abs() < 0.09, "{edge}: {found} {expected}");
        let sharp = seen(0.0, edge);
        assert!(
            if edge < 0.01 { sharp > 0.85 } else { sharp < 0.05 },
            "{edge}: {sharp}"
        );
    }
}
