//! Compressed files have the contents of the plain one.
//!
//! A surface of 9 × 9 points with normals, colours, texture coordinates and an image of 16 × 16 pixels, written by glTF
//! Transform with the reference encoders of Draco, meshopt (`meshopt_khr` by gltfpack) and Basis Universal.

use oaktwin_camera::math::DVec3;
use oaktwin_image::texture::decode_srgb;
use oaktwin_scene::TextureSource;
use oaktwin_scene::import::ImportedScene;
use proptest::prelude::*;

use crate::support::{Files, check, messages, open};

macro_rules! files {
    ($($name:literal),*) => { [$(($name, include_bytes!(concat!("compressed/", $name, ".glb")).as_slice())),*] };
}

const MESHES: [(&str, &[u8]); 5] = files!(
    "draco",
    "draco_sequential",
    "meshopt",
    "meshopt_filters",
    "meshopt_khr"
);
const TEXTURES: [(&str, &[u8]); 2] = files!("ktx2_etc1s", "ktx2_uastc");

fn plain() -> ImportedScene {
    open("plain.glb", include_bytes!("compressed/plain.glb"))
}

/// A corner's position, normal, texture coordinates in the image, and colour.
type Corner = [f32; 11];

fn corners(imported: &ImportedScene) -> Vec<[Corner; 3]> {
    let scene = &imported.scene;
    let [instance] = scene.instances.as_slice() else {
        panic!("{:?}", scene.instances)
    };
    let mesh = &scene.meshes[instance.mesh as usize];
    let texture = scene.materials[0].base_color_texture.unwrap();
    let corner = |i: usize, k: usize| {
        let p = DVec3::from(mesh.corners(i).unwrap()[k].map(f64::from));
        let p = instance.world_from_mesh.transform_point3(p).as_vec3();
        let triangle = mesh.triangles[i];
        let n = mesh.normals.as_ref().unwrap().corners(i, triangle).unwrap()[k];
        let [u, v] = mesh.uvs.as_ref().unwrap().corners(i, triangle).unwrap()[k];
        let [u, v] = texture.image_from_uv.map(|row| row[0] * u + row[1] * v + row[2]);
        let c = mesh.colors.as_ref().unwrap().corners(i, triangle).unwrap()[k];
        [p.x, p.y, p.z, n[0], n[1], n[2], u, v, c[0], c[1], c[2]]
    };
    (0..mesh.triangles.len())
        .map(|i| [0, 1, 2].map(|k| corner(i, k)))
        .collect()
}

/// The position of a point in the grid, by which triangles are compared: encoders reorder them and turn their corners.
fn key(triangle: &[Corner; 3]) -> [(i32, i32); 3] {
    let at = triangle.map(|corner| ((corner[0] * 8.0).round() as i32, (corner[1] * 8.0).round() as i32));
    let first = (0..3).min_by_key(|&i| at[i]).unwrap();
    [0, 1, 2].map(|i| at[(first + i) % 3])
}

#[test]
fn decoded_meshes_equal_the_plain_one() {
    let plain = plain();
    let mut expected = corners(&plain);
    expected.sort_by_key(key);
    assert_eq!(expected.len(), 128);
    // Half a step of 12 bits for texture coordinates and of 8 bits for normals is the coarsest quantization.
    let tolerance = |i: usize| match i {
        0..3 => 1e-4,
        3..6 => 0.013,
        6..8 => 2.5e-4,
        _ => 0.005,
    };
    for (name, bytes) in MESHES {
        let imported = open("a.glb", bytes);
        assert_eq!(messages(&imported), [""; 0], "{name}");
        let mut found = corners(&imported);
        found.sort_by_key(key);
        assert_eq!(found.len(), expected.len(), "{name}");
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(key(found), key(expected), "{name}");
            for corner in found {
                let twin = expected
                    .iter()
                    .find(|twin| (0..2).all(|i| (twin[i] - corner[i]).abs() < 0.01))
                    .unwrap();
                for (i, (a, b)) in corner.iter().zip(twin).enumerate() {
                    assert!((a - b).abs() <= tolerance(i), "{name}: {i}: {a} instead of {b}");
                }
            }
        }
    }
}

#[test]
fn decoded_textures_resemble_the_plain_one() {
    let pixels = |imported: &ImportedScene| match &imported.scene.textures[0].source {
        TextureSource::Encoded { bytes, .. } => decode_srgb(bytes, None).unwrap(),
        source => panic!("{source:?}"),
    };
    let plain = pixels(&plain());
    for (name, bytes) in TEXTURES {
        let imported = open("a.glb", bytes);
        assert_eq!(messages(&imported), [""; 0], "{name}");
        let image = pixels(&imported);
        assert_eq!((image.width(), image.height()), (16, 16), "{name}");
        let differences: Vec<u32> = (0..256)
            .flat_map(|i| {
                let at = (i % 16, i / 16);
                let (a, b) = (image.get(at.0, at.1).unwrap(), plain.get(at.0, at.1).unwrap());
                [0, 1, 2].map(|k| u32::from(a[k].abs_diff(b[k])))
            })
            .collect();
        let mean = differences.iter().sum::<u32>() as f32 / differences.len() as f32;
        let limit = if name == "ktx2_uastc" { 3.0 } else { 16.0 };
        assert!(mean < limit, "{name}: {mean}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn damaged_files_never_panic(file in 0..7_usize, end in any::<prop::sample::Index>(), changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..5)) {
        let (_, bytes) = *MESHES.iter().chain(&TEXTURES).nth(file).unwrap();
        let mut bytes = bytes.to_vec();
        for (at, byte) in &changes {
            let at = at.index(bytes.len());
            bytes[at] = *byte;
        }
        if changes.is_empty() {
            bytes.truncate(1 + end.index(bytes.len()));
        }
        if let Ok(imported) = Files::new().with("a.glb", bytes).try_open("a.glb") {
            check(&imported.scene);
            for texture in &imported.scene.textures {
                if let TextureSource::Encoded { bytes, .. } = &texture.source {
                    let _ = decode_srgb(bytes, None);
                }
            }
        }
    }
}
