//! The size of a scene.

use crate::{Instance, Mesh, MeshAttribute, Scene, TextureSource};

impl Scene {
    /// Returns the number of rendered triangles: a mesh counts once per instance.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let of_instance = |instance: &Instance| {
            self.meshes
                .get(instance.mesh as usize)
                .map_or(0, |mesh| mesh.triangles.len() as u64)
        };
        self.instances.iter().map(of_instance).sum()
    }

    /// Returns the number of stored triangles: a mesh counts once.
    #[must_use]
    pub fn stored_triangle_count(&self) -> u64 {
        self.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum()
    }

    /// Returns the bytes of memory used, including spare capacity, without images in files.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let meshes: u64 = self.meshes.iter().map(Mesh::bytes).sum();
        let instances: u64 = self
            .instances
            .iter()
            .map(|instance| {
                let labels = instance.labels.iter();
                instance.path.capacity() as u64
                    + list_bytes(&instance.labels)
                    + labels
                        .map(|label| {
                            (label.prim.capacity() + label.taxonomy.capacity() + label.name.capacity()) as u64
                        })
                        .sum::<u64>()
            })
            .sum();
        let textures: u64 = self
            .textures
            .iter()
            .map(|texture| match &texture.source {
                TextureSource::File(_) => 0,
                TextureSource::Encoded { bytes, .. } => bytes.len() as u64,
                TextureSource::Pixels(image) => size_of_val(image.pixels()) as u64,
            })
            .sum();
        meshes
            + instances
            + textures
            + list_bytes(&self.meshes)
            + list_bytes(&self.instances)
            + list_bytes(&self.materials)
            + list_bytes(&self.textures)
            + list_bytes(&self.lights)
    }
}

impl Mesh {
    /// Returns the bytes of memory used by the mesh's lists.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        list_bytes(&self.positions)
            + list_bytes(&self.triangles)
            + list_bytes(&self.materials)
            + self.normals.as_ref().map_or(0, MeshAttribute::bytes)
            + self.uvs.as_ref().map_or(0, MeshAttribute::bytes)
            + self.colors.as_ref().map_or(0, MeshAttribute::bytes)
    }
}

impl<T> MeshAttribute<T> {
    fn bytes(&self) -> u64 {
        match self {
            Self::Constant(_) => 0,
            Self::Triangle(values) | Self::Vertex(values) => list_bytes(values),
            Self::Corner { values, indices } => list_bytes(values) + list_bytes(indices),
        }
    }
}

fn list_bytes<T>(list: &Vec<T>) -> u64 {
    (list.capacity() * size_of::<T>()) as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape;
    use oaktwin_camera::math::DAffine3;

    #[test]
    fn instances_share_triangles() {
        let instance = Instance {
            mesh: 0,
            path: String::new(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: Vec::new(),
            material_offset: 0,
        };
        let mut scene = Scene {
            meshes: vec![shape::cube(1.0)],
            instances: vec![instance.clone()],
            ..Scene::default()
        };
        let bytes = scene.bytes();
        assert!(bytes >= 24 * (12 + 12 + 8) + 12 * 12, "{bytes}");
        scene.instances.extend(vec![instance; 9]);
        assert_eq!((scene.triangle_count(), scene.stored_triangle_count()), (120, 12));
        assert!(scene.bytes() - bytes < 20 * size_of::<Instance>() as u64);
    }
}
