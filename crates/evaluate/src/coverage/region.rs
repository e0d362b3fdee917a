use std::collections::{BTreeMap, BTreeSet};

use oaktwin_base::diagnostic::{message, nearest, opt, suggestion};
use oaktwin_scene::{Bounds, Scene};

use super::CoverageError;

/// A part of the surface of a scene. By default everything.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    /// The paths of prims: the meshes at and below these paths belong to the region. If empty, all meshes.
    pub objects: Vec<String>,
    /// The paths of prims that do not belong to the region, such as a robot that moves.
    pub without: Vec<String>,
    /// A box in the world, in metres: surface outside it does not belong to the region.
    pub within: Option<Bounds>,
}

impl Region {
    /// Returns the indices of the instances that belong to the region.
    ///
    /// # Errors
    /// Returns an error if an object is unknown, or the box is reversed or not finite.
    pub(super) fn instances(&self, scene: &Scene) -> Result<Vec<usize>, CoverageError> {
        self.check_box()?;
        let mut chosen = BTreeSet::new();
        for object in &self.objects {
            let before = chosen.len();
            let mut known = false;
            for (index, instance) in scene.instances.iter().enumerate() {
                if instance.is_below(object) {
                    known = true;
                    chosen.insert(index);
                }
            }
            if !known && before == chosen.len() {
                return Err(unknown(scene, object));
            }
        }
        if self.objects.is_empty() {
            chosen.extend(0..scene.instances.len());
        }
        let is_left_out = |index: &usize| {
            let instance = &scene.instances[*index];
            self.without.iter().any(|prim| instance.is_below(prim))
        };
        let left: Vec<usize> = chosen
            .iter()
            .copied()
            .filter(|index| !is_left_out(index))
            .collect();
        if left.is_empty() && !chosen.is_empty() {
            let what = format!(
                ": there is nothing but {}, which moves; choose other objects",
                self.without.join(", ")
            );
            return Err(message![opt("region"), what].into());
        }
        Ok(left)
    }

    /// Returns the number of triangles of the instances that may belong to the region: the bounds of each meet its box.
    ///
    /// # Errors
    /// Returns an error if an object is unknown, or the box is reversed or not finite.
    pub fn triangles(&self, scene: &Scene) -> Result<u64, CoverageError> {
        let mut bounds: BTreeMap<u32, Option<Bounds>> = BTreeMap::new();
        let mut total = 0u64;
        for index in self.instances(scene)? {
            let instance = &scene.instances[index];
            let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
                continue;
            };
            if let Some(within) = self.within {
                let own = bounds.entry(instance.mesh).or_insert_with(|| mesh.bounds());
                let meets = |own: Bounds| {
                    let own = own.transformed(instance.world_from_mesh);
                    own.min.cmple(within.max).all() && own.max.cmpge(within.min).all()
                };
                if !own.is_some_and(meets) {
                    continue;
                }
            }
            total = total.saturating_add(mesh.triangles.len() as u64);
        }
        Ok(total)
    }

    fn check_box(&self) -> Result<(), CoverageError> {
        let Some(Bounds { min, max }) = self.within else {
            return Ok(());
        };
        let axes = || {
            ["x", "y", "z"]
                .into_iter()
                .zip(min.to_array())
                .zip(max.to_array())
        };
        for ((axis, min), max) in axes() {
            if !(min.is_finite() && max.is_finite()) {
                let wrong = if min.is_finite() { max } else { min };
                return Err(message![
                    opt("region-box"),
                    format!(": {axis} is {wrong}; give finite numbers in metres")
                ]
                .into());
            }
            if min > max {
                return Err(message![
                    opt("region-box"),
                    format!(
                        ": the minimum of {axis}, {min}, is above its maximum, {max}; give the minimum corner first"
                    )
                ]
                .into());
            }
        }
        Ok(())
    }
}

/// The error for an object that is not in the scene. It suggests prims with this name before those with a similar path.
fn unknown(scene: &Scene, object: &str) -> CoverageError {
    let mut prims: BTreeSet<&str> = BTreeSet::new();
    for instance in &scene.instances {
        let mut path = instance.path.as_str();
        // An ancestor that is known has known ancestors.
        while !path.is_empty() && prims.insert(path) {
            path = path.rsplit_once('/').map_or("", |(parent, _)| parent);
        }
    }
    let name = |path: &str| path.rsplit('/').next().unwrap_or_default().to_lowercase();
    let wanted = name(object.trim_end_matches('/'));
    let mut near: Vec<&str> = prims
        .iter()
        .copied()
        .filter(|prim| name(prim) == wanted)
        .collect();
    near.truncate(3);
    if near.is_empty() {
        near = nearest(object, prims.iter().copied());
    }
    let known: Vec<&str> = prims.iter().copied().take(5).collect();
    message![
        opt("region"),
        format!(
            ": the scene has no geometry at '{object}'; {}",
            suggestion(&near, &known)
        )
    ]
    .into()
}
