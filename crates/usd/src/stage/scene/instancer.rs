use std::collections::HashSet;

use oaktwin_camera::math::{DAffine3, DVec3};
use openusd::sdf::Path;

use super::super::reader::{Reader, Record};
use super::super::transform::unchecked_rotation;
use super::super::value::{ids, ints, quaternions, vec3s};
use super::findings::Findings;

/// A point instancer: prototypes and their transforms.
pub(super) struct PointInstancer {
    pub(super) prototypes: Vec<Path>,
    pub(super) points: Vec<Point>,
}

/// An instance of a point instancer.
pub(super) struct Point {
    /// The index in the instancer's arrays.
    pub(super) index: usize,
    /// The index of the prototype.
    pub(super) prototype: usize,
    /// The transform: scale, then rotation, then translation.
    pub(super) instancer_from_prototype: DAffine3,
}

const CODE: &str = "point-instancer";
const REMEDY: &str = "export it again";

impl PointInstancer {
    pub(super) fn read(reader: &Reader, prim: &Record, path: &str, findings: &mut Findings) -> Self {
        let prototypes = reader.targets(prim, "prototypes");
        let which = reader
            .value(prim, "protoIndices")
            .and_then(ints)
            .unwrap_or_default();
        let positions = reader
            .value(prim, "positions")
            .and_then(vec3s)
            .unwrap_or_default();
        if positions.len() != which.len() {
            let message = format!("{} positions for {} instances", positions.len(), which.len());
            findings.warn(CODE, path, message, REMEDY);
        }
        let count = which.len().min(positions.len());
        let mut matching = |name: &str, length: usize| {
            let fits = length == 0 || length == which.len();
            if !fits {
                let message = format!("{length} {name} for {} instances; they are ignored", which.len());
                findings.warn(CODE, path, message, REMEDY);
            }
            fits && length > 0
        };
        let scales = reader
            .value(prim, "scales")
            .and_then(vec3s)
            .filter(|scales| matching("scales", scales.len()));
        // The newer single-precision attribute takes precedence.
        let orientations = reader
            .value(prim, "orientationsf")
            .and_then(quaternions)
            .filter(|of| !of.is_empty())
            .or_else(|| reader.value(prim, "orientations").and_then(quaternions))
            .filter(|orientations| matching("orientations", orientations.len()));
        let hidden = hidden(reader, prim);
        let names = reader.value(prim, "ids").and_then(ids);
        let mut points = Vec::with_capacity(count);
        let mut invalid = 0_usize;
        for index in 0..count {
            let name = names
                .as_ref()
                .and_then(|names| names.get(index).copied())
                .or_else(|| i64::try_from(index).ok());
            if name.is_some_and(|name| hidden.contains(&name)) {
                continue;
            }
            let Some(prototype) = usize::try_from(which[index])
                .ok()
                .filter(|prototype| *prototype < prototypes.len())
            else {
                invalid += 1;
                continue;
            };
            let mut transform = DAffine3::from_translation(vector(positions[index]));
            if let Some(orientations) = &orientations {
                transform.matrix3 = unchecked_rotation(orientations[index]);
            }
            if let Some(scales) = &scales {
                transform *= DAffine3::from_scale(vector(scales[index]));
            }
            points.push(Point {
                index,
                prototype,
                instancer_from_prototype: transform,
            });
        }
        if invalid > 0 {
            let message = format!("{invalid} instances with an invalid prototype index are skipped");
            findings.warn(CODE, path, message, REMEDY);
        }
        Self { prototypes, points }
    }
}

/// Returns the ids of invisible and inactive instances.
fn hidden(reader: &Reader, prim: &Record) -> HashSet<i64> {
    let invisible = reader
        .value(prim, "invisibleIds")
        .and_then(ids)
        .unwrap_or_default();
    let inactive = reader
        .field(&prim.path, "inactiveIds")
        .and_then(ids)
        .unwrap_or_default();
    invisible.into_iter().chain(inactive).collect()
}

fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}
