use std::sync::Arc;

use oaktwin_camera::math::{DAffine3, DQuat, DVec3};
use oaktwin_image::Image;
use oaktwin_scene::{
    ColorSpace, Instance, Label, Light, LightKind, Material, MaterialSpan, Mesh, MeshAttribute, Opacity,
    Scene, Texture, TextureMask, TextureSource, TextureUse, Up, Wrap,
};

use super::*;
use crate::stage::{SceneOptions, open_scene};

fn meshes() -> Vec<Mesh> {
    let span = |end, material| MaterialSpan {
        end,
        material: Some(material),
    };
    let square = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.25], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        normals: Some(MeshAttribute::Vertex(vec![[0.0, 0.0, 1.0]; 4])),
        uvs: Some(MeshAttribute::Corner {
            values: vec![[0.0, 0.0], [0.5, 1.0]],
            indices: vec![[0, 1, 0], [1, 1, 0]],
        }),
        materials: vec![span(1, 0), span(2, 1)],
        double_sided: true,
        ..Mesh::default()
    };
    let painted = Mesh {
        normals: None,
        uvs: None,
        colors: Some(MeshAttribute::Vertex(vec![[0.25, 0.5, 1.0]; 4])),
        materials: vec![span(2, 2)],
        ..square.clone()
    };
    vec![square, painted]
}

fn instances() -> Vec<Instance> {
    let label = |prim: &str, name: &str| Label {
        prim: prim.into(),
        taxonomy: "class".into(),
        name: name.into(),
    };
    let instance = |mesh, path: &str, world_from_mesh, labels| Instance {
        mesh,
        path: path.into(),
        world_from_mesh,
        labels,
        material_offset: 0,
    };
    let link = "/World/arm/link 1";
    let small = DAffine3::from_scale(DVec3::splat(0.01));
    vec![
        instance(0, link, turned(), vec![label(link, "arm")]),
        instance(1, "/World/arm/link 1/tool", small, Vec::new()),
        instance(1, "/World/2nd", turned(), vec![label("/World/2nd", "box")]),
    ]
}

fn materials() -> Vec<Material> {
    let material = |name: &str, base_color| Material {
        name: name.into(),
        base_color,
        ..Material::default()
    };
    let textured = TextureUse {
        image_from_uv: [[2.0, 0.0, 0.5], [0.0, 3.0, 0.0]],
        wrap_s: Wrap::Clamp,
        wrap_t: Wrap::Mirror,
        ..TextureUse::new(0)
    };
    vec![
        Material {
            metallic: 1.0,
            roughness: 0.25,
            emissive: [0.5, 0.0, 0.0],
            ..material("red", Some([1.0, 0.0, 0.0]))
        },
        Material {
            base_color_texture: Some(textured),
            opacity: Opacity::new(
                1.0,
                Some(TextureMask {
                    texture: textured,
                    channel: 3,
                }),
                0.25,
            ),
            index: 1.25,
            specular: Some([0.5, 0.25, 0.125]),
            ..material("wood", Some([1.0; 3]))
        },
        material("own", None),
    ]
}

fn lights() -> Vec<Light> {
    let light = |path: &str, kind| Light {
        path: path.into(),
        kind,
        radiance: [4.0, 2.0, 1.0],
        normalize: false,
        world_from_light: turned(),
    };
    let lamp = LightKind::Rect {
        width: 2.0,
        height: 0.5,
    };
    vec![
        light("/World/sun", LightKind::Distant { angle: 0.01 }),
        light("/World/lamp", lamp),
    ]
}

fn turned() -> DAffine3 {
    DAffine3::from_rotation_translation(DQuat::from_rotation_z(0.5), DVec3::new(1.0, 2.0, 3.0))
}

fn scene() -> Scene {
    Scene {
        meshes: meshes(),
        instances: instances(),
        materials: materials(),
        textures: vec![Texture {
            source: TextureSource::Pixels(Arc::new(Image::filled(2, 2, [9, 8, 7, 255]))),
            color_space: ColorSpace::Srgb,
        }],
        lights: lights(),
        up: Up::Z,
        ..Scene::default()
    }
}

/// Asserts that two meshes look the same; material indices refer to their scenes.
fn assert_same_mesh((scene, mesh): (&Scene, &Mesh), (other_scene, other): (&Scene, &Mesh)) {
    assert_eq!(
        (&mesh.positions, &mesh.triangles),
        (&other.positions, &other.triangles)
    );
    assert_eq!(mesh.double_sided, other.double_sided);
    for i in 0..2_u32 {
        let at = (i as usize, mesh.triangles[i as usize]);
        let corners = |mesh: &Mesh| {
            (
                mesh.uvs.as_ref().and_then(|uvs| uvs.corners(at.0, at.1)),
                mesh.normals
                    .as_ref()
                    .and_then(|normals| normals.corners(at.0, at.1)),
                mesh.colors.as_ref().and_then(|colors| colors.corners(at.0, at.1)),
            )
        };
        assert_eq!(corners(mesh), corners(other));
        let describe = |scene: &Scene, mesh: &Mesh| {
            let material = scene.materials[mesh.material(i).unwrap() as usize].clone();
            (
                material.base_color,
                material.emissive,
                material.metallic,
                material.roughness,
                material.base_color_texture,
                material.opacity,
                material.index,
                material.specular,
            )
        };
        assert_eq!(describe(scene, mesh), describe(other_scene, other));
    }
}

fn label_names(instance: &Instance) -> Vec<String> {
    instance.labels.iter().map(|label| label.name.clone()).collect()
}

#[test]
fn a_written_scene_reads_back() {
    let scene = scene();
    let folder = tempfile::tempdir().unwrap();
    let file = scene_file(&scene, "images", ImageFiles::Referenced).unwrap();
    for (name, bytes) in &file.images {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
    let path = folder.path().join("a.usda");
    std::fs::write(&path, file.layer.text()).unwrap();
    let read = open_scene(&path, &SceneOptions::default()).unwrap();
    assert_eq!(read.findings, [], "{}", file.layer.text());
    let got = read.scene;
    assert_eq!((got.up, got.meters_per_unit), (Up::Z, scene.meters_per_unit));
    let paths: Vec<&str> = got
        .instances
        .iter()
        .map(|instance| instance.path.as_str())
        .collect();
    assert_eq!(
        paths,
        ["/World/arm/link_1", "/World/arm/link_1/tool", "/World/_2nd"]
    );
    for (found, expected) in got.instances.iter().zip(&scene.instances) {
        assert!(found.world_from_mesh.abs_diff_eq(expected.world_from_mesh, 1e-15));
        assert_same_mesh(
            (&got, &got.meshes[found.mesh as usize]),
            (&scene, &scene.meshes[expected.mesh as usize]),
        );
        let expected_names = if expected.path.ends_with("tool") {
            vec!["arm".to_owned()]
        } else {
            label_names(expected)
        };
        assert_eq!(label_names(found), expected_names);
    }
    for (found, expected) in got.lights.iter().zip(&scene.lights) {
        assert_eq!(
            (found.radiance, found.normalize),
            (expected.radiance, expected.normalize)
        );
        assert!(
            found
                .world_from_light
                .abs_diff_eq(expected.world_from_light, 1e-15)
        );
    }
    assert_eq!(got.lights.len(), 2);
}
