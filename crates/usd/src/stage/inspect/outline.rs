//! What composition can make of a layer: its prims, and the arcs that stay within it.

use std::collections::HashMap;

use openusd::sdf::{Data, Path, SpecType, Value};

use super::super::ancestry;
use super::super::usda::SPLINE_FIELD;
use super::super::value::number;
use super::Problem;

/// The fields with arcs.
pub(super) const ARC_FIELDS: [&str; 6] = [
    "references",
    "payload",
    "inheritPaths",
    "specializes",
    "variantSetNames",
    CLIPS_FIELD,
];

/// The fields of the layer itself with arcs, and with what arcs refer to.
pub(super) const ROOT_FIELDS: [&str; 2] = ["defaultPrim", "subLayers"];

/// The field of attributes with time samples.
pub(in crate::stage) const SAMPLES_FIELD: &str = "timeSamples";
/// The fields of attributes whose values change with time.
pub(super) const ANIMATION_FIELDS: [&str; 2] = [SAMPLES_FIELD, SPLINE_FIELD];
/// The field of prims with value clips.
pub(in crate::stage) const CLIPS_FIELD: &str = "clips";

/// The outline of a layer.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::stage) struct Outline {
    /// The number of authored prims, approximately.
    pub(in crate::stage) prims: u64,
    /// The arcs to prims of the same layer stack.
    pub(in crate::stage) arcs: Vec<Arc>,
    /// The references and payloads to other layers.
    pub(in crate::stage) references: Vec<Reference>,
    /// The path of the default prim.
    pub(in crate::stage) default_prim: Option<String>,
    /// The asset paths of the sublayers.
    pub(in crate::stage) sublayers: Vec<String>,
    /// The value clips that templates describe.
    pub(in crate::stage) clips: Clips,
    /// Whether attributes may have time samples or splines.
    pub(in crate::stage) is_animated: bool,
    /// Whether prims may have value clips.
    pub(in crate::stage) has_clips: bool,
}

/// The times of the value clips that templates describe, over all templates: their fields may be in different layers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::stage) struct Clips {
    start: Option<f64>,
    end: Option<f64>,
    stride: Option<f64>,
}

impl Clips {
    /// Adds the fields of a dictionary of clip sets.
    fn add(&mut self, sets: &HashMap<String, Value>) {
        for set in sets.values() {
            if let Value::Dictionary(set) = set {
                let field = |name: &str| set.get(name).and_then(number);
                *self = self.with(Self {
                    start: field("templateStartTime"),
                    end: field("templateEndTime"),
                    stride: field("templateStride").filter(|stride| *stride > 0.0),
                });
            }
        }
    }

    pub(in crate::stage) fn with(self, other: Self) -> Self {
        let either = |a: Option<f64>, b: Option<f64>, choose: fn(f64, f64) -> f64| match (a, b) {
            (Some(a), Some(b)) => Some(choose(a, b)),
            (a, b) => a.or(b),
        };
        Self {
            start: either(self.start, other.start, f64::min),
            end: either(self.end, other.end, f64::max),
            stride: either(self.stride, other.stride, f64::min),
        }
    }

    /// Returns an upper bound on the number of clips; 0 without a template.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the count is not negative, and saturates"
    )]
    pub(in crate::stage) fn count(self) -> u64 {
        let (Some(start), Some(end), Some(stride)) = (self.start, self.end, self.stride) else {
            return 0;
        };
        let count = (end - start).max(0.0) / stride;
        // The library adds the stride to the time, which must be large enough to change it.
        let advances = stride > start.abs().max(end.abs()) * f64::EPSILON;
        if advances { count as u64 } else { u64::MAX }
    }
}

/// An arc to a prim of the same layer stack.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in crate::stage) struct Arc {
    /// The path of the prim on which it is authored, without variant selections.
    pub(in crate::stage) prim: String,
    pub(in crate::stage) kind: ArcKind,
    /// The path of the target; for a variant set, its name.
    pub(in crate::stage) target: String,
}

/// A reference or a payload to a prim of another layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::stage) struct Reference {
    /// The path of the prim on which it is authored, without variant selections.
    pub(in crate::stage) prim: String,
    /// The asset path of the layer, as authored.
    pub(in crate::stage) asset: String,
    /// The path of the target; the default prim if none is named.
    pub(in crate::stage) target: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::stage) enum ArcKind {
    /// A reference or a payload.
    Reference,
    /// An inherited or specialized prim.
    Class,
    /// A variant set, whose selected variant is a separate site.
    VariantSet,
}

/// Returns the outline of a layer with `prims` prims.
pub(super) fn outline(layer: &Data, prims: u64) -> Result<Outline, Problem> {
    let mut arcs = Arcs::new(prims);
    if let Some(root) = layer.spec(&Path::abs_root()) {
        for name in ROOT_FIELDS {
            if let Some(value) = root.get(name) {
                arcs.root(name, value)?;
            }
        }
    }
    let mut with_arcs = Vec::new();
    for (path, spec) in layer.iter() {
        match spec.ty {
            SpecType::Prim | SpecType::Variant if ARC_FIELDS.iter().any(|name| spec.contains(name)) => {
                with_arcs.push((path, spec));
            }
            SpecType::Attribute => {
                arcs.outline.is_animated |= ANIMATION_FIELDS.iter().any(|name| spec.contains(name));
            }
            _ => {}
        }
    }
    // The layer has no order of its own.
    with_arcs.sort_by_key(|(path, _)| path.as_str());
    for (path, spec) in with_arcs {
        for name in ARC_FIELDS {
            if let Some(value) = spec.get(name) {
                arcs.add(path, name, value)?;
            }
        }
    }
    Ok(arcs.outline)
}

/// Collects the arcs of a layer.
pub(super) struct Arcs {
    pub(super) outline: Outline,
}

impl Arcs {
    pub(super) fn new(prims: u64) -> Self {
        Self {
            outline: Outline {
                prims,
                ..Outline::default()
            },
        }
    }

    /// Adds the field `name` of the layer itself. References that name no prim lead to the default prim, which must be
    /// known before them.
    pub(super) fn root(&mut self, name: &str, value: &Value) -> Result<(), Problem> {
        match value {
            Value::Token(prim) if name == "defaultPrim" => {
                let prim = prim.as_str();
                let slash = if prim.starts_with('/') { "" } else { "/" };
                let path = format!("{slash}{prim}");
                if let Some(defect) = Path::new(&path).ok().as_ref().and_then(ancestry::defect) {
                    let what = format!("`{}` {defect}", ancestry::beginning(prim));
                    return Err(Problem::new("defaultPrim", what, "give the name of a prim"));
                }
                self.outline.default_prim = Some(path);
            }
            Value::StringVec(paths) if name == "subLayers" => self.outline.sublayers.clone_from(paths),
            _ => {}
        }
        Ok(())
    }

    /// Adds the arcs in the field `name` of the prim or variant at `path`.
    pub(super) fn add(&mut self, path: &Path, name: &str, value: &Value) -> Result<(), Problem> {
        let prim = path.strip_all_variant_selections();
        let absolute = |target: &Path| {
            let target = prim.make_absolute(target).strip_all_variant_selections();
            target.as_str().to_owned()
        };
        let outline = &mut self.outline;
        let mut push = |kind, target: String| {
            outline.arcs.push(Arc {
                prim: prim.as_str().to_owned(),
                kind,
                target,
            });
        };
        let default_prim = outline.default_prim.clone();
        let references = &mut outline.references;
        let mut refer = |asset: &str, target: &Path| {
            let target = (!target.is_empty()).then(|| absolute(target));
            if !asset.is_empty() {
                references.push(Reference {
                    prim: prim.as_str().to_owned(),
                    asset: asset.to_owned(),
                    target,
                });
            } else if let Some(to) = target.or_else(|| default_prim.clone()) {
                push(ArcKind::Reference, to);
            }
        };
        match value {
            Value::Dictionary(sets) if name == CLIPS_FIELD => {
                outline.has_clips = true;
                outline.clips.add(sets);
            }
            Value::ReferenceListOp(list) => {
                list.iter().for_each(|arc| refer(&arc.asset_path, &arc.prim_path));
            }
            Value::PayloadListOp(list) => {
                list.iter().for_each(|arc| refer(&arc.asset_path, &arc.prim_path));
            }
            Value::Payload(arc) => refer(&arc.asset_path, &arc.prim_path),
            Value::PathListOp(list) => {
                for to in list.iter().filter(|to| !to.is_empty()).map(absolute) {
                    if to.contains('.') {
                        let what = format!("inherits or specializes <{to}>, which is not the path of a prim");
                        return Err(Problem::new(prim.as_str(), what, "give the path of a prim"));
                    }
                    push(ArcKind::Class, to);
                }
            }
            Value::StringListOp(list) if name == "variantSetNames" => list
                .iter()
                .for_each(|name| push(ArcKind::VariantSet, name.clone())),
            Value::TokenListOp(list) if name == "variantSetNames" => list
                .iter()
                .for_each(|name| push(ArcKind::VariantSet, name.as_str().to_owned())),
            _ => {}
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_the_clips_of_templates() {
        let clips = |start, end, stride| Clips {
            start: Some(start),
            end: Some(end),
            stride: Some(stride),
        };
        assert_eq!(Clips::default().count(), 0);
        assert_eq!(clips(1.0, 101.0, 2.0).count(), 50);
        // A layer may override the stride of another.
        let stride = Clips {
            stride: Some(0.5),
            ..Clips::default()
        };
        assert_eq!(clips(1.0, 101.0, 2.0).with(stride).count(), 200);
        assert_eq!(clips(1e30, 1e30, 1.0).count(), u64::MAX);
        assert_eq!(clips(0.0, f64::INFINITY, 1.0).count(), u64::MAX);
    }
}
