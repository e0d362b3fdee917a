//! The promises of every scene.

use oaktwin_scene::{Mesh, MeshAttribute, Scene};

pub(crate) fn check(scene: &Scene) {
    for mesh in &scene.meshes {
        check_mesh(mesh, scene.materials.len());
    }
    for instance in &scene.instances {
        assert!((instance.mesh as usize) < scene.meshes.len(), "{instance:?}");
        let transform = instance.world_from_mesh;
        assert!(
            transform.is_finite() && transform.inverse().is_finite(),
            "{instance:?}"
        );
    }
    for material in &scene.materials {
        let finite = material
            .emissive
            .iter()
            .chain(material.base_color.iter().flatten());
        assert!(
            finite
                .chain([&material.metallic, &material.roughness])
                .all(|x| x.is_finite()),
            "{material:?}"
        );
        if let Some(texture) = material.base_color_texture {
            assert!((texture.texture as usize) < scene.textures.len(), "{material:?}");
        }
    }
}

fn check_mesh(mesh: &Mesh, materials: usize) {
    let vertices = mesh.positions.len();
    assert!(
        mesh.positions.iter().flatten().all(|x| x.is_finite()),
        "a position is not finite"
    );
    assert!(
        mesh.triangles
            .iter()
            .flatten()
            .all(|&index| (index as usize) < vertices),
        "an index is out of range"
    );
    check_attribute(mesh.normals.as_ref(), mesh, "normals");
    check_attribute(mesh.uvs.as_ref(), mesh, "uvs");
    check_attribute(mesh.colors.as_ref(), mesh, "colors");
    for span in &mesh.materials {
        assert!(
            span.material
                .is_none_or(|material| (material as usize) < materials),
            "{span:?}"
        );
    }
    if let Some(last) = mesh.materials.last() {
        assert_eq!(
            last.end as usize,
            mesh.triangles.len(),
            "the materials do not cover the triangles"
        );
        assert!(mesh.materials.is_sorted_by_key(|span| span.end));
    }
}

/// Checks that there is a value for each corner.
fn check_attribute<T: Copy>(attribute: Option<&MeshAttribute<T>>, mesh: &Mesh, what: &str) {
    let Some(attribute) = attribute else { return };
    for (number, triangle) in mesh.triangles.iter().enumerate() {
        assert!(
            attribute.corners(number, *triangle).is_some(),
            "{what} of triangle {number}"
        );
    }
}
