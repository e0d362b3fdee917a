//! The reflectance of surfaces in the infrared.

use oaktwin_base::diagnostic::suggest;
use std::collections::BTreeMap;

use crate::{Material, MaterialSpan, Scene};

/// A reflectance that a scene cannot have: `NAME: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name}: {what}; {remedy}")]
pub struct InfraredError {
    /// The name of the material or the label.
    pub name: String,
    /// What is wrong.
    pub what: String,
    /// What to do.
    pub remedy: String,
}

impl Scene {
    /// Sets the reflectance at 940 nm, from 0 to 1, of the materials of each name, which may be the last part of a path, and of the surfaces
    /// with each semantic label. Materials that other surfaces share are copied.
    ///
    /// # Errors
    /// Returns an error if a value is not within 0 and 1, or no material and no label has a name.
    pub fn set_infrared(&mut self, reflectances: &BTreeMap<String, f64>) -> Result<(), InfraredError> {
        for (name, value) in reflectances {
            self.set_one(name, *value)?;
        }
        Ok(())
    }

    /// Returns the names that [`Scene::set_infrared`] knows, sorted: the last part of each material's, and the labels.
    #[must_use]
    pub fn infrared_names(&self) -> Vec<&str> {
        let materials = self.materials.iter().map(|material| &material.name);
        let own = self.instances.iter().flat_map(|instance| &instance.labels);
        let labels = own.chain(self.possible_labels.iter().flatten());
        let mut all: Vec<&str> = (materials.filter_map(|name| name.rsplit('/').next()))
            .chain(labels.map(|label| label.name.as_str()))
            .filter(|name| !name.is_empty())
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn set_one(&mut self, name: &str, value: f64) -> Result<(), InfraredError> {
        if !(0.0..=1.0).contains(&value) {
            return Err(InfraredError {
                name: name.to_owned(),
                what: format!("a reflectance of {value} is out of range"),
                remedy: "give 0 to 1".to_owned(),
            });
        }
        #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
        let value = value as f32;
        let mut is_known = false;
        for material in &mut self.materials {
            let last = material.name.rsplit('/').next();
            if material.name == name || last == Some(name) {
                material.infrared = Some(value);
                is_known = true;
            }
        }
        for index in 0..self.instances.len() {
            if self.instances[index]
                .labels
                .iter()
                .any(|label| label.name == name)
            {
                self.recolor(index, value);
                is_known = true;
            }
        }
        // What appears at other times is known, too.
        is_known |= self
            .possible_labels
            .iter()
            .flatten()
            .any(|label| label.name == name);
        if is_known {
            return Ok(());
        }
        let all = self.infrared_names();
        Err(InfraredError {
            name: name.to_owned(),
            what: "no material and no label has this name".to_owned(),
            remedy: match all.is_empty() {
                true => "the scene has neither; name a material in its file".to_owned(),
                false => suggest(name, all),
            },
        })
    }

    /// Gives an instance materials of its own, with a reflectance.
    fn recolor(&mut self, index: usize, value: f32) {
        let instance = &self.instances[index];
        let Some(mesh) = self.meshes.get(instance.mesh as usize) else {
            return;
        };
        let spans = mesh.materials.iter();
        let used: Vec<Option<Material>> = spans
            .map(|span| instance.material(span.material))
            .map(|material| self.materials.get(material? as usize).cloned())
            .collect();
        let last = mesh.materials.last().map_or(0, |span| span.end);
        let is_whole = last as usize >= mesh.triangles.len();
        let of_mesh: Vec<Option<u32>> = mesh.materials.iter().map(|span| span.material).collect();
        let first = u32::try_from(self.materials.len()).unwrap_or(u32::MAX);
        if is_whole && of_mesh.iter().all(Option::is_some) && !of_mesh.is_empty() {
            // The indices of the mesh stay; the offset of the instance leads to copies.
            let least = of_mesh.iter().flatten().min().copied().unwrap_or(0);
            let most = of_mesh.iter().flatten().max().copied().unwrap_or(0);
            let copies = (least..=most).map(|of_mesh| {
                let own = instance.material(Some(of_mesh));
                let own = own.and_then(|own| self.materials.get(own as usize)).cloned();
                Material {
                    infrared: Some(value),
                    ..own.unwrap_or_default()
                }
            });
            let copies: Vec<Material> = copies.collect();
            self.materials.extend(copies);
            self.instances[index].material_offset = first.saturating_sub(least);
            return;
        }
        // Some triangles have no material.
        let mut copy = mesh.clone();
        let count = u32::try_from(copy.triangles.len()).unwrap_or(u32::MAX);
        if !is_whole {
            copy.materials.push(MaterialSpan {
                end: count,
                material: None,
            });
        }
        let mut used = used.into_iter();
        for (next, span) in (first..).zip(&mut copy.materials) {
            let own = used.next().flatten();
            self.materials.push(Material {
                infrared: Some(value),
                ..own.unwrap_or_else(Material::bare)
            });
            span.material = Some(next);
        }
        self.instances[index].mesh = u32::try_from(self.meshes.len()).unwrap_or(u32::MAX);
        self.instances[index].material_offset = 0;
        self.meshes.push(copy);
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::math::DAffine3;

    use super::*;
    use crate::{Instance, Label, Mesh};

    /// Two instances of a mesh with a material, and one of a mesh without; the first and the last are labelled `cup`.
    fn scene() -> Scene {
        let mesh = |material: Option<u32>| Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2]],
            materials: (material.into_iter())
                .map(|material| MaterialSpan {
                    end: 1,
                    material: Some(material),
                })
                .collect(),
            ..Mesh::default()
        };
        let instance = |mesh, label: Option<&str>| Instance {
            mesh,
            path: String::new(),
            world_from_mesh: DAffine3::IDENTITY,
            labels: (label.into_iter())
                .map(|name| Label {
                    prim: String::new(),
                    taxonomy: "class".to_owned(),
                    name: name.to_owned(),
                })
                .collect(),
            material_offset: 0,
        };
        let material = |name: &str, grey: f32| Material {
            name: name.to_owned(),
            base_color: Some([grey; 3]),
            ..Material::default()
        };
        Scene {
            meshes: vec![mesh(Some(1)), mesh(None)],
            instances: vec![
                instance(0, Some("cup")),
                instance(0, None),
                instance(1, Some("cup")),
            ],
            materials: vec![material("/Looks/Black", 0.02), material("/Looks/Red", 0.3)],
            ..Scene::default()
        }
    }

    fn set(scene: &mut Scene, name: &str, value: f64) -> Result<(), InfraredError> {
        scene.set_infrared(&BTreeMap::from([(name.to_owned(), value)]))
    }

    /// A colour and a reflectance.
    type Reflectance = (Option<[f32; 3]>, Option<f32>);

    /// The look of each instance's surface.
    fn surfaces(scene: &Scene) -> Vec<Option<Reflectance>> {
        let of = |instance: &Instance| {
            let mesh = &scene.meshes[instance.mesh as usize];
            let material = instance.material(mesh.material(0))?;
            let material = &scene.materials[material as usize];
            Some((material.base_color, material.infrared))
        };
        scene.instances.iter().map(of).collect()
    }

    #[test]
    fn materials_have_it_by_name_and_surfaces_by_label() {
        let red = Some([0.3; 3]);
        for name in ["Red", "/Looks/Red"] {
            let mut scene = scene();
            set(&mut scene, name, 0.7).unwrap();
            let seen = Some((red, Some(0.7)));
            assert_eq!(surfaces(&scene), [seen, seen, None]);
        }
        let mut scene = scene();
        set(&mut scene, "cup", 0.5).unwrap();
        let bare = Material::bare().base_color;
        let expected = [(red, Some(0.5)), (red, None), (bare, Some(0.5))].map(Some);
        assert_eq!(surfaces(&scene), expected);
        // Again, for what has materials of its own by now.
        set(&mut scene, "cup", 0.0).unwrap();
        assert_eq!(surfaces(&scene)[2], Some((bare, Some(0.0))));
        assert_eq!(surfaces(&scene)[1], Some((red, None)));
    }

    #[test]
    fn wrong_names_and_values_are_rejected() {
        let mut scene = scene();
        let error = set(&mut scene, "cups", 0.5).unwrap_err().to_string();
        assert_eq!(
            error,
            "cups: no material and no label has this name; did you mean 'cup'?"
        );
        for value in [-0.1, 1.01, f64::NAN] {
            let error = set(&mut scene, "cup", value).unwrap_err().to_string();
            assert!(error.ends_with("is out of range; give 0 to 1"), "{error}");
        }
        let error = set(&mut Scene::default(), "cup", 0.5).unwrap_err().to_string();
        assert!(
            error.ends_with("the scene has neither; name a material in its file"),
            "{error}"
        );
    }
}
