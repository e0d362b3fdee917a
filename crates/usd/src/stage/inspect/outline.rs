//! What composition can make of a layer: its prims, and the arcs that stay within it.

use openusd::sdf::{AbstractData, Path, SpecType, Value};

/// The fields with arcs.
pub(super) const ARC_FIELDS: [&str; 5] = [
    "references",
    "payload",
    "inheritPaths",
    "specializes",
    "variantSetNames",
];

/// The fields of the layer itself with arcs, and with what arcs refer to.
pub(super) const ROOT_FIELDS: [&str; 2] = ["defaultPrim", "subLayers"];

/// The outline of a layer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::stage) struct Outline {
    /// The number of authored prims, approximately.
    pub(in crate::stage) prims: u64,
    /// The arcs to prims of the same layer stack.
    pub(in crate::stage) arcs: Vec<Arc>,
    /// The asset paths of the sublayers.
    pub(in crate::stage) sublayers: Vec<String>,
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

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::stage) enum ArcKind {
    /// A reference or a payload.
    Reference,
    /// An inherited or specialized prim.
    Class,
    /// A variant set, whose selected variant is a site of its own.
    VariantSet,
}

/// Returns the outline of a layer with `prims` prims.
pub(super) fn outline(layer: &dyn AbstractData, prims: u64) -> Outline {
    let mut arcs = Arcs::new(prims);
    let field = |path: &Path, name: &str| layer.try_field(path, name).ok().flatten();
    for name in ROOT_FIELDS {
        if let Some(value) = field(&Path::abs_root(), name) {
            arcs.root(name, &value);
        }
    }
    for path in layer.spec_paths() {
        if !matches!(layer.spec_type(&path), Some(SpecType::Prim | SpecType::Variant)) {
            continue;
        }
        for name in ARC_FIELDS {
            if let Some(value) = field(&path, name) {
                arcs.add(&path, name, &value);
            }
        }
    }
    arcs.outline
}

/// Collects the arcs of a layer.
pub(super) struct Arcs {
    pub(super) outline: Outline,
    /// The target of references that name no prim.
    default: Option<String>,
}

impl Arcs {
    pub(super) fn new(prims: u64) -> Self {
        Self {
            outline: Outline {
                prims,
                ..Outline::default()
            },
            default: None,
        }
    }

    /// Adds the field `name` of the layer itself. References that name no prim lead to the default prim, which must be
    /// known before them.
    pub(super) fn root(&mut self, name: &str, value: &Value) {
        match value {
            Value::Token(prim) if name == "defaultPrim" => {
                let prim = prim.as_str();
                let slash = if prim.starts_with('/') { "" } else { "/" };
                self.default = Some(format!("{slash}{prim}"));
            }
            Value::StringVec(paths) if name == "subLayers" => self.outline.sublayers.clone_from(paths),
            _ => {}
        }
    }

    /// Adds the arcs in the field `name` of the prim or variant at `path`.
    pub(super) fn add(&mut self, path: &Path, name: &str, value: &Value) {
        let prim = path.strip_all_variant_selections();
        let mut push = |kind, target: String| {
            self.outline.arcs.push(Arc {
                prim: prim.as_str().to_owned(),
                kind,
                target,
            });
        };
        let default = self.default.as_ref();
        let target = |target: &Path| {
            if target.is_empty() {
                return default.cloned();
            }
            let target = prim.make_absolute(target).strip_all_variant_selections();
            Some(target.as_str().to_owned())
        };
        match value {
            Value::ReferenceListOp(list) => list
                .iter()
                .filter(|arc| arc.asset_path.is_empty())
                .filter_map(|arc| target(&arc.prim_path))
                .for_each(|to| push(ArcKind::Reference, to)),
            Value::PayloadListOp(list) => list
                .iter()
                .filter(|arc| arc.asset_path.is_empty())
                .filter_map(|arc| target(&arc.prim_path))
                .for_each(|to| push(ArcKind::Reference, to)),
            Value::Payload(arc) if arc.asset_path.is_empty() => {
                if let Some(to) = target(&arc.prim_path) {
                    push(ArcKind::Reference, to);
                }
            }
            Value::PathListOp(list) => list
                .iter()
                .filter_map(target)
                .for_each(|to| push(ArcKind::Class, to)),
            Value::StringListOp(list) if name == "variantSetNames" => list
                .iter()
                .for_each(|name| push(ArcKind::VariantSet, name.clone())),
            Value::TokenListOp(list) if name == "variantSetNames" => list
                .iter()
                .for_each(|name| push(ArcKind::VariantSet, name.as_str().to_owned())),
            _ => {}
        }
    }
}
