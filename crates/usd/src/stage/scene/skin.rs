//! Skinned meshes: where a skeleton's pose moves their points.
//!
//! The rules are those of `UsdSkel`'s linear blend skinning. With a time code the pose is the animation's, otherwise the
//! animation's default values or the skeleton's rest pose.

use std::collections::HashMap;

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_scene::polygon::{Interpolation, PolygonMesh, Primvar};
use openusd::sdf::{Path, Value};

use super::super::reader::{Outcome, Reader, Record};
use super::super::transform::{affine, local_transform};
use super::super::value::{floats, ints, quaternions, text, texts, vec3s};
use super::super::walk::Walk;
use super::context::Context;

/// What moves the points of a mesh.
pub(super) struct Skin {
    /// The frame of the moved points: the skeleton's. The transform of the mesh itself has no effect.
    pub(super) stage_from_skeleton: DAffine3,
    /// For each joint of the mesh, the motion from the mesh's bound frame.
    motions: Vec<DAffine3>,
    /// For each point, or once for all, the joints and their weights.
    joints: Vec<i32>,
    weights: Vec<f32>,
    influences: usize,
    is_rigid: bool,
}

/// Returns the skin of the mesh `prim`; `None` if it has none. An error says why `UsdSkel` would not apply it either.
pub(super) fn read(
    walk: &Walk<'_>,
    prim: &Record,
    context: &Context,
) -> Outcome<Result<Option<Skin>, String>> {
    const JOINTS: &str = "primvars:skel:jointIndices";
    const WEIGHTS: &str = "primvars:skel:jointWeights";
    let reader = walk.reader;
    let Some(path) = context
        .skeleton
        .as_ref()
        .filter(|_| prim.has(JOINTS) && prim.has(WEIGHTS))
    else {
        return Ok(Ok(None));
    };
    let skeleton = walk.record(path, true)?;
    if skeleton.type_name.as_str() != "Skeleton" {
        return Ok(Err(format!("its skeleton <{path}> does not exist")));
    }
    let field = |name: &str| {
        let path = prim.path.append_property(JOINTS).ok()?;
        reader.field(&path, name)
    };
    let influences = match field("elementSize") {
        Some(Value::Int(size)) => usize::try_from(size).unwrap_or(1).max(1),
        _ => 1,
    };
    let is_rigid = field("interpolation")
        .and_then(text)
        .is_none_or(|interpolation| interpolation == "constant");
    let joints = reader.value(prim, JOINTS).and_then(ints).unwrap_or_default();
    let weights = reader.value(prim, WEIGHTS).and_then(floats).unwrap_or_default();
    if joints.len() != weights.len() || !joints.len().is_multiple_of(influences) {
        return Ok(Err(format!(
            "it has {} joint indices and {} weights, with {influences} for each point",
            joints.len(),
            weights.len()
        )));
    }
    let (stage_from_skeleton, animation) = placed(walk, path, context)?;
    let animation = animation
        .map(|animation| walk.record(&animation, true))
        .transpose()?;
    let pose = match Pose::read(reader, &skeleton, animation.as_deref().map(|prim| &**prim)) {
        Ok(pose) => pose,
        Err(what) => return Ok(Err(format!("its skeleton <{path}> {what}"))),
    };
    let bound = reader
        .value(prim, "primvars:skel:geomBindTransform")
        .and_then(|value| matrices(value)?.first().copied());
    let of_mesh = reader.value(prim, "skel:joints").and_then(texts);
    let Some(motions) = pose.motions(of_mesh.as_deref(), bound.unwrap_or(DAffine3::IDENTITY)) else {
        return Ok(Err(format!(
            "it names a joint that its skeleton <{path}> does not have"
        )));
    };
    let exists = |joint: &i32| usize::try_from(*joint).is_ok_and(|joint| joint < motions.len());
    if !joints.iter().all(exists) {
        return Ok(Err(format!(
            "a joint index is beyond the {} joints",
            motions.len()
        )));
    }
    Ok(Ok(Some(Skin {
        stage_from_skeleton,
        motions,
        joints,
        weights,
        influences,
        is_rigid,
    })))
}

/// Converts matrices for row vectors.
fn matrices(value: Value) -> Option<Vec<DAffine3>> {
    match value {
        Value::Matrix4d(matrix) => Some(vec![affine(&matrix.0)]),
        Value::Matrix4dVec(matrices) => Some(matrices.iter().map(|matrix| affine(&matrix.0)).collect()),
        _ => None,
    }
}

/// Returns the transform of a skeleton and the animation that is bound to it.
pub(super) fn placed(
    walk: &Walk<'_>,
    skeleton: &Path,
    context: &Context,
) -> Outcome<(DAffine3, Option<Path>)> {
    let above = context.skeleton_root.as_ref();
    let above = above.filter(|(root, _)| skeleton.has_prefix(root));
    let (root, mut stage_from_prim) = above.cloned().unwrap_or((Path::abs_root(), DAffine3::IDENTITY));
    let mut chain: Vec<Path> = skeleton
        .strict_ancestors()
        .chain([skeleton.clone()])
        .filter(|path| !path.is_abs_root() && !root.has_prefix(path))
        .collect();
    chain.sort_by_key(|path| path.as_str().len());
    let mut animation = context.animation.clone();
    for path in chain {
        let record = walk.record(&path, true)?;
        if let Some(local) = local_transform(walk.reader, &record) {
            stage_from_prim = local.below(stage_from_prim);
        }
        if let Some(source) = walk.reader.targets(&record, "skel:animationSource").pop() {
            animation = Some(source);
        }
    }
    Ok((stage_from_prim, animation))
}

/// A skeleton's joints, bound and posed, in the skeleton's frame.
struct Pose {
    names: Vec<String>,
    bound: Vec<DAffine3>,
    posed: Vec<DAffine3>,
}

impl Pose {
    fn read(reader: &Reader, skeleton: &Record, animation: Option<&Record>) -> Result<Self, &'static str> {
        let names = reader
            .value(skeleton, "joints")
            .and_then(texts)
            .unwrap_or_default();
        let of = |name: &str| reader.value(skeleton, name).and_then(matrices);
        let bound = of("bindTransforms").filter(|bound| bound.len() == names.len());
        let bound = bound.ok_or("has no bind transform for each joint")?;
        let mut locals = of("restTransforms").filter(|rest| rest.len() == names.len());
        if let Some(animation) = animation {
            animate(reader, animation, &names, &mut locals);
        }
        let Some(locals) = locals else {
            // Without a rest pose it is not posed.
            return Ok(Self {
                posed: bound.clone(),
                names,
                bound,
            });
        };
        let index: HashMap<&str, usize> = names.iter().map(String::as_str).zip(0..).collect();
        let mut posed: Vec<DAffine3> = Vec::with_capacity(names.len());
        for (name, local) in names.iter().zip(locals) {
            let mut ancestor = name.as_str();
            let parent = loop {
                let Some((above, _)) = ancestor.rsplit_once('/') else {
                    break None;
                };
                ancestor = above;
                if let Some(parent) = index.get(ancestor) {
                    break Some(*parent);
                }
            };
            // Parents come first; others are roots.
            posed.push(match parent.and_then(|parent| posed.get(parent)) {
                Some(skeleton_from_parent) => *skeleton_from_parent * local,
                None => local,
            });
        }
        Ok(Self { names, bound, posed })
    }

    /// Returns the motions of the joints `names`, or of all, from the frame that `bound` binds to the skeleton's.
    fn motions(&self, names: Option<&[String]>, bound: DAffine3) -> Option<Vec<DAffine3>> {
        let motion = |joint: usize| self.posed[joint] * self.bound[joint].inverse() * bound;
        match names {
            None => Some((0..self.names.len()).map(motion).collect()),
            Some(names) => {
                let index: HashMap<&str, usize> = self.names.iter().map(String::as_str).zip(0..).collect();
                names
                    .iter()
                    .map(|name| index.get(name.as_str()).copied().map(motion))
                    .collect()
            }
        }
    }
}

/// Replaces the local transforms of the joints that a `SkelAnimation` moves, if it is complete.
fn animate(reader: &Reader, animation: &Record, names: &[String], locals: &mut Option<Vec<DAffine3>>) {
    let joints = reader
        .value(animation, "joints")
        .and_then(texts)
        .unwrap_or_default();
    let complete = |count: usize| count == joints.len();
    let translations = reader.posed(animation, "translations").and_then(vec3s);
    let rotations = reader.posed(animation, "rotations").and_then(quaternions);
    let scales = reader.posed(animation, "scales").and_then(vec3s);
    let (Some(translations), Some(rotations), Some(scales)) = (translations, rotations, scales) else {
        return;
    };
    if ![translations.len(), rotations.len(), scales.len()]
        .into_iter()
        .all(complete)
    {
        return;
    }
    let index: HashMap<&str, usize> = names.iter().map(String::as_str).zip(0..).collect();
    if locals.is_none() && names.iter().all(|name| joints.contains(name)) {
        *locals = Some(vec![DAffine3::IDENTITY; names.len()]);
    }
    let Some(locals) = locals else { return };
    let vector = |v: &[f32; 3]| DVec3::new(v[0].into(), v[1].into(), v[2].into());
    for (at, joint) in joints.iter().enumerate() {
        if let Some(joint) = index.get(joint.as_str()) {
            locals[*joint] = DAffine3::from_scale_rotation_translation(
                vector(&scales[at]),
                rotations[at].normalize(),
                vector(&translations[at]),
            );
        }
    }
}

impl Skin {
    /// Moves the points and the normals of a mesh into the skeleton's frame. Returns why it cannot.
    pub(super) fn apply(&self, mesh: &mut PolygonMesh) -> Result<(), String> {
        let count = self.joints.len() / self.influences;
        if !self.is_rigid && count != mesh.points.len() {
            return Err(format!(
                "it has joints for {count} of {} points",
                mesh.points.len()
            ));
        }
        let motion = |point: usize| {
            let from = if self.is_rigid { 0 } else { point * self.influences };
            let range = from..from + self.influences;
            let mut sum = DAffine3::from_mat3(DMat3::ZERO);
            for (joint, weight) in self.joints[range.clone()].iter().zip(&self.weights[range]) {
                let joint = usize::try_from(*joint).unwrap_or_default();
                let (motion, weight) = (&self.motions[joint], f64::from(*weight));
                sum.matrix3 += motion.matrix3 * weight;
                sum.translation += motion.translation * weight;
            }
            sum
        };
        if let Some(normals) = &mut mesh.normals
            && !moved_normals(normals, &mesh.face_vertex_indices, mesh.points.len(), motion)
        {
            mesh.normals = None;
        }
        for (at, point) in mesh.points.iter_mut().enumerate() {
            let [x, y, z] = point.map(f64::from);
            *point = motion(at)
                .transform_point3(DVec3::new(x, y, z))
                .as_vec3()
                .to_array();
        }
        Ok(())
    }
}

/// Moves normals of points or corners; `false` for others, which follow from the faces.
fn moved_normals(
    normals: &mut Primvar<[f32; 3]>,
    corners: &[i32],
    points: usize,
    motion: impl Fn(usize) -> DAffine3,
) -> bool {
    let point_of = |element: usize| match normals.interpolation {
        Interpolation::Vertex => Some(element),
        Interpolation::FaceVarying => usize::try_from(*corners.get(element)?).ok(),
        _ => None,
    };
    let moved: Option<Vec<[f32; 3]>> = normals
        .values
        .iter()
        .enumerate()
        .map(|(element, normal)| {
            let point = point_of(element).filter(|point| *point < points)?;
            let [x, y, z] = normal.map(f64::from);
            let turned = motion(point).matrix3.inverse().transpose() * DVec3::new(x, y, z);
            Some(turned.normalize_or_zero().as_vec3().to_array())
        })
        .collect();
    match moved.filter(|_| normals.indices.is_none()) {
        Some(moved) => {
            normals.values = moved;
            true
        }
        None => false,
    }
}
