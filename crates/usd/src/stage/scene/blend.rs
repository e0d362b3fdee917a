//! Blend shapes of `UsdSkel`: weighted displacements of points, before their skin.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::polygon::{Interpolation, PolygonMesh};
use openusd::sdf::Value;
use openusd::tf::Token;

use super::super::reader::{Outcome, Reader, Record};
use super::super::value::{floats, ints, texts, vec3s};
use super::super::walk::Walk;
use super::context::Context;
use super::skin;

/// The displacements of a mesh.
#[derive(Debug, Default)]
pub(super) struct Blend {
    shapes: Vec<BlendShape>,
}

/// A shape with its weight.
#[derive(Debug)]
struct BlendShape {
    weight: f64,
    /// The points that it moves; all, if there are none.
    points: Vec<i32>,
    offsets: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
}

/// Returns the blend shapes of the mesh `prim` with the weights of the animation that is bound to its skeleton; `None` if nothing moves it. An
/// error says what cannot be applied.
pub(super) fn read(
    walk: &Walk<'_>,
    prim: &Record,
    context: &Context,
) -> Outcome<Result<Option<Blend>, String>> {
    let reader = walk.reader;
    let (Some(skeleton), true) = (&context.skeleton, prim.has("skel:blendShapes")) else {
        return Ok(Ok(None));
    };
    let names = reader
        .value(prim, "skel:blendShapes")
        .and_then(texts)
        .unwrap_or_default();
    let targets = reader.targets(prim, "skel:blendShapeTargets");
    if names.len() != targets.len() {
        return Ok(Err(format!(
            "it names {} blend shapes and {} targets",
            names.len(),
            targets.len()
        )));
    }
    let Some(animation) = skin::placed(walk, skeleton, context)?.1 else {
        return Ok(Ok(None));
    };
    let animation = walk.record(&animation, true)?;
    let animated = reader
        .value(&animation, "blendShapes")
        .and_then(texts)
        .unwrap_or_default();
    let weights = reader
        .posed(&animation, "blendShapeWeights")
        .and_then(floats)
        .unwrap_or_default();
    if weights.is_empty() {
        return Ok(Ok(None));
    }
    if weights.len() != animated.len() {
        return Ok(Err(format!(
            "its animation has {} weights for {} blend shapes",
            weights.len(),
            animated.len()
        )));
    }
    let mut blend = Blend::default();
    for (name, target) in names.iter().zip(targets) {
        let at = animated.iter().position(|own| own == name);
        let Some(weight) = at
            .map(|at| f64::from(weights[at]))
            .filter(|weight| *weight != 0.0)
        else {
            continue;
        };
        let shape = walk.record(&target, true)?;
        if shape.type_name.as_str() != "BlendShape" {
            return Ok(Err(format!("its blend shape <{target}> does not exist")));
        }
        blend.add(reader, &shape, weight);
    }
    Ok(Ok((!blend.shapes.is_empty()).then_some(blend)))
}

impl Blend {
    /// Adds a shape. Between shapes of different weights, of which 0 is the mesh itself and 1 the shape, displacements are linear.
    fn add(&mut self, reader: &Reader, shape: &Record, weight: f64) {
        let vectors = |name: &str| reader.value(shape, name).and_then(vec3s).unwrap_or_default();
        let points = reader
            .value(shape, "pointIndices")
            .and_then(ints)
            .unwrap_or_default();
        // The name of the offsets of each shape, by its weight.
        let mut steps: Vec<(f64, Option<String>)> = vec![(0.0, None), (1.0, Some("offsets".to_owned()))];
        let names = shape.properties.iter().map(Token::as_str);
        let between =
            names.filter(|name| name.starts_with("inbetweens:") && !name.ends_with(":normalOffsets"));
        for name in between {
            let path = shape.path.append_property(name).ok();
            let at = path.and_then(|path| match reader.field(&path, "weight") {
                Some(Value::Float(at)) => Some(f64::from(at)),
                Some(Value::Double(at)) => Some(at),
                _ => None,
            });
            steps.extend(at.map(|at| (at, Some(name.to_owned()))));
        }
        steps.sort_by(|a, b| a.0.total_cmp(&b.0));
        steps.dedup_by(|a, b| a.0 == b.0);
        let after = steps
            .partition_point(|step| step.0 <= weight)
            .clamp(1, steps.len() - 1);
        let (from, to) = (&steps[after - 1], &steps[after]);
        let u = (weight - from.0) / (to.0 - from.0);
        for (weight, name) in [(1.0 - u, &from.1), (u, &to.1)] {
            let Some(name) = name.as_ref().filter(|_| weight != 0.0) else {
                continue;
            };
            let normals = match name.as_str() {
                "offsets" => vectors("normalOffsets"),
                name => vectors(&format!("{name}:normalOffsets")),
            };
            self.shapes.push(BlendShape {
                weight,
                points: points.clone(),
                offsets: vectors(name),
                normals,
            });
        }
    }

    /// Displaces the points and the normals of a mesh. Returns why it cannot.
    pub(super) fn apply(&self, mesh: &mut PolygonMesh) -> Result<(), String> {
        let count = mesh.points.len();
        let mut moved = vec![DVec3::ZERO; count];
        let mut turned = vec![DVec3::ZERO; count];
        for shape in &self.shapes {
            for (sums, offsets) in [(&mut moved, &shape.offsets), (&mut turned, &shape.normals)] {
                if !shape.points.is_empty() && !offsets.is_empty() && offsets.len() != shape.points.len() {
                    let (offsets, points) = (offsets.len(), shape.points.len());
                    return Err(format!("a blend shape has {offsets} offsets for {points} points"));
                }
                for (at, offset) in offsets.iter().enumerate() {
                    let point = match shape.points.get(at) {
                        Some(point) => usize::try_from(*point).ok(),
                        None => Some(at),
                    };
                    let Some(sum) = point.and_then(|point| sums.get_mut(point)) else {
                        return Err(format!("a blend shape moves a point beyond the {count} points"));
                    };
                    *sum += DVec3::from(offset.map(f64::from)) * shape.weight;
                }
            }
        }
        for (point, by) in mesh.points.iter_mut().zip(&moved) {
            *point = (DVec3::from(point.map(f64::from)) + *by).as_vec3().to_array();
        }
        if turned.iter().all(|by| *by == DVec3::ZERO) {
            return Ok(());
        }
        let corners = &mesh.face_vertex_indices;
        if let Some(normals) = mesh.normals.as_mut().filter(|normals| normals.indices.is_none()) {
            let interpolation = normals.interpolation;
            for (element, normal) in normals.values.iter_mut().enumerate() {
                let point = match interpolation {
                    Interpolation::Vertex => Some(element),
                    Interpolation::FaceVarying => corners
                        .get(element)
                        .and_then(|point| usize::try_from(*point).ok()),
                    _ => None,
                };
                if let Some(by) = point.and_then(|point| turned.get(point)) {
                    let sum = DVec3::from(normal.map(f64::from)) + *by;
                    *normal = sum.normalize_or_zero().as_vec3().to_array();
                }
            }
        }
        Ok(())
    }
}
