//! How large a scene is.

use crate::{Attribute, Instance, Mesh, Scene, TextureSource};

impl Scene {
    /// How many triangles are seen: those of a mesh once for each of its instances.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let of_instance = |instance: &Instance| {
            self.meshes
                .get(instance.mesh as usize)
                .map_or(0, |mesh| mesh.triangles.len() as u64)
        };
        self.instances.iter().map(of_instance).sum()
    }

    /// How many triangles are stored: those of a mesh once.
    #[must_use]
    pub fn stored_triangle_count(&self) -> u64 {
        self.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum()
    }

    /// The memory that it takes, with room that lists have to spare, without images in files.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let meshes: u64 = self.meshes.iter().map(Mesh::bytes).sum();
        let instances: u64 = self
            .instances
            .iter()
            .map(|instance| {
                let labels = instance.labels.iter();
                instance.path.capacity() as u64
                    + room(&instance.labels)
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
            + room(&self.meshes)
            + room(&self.instances)
            + room(&self.materials)
            + room(&self.textures)
            + room(&self.lights)
    }
}

impl Mesh {
    /// The memory that its lists take.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        room(&self.positions)
            + room(&self.triangles)
            + room(&self.materials)
            + self.normals.as_ref().map_or(0, Attribute::bytes)
            + self.uvs.as_ref().map_or(0, Attribute::bytes)
            + self.colors.as_ref().map_or(0, Attribute::bytes)
    }
}

impl<T> Attribute<T> {
    fn bytes(&self) -> u64 {
        match self {
            Self::Constant(_) => 0,
            Self::Triangle(values) | Self::Vertex(values) => room(values),
            Self::Corner { values, indices } => room(values) + room(indices),
        }
    }
}

fn room<T>(list: &Vec<T>) -> u64 {
    (list.capacity() * size_of::<T>()) as u64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape;
    use oaktwin_camera::math::DAffine3;

    #[test]
    fn instances_share_their_triangles() {
        let instance = Instance {
            mesh: 0,
            path: String::new(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: Vec::new(),
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
