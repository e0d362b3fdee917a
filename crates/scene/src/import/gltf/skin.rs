//! Skins: the vertices of a mesh follow joints, and the transform of the mesh's node has no effect (glTF 2.0, section 3.7.3).

use ::gltf::json::mesh::{Primitive, Semantic};
use ::gltf::json::validation::Checked;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};

use super::accessor::Accessor;
use super::document::Document;
use super::placement::Skin;
use crate::import::builder::is_invertible;

impl Skin {
    /// Poses a mesh with the joints where their nodes are.
    pub(super) fn pose(
        &self,
        document: &Document,
        file_from_nodes: &[DAffine3],
        file_from_node: DAffine3,
    ) -> Result<Pose, String> {
        if self.joints.is_empty() {
            return Err("it has no joints".into());
        }
        let inverse_bind = self
            .inverse_bind
            .map(|index| Accessor::find(document, index))
            .transpose()?;
        if let Some(matrices) = inverse_bind.as_ref()
            && (matrices.components() != 16 || matrices.count < self.joints.len())
        {
            return Err(format!(
                "its {} joints have no inverse bind matrices",
                self.joints.len()
            ));
        }
        document.allow(16 * self.joints.len() as u64)?;
        let joint = |(at, node): (usize, &usize)| {
            let file_from_joint = file_from_nodes.get(*node).ok_or("a joint does not exist")?;
            let joint_from_mesh = inverse_bind.as_ref().map_or(DAffine3::IDENTITY, |matrices| {
                // The fourth row is 0 0 0 1.
                let [x, y, z, t] = [0, 4, 8, 12].map(|column| {
                    let m: [f32; 16] = matrices.floats(at);
                    DVec3::new(m[column].into(), m[column + 1].into(), m[column + 2].into())
                });
                DAffine3::from_mat3_translation(DMat3::from_cols(x, y, z), t)
            });
            Ok(*file_from_joint * joint_from_mesh)
        };
        let file_from_mesh: Result<Vec<DAffine3>, String> =
            self.joints.iter().enumerate().map(joint).collect();
        let file_from_mesh = file_from_mesh?;
        // In the frame of the first joint, a mesh in its bind pose keeps the file's numbers.
        let frame = Some(file_from_mesh[0]).filter(|frame| frame.is_finite() && is_invertible(*frame));
        let file_from_frame = frame.unwrap_or(DAffine3::IDENTITY);
        let frame_from_file = file_from_frame.inverse();
        Ok(Pose {
            file_from_frame,
            joints: file_from_mesh
                .iter()
                .map(|joint| frame_from_file * *joint)
                .collect(),
            frame_from_node: frame_from_file * file_from_node,
        })
    }
}

/// A mesh's pose: for each joint, the transform of what follows it alone.
pub(super) struct Pose {
    /// The transform of the posed mesh.
    pub(super) file_from_frame: DAffine3,
    joints: Vec<DAffine3>,
    /// The transform of primitives that follow no joint.
    frame_from_node: DAffine3,
}

impl Pose {
    /// Moves the points and normals of a primitive's vertices. Returns why they do not follow joints, if so.
    pub(super) fn apply(
        &self,
        document: &Document,
        primitive: &Primitive,
        vertices: impl Iterator<Item = usize> + Clone,
        points: &mut [[f32; 3]],
        mut normals: Option<&mut [[f32; 3]]>,
    ) -> Result<(), String> {
        let influences = Influence::read_all(document, primitive).and_then(|influences| {
            document.allow(8 * (influences.len() * points.len()) as u64)?;
            vertices
                .clone()
                .try_for_each(|vertex| self.blend(&influences, vertex).map(drop))?;
            Ok(influences)
        });
        let transform = |vertex| match &influences {
            Ok(influences) => self.blend(influences, vertex).unwrap_or(self.frame_from_node),
            Err(_) => self.frame_from_node,
        };
        for (i, vertex) in vertices.enumerate().take(points.len()) {
            let transform = transform(vertex);
            points[i] = narrow(transform.transform_point3(wide(points[i])));
            if let Some(normal) = normals.as_mut().and_then(|normals| normals.get_mut(i)) {
                let [x, y, z] = [0, 1, 2].map(|axis| transform.matrix3.col(axis));
                // The inverse transpose times the size of the determinant; it exists for every matrix.
                let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
                let sign = transform.matrix3.determinant().signum();
                *normal = narrow((cofactors * wide(*normal) * sign).normalize_or_zero());
            }
        }
        influences.map(drop)
    }

    /// The mean of the transforms of a vertex's joints, by weight.
    fn blend(&self, influences: &[Influence<'_>], vertex: usize) -> Result<DAffine3, String> {
        let joint = |number: f32| {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "16 bits at most"
            )]
            let joint = self.joints.get(number as usize);
            joint.ok_or_else(|| format!("a vertex follows joint {number} of {}", self.joints.len()))
        };
        let (mut matrix, mut translation, mut sum) = (DMat3::ZERO, DVec3::ZERO, 0.0);
        for Influence { joints, weights } in influences {
            let numbers: [f32; 4] = joints.floats(vertex);
            let weights: [f32; 4] = weights.floats(vertex);
            for (number, weight) in numbers.into_iter().zip(weights.map(f64::from)) {
                if weight == 0.0 {
                    continue;
                }
                let joint = joint(number)?;
                matrix += joint.matrix3 * weight;
                translation += joint.translation * weight;
                sum += weight;
            }
        }
        if sum == 0.0 {
            // A vertex without weights follows its first joint.
            let [first, ..]: [f32; 4] = influences
                .first()
                .map_or([0.0; 4], |first| first.joints.floats(vertex));
            return joint(first).copied();
        }
        Ok(DAffine3::from_mat3_translation(
            matrix * (1.0 / sum),
            translation / sum,
        ))
    }
}

/// Up to four joints of each vertex, with their weights.
struct Influence<'a> {
    joints: Accessor<'a>,
    weights: Accessor<'a>,
}

impl<'a> Influence<'a> {
    fn read_all(document: &'a Document, primitive: &Primitive) -> Result<Vec<Self>, String> {
        let find = |semantic: Semantic| {
            let index = primitive.attributes.get(&Checked::Valid(semantic))?;
            Some(Accessor::find(document, index.value()))
        };
        let count = find(Semantic::Positions)
            .transpose()?
            .map_or(0, |positions| positions.count);
        let mut influences = Vec::new();
        for set in 0.. {
            let (Some(joints), Some(weights)) = (find(Semantic::Joints(set)), find(Semantic::Weights(set)))
            else {
                break;
            };
            let (joints, weights) = (joints?, weights?);
            if [&joints, &weights]
                .iter()
                .any(|values| values.count != count || values.components() != 4)
            {
                return Err(format!(
                    "JOINTS_{set} and WEIGHTS_{set} do not have 4 × {count} values"
                ));
            }
            influences.push(Self { joints, weights });
        }
        if influences.is_empty() {
            return Err("it has no JOINTS_0 and WEIGHTS_0".into());
        }
        Ok(influences)
    }
}

fn wide(vector: [f32; 3]) -> DVec3 {
    DVec3::from(vector.map(f64::from))
}

#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn narrow(vector: DVec3) -> [f32; 3] {
    vector.to_array().map(|x| x as f32)
}
