use openusd::sdf::Path;

use super::binding::{Binding, bindings};
use super::reader::{Reader, Record};
use super::transform::{LocalTransform, local_transform};
use super::value::{text, texts};

/// The inheritable opinions authored on a prim itself.
pub(super) struct PrimOpinions {
    pub(super) transform: Option<LocalTransform>,
    pub(super) invisible: bool,
    pub(super) purpose: Option<Purpose>,
    pub(super) labels: Vec<(String, String)>,
    pub(super) bindings: Vec<Binding>,
    /// The path of a `SkelRoot`, below which skeletons and their meshes are.
    pub(super) skeleton_root: Option<Path>,
    /// The skeleton that is bound to the prim and its descendants.
    pub(super) skeleton: Option<Path>,
    /// The animation that is bound to the prim and its descendants.
    pub(super) animation: Option<Path>,
    /// Whether it has primvars, which its descendants may inherit.
    pub(super) has_primvars: bool,
}

/// The purpose of a prim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// `default`.
    Default,
    /// `render`.
    Render,
    /// `proxy` or `guide`, which are not rendered.
    Other,
}

impl PrimOpinions {
    pub(super) fn of(reader: &Reader, prim: &Record) -> Self {
        let token = |name: &str| reader.value(prim, name).and_then(text);
        Self {
            transform: local_transform(reader, prim),
            invisible: token("visibility").is_some_and(|visibility| visibility == "invisible"),
            purpose: token("purpose").map(|purpose| match purpose.as_str() {
                "default" => Purpose::Default,
                "render" => Purpose::Render,
                _ => Purpose::Other,
            }),
            labels: labels(reader, prim),
            skeleton_root: (prim.type_name.as_str() == "SkelRoot").then(|| prim.path.clone()),
            skeleton: reader.targets(prim, "skel:skeleton").pop(),
            animation: reader.targets(prim, "skel:animationSource").pop(),
            bindings: bindings(reader, prim),
            has_primvars: prim.properties.iter().any(|name| name.starts_with("primvars:")),
        }
    }
}

/// Returns semantic labels: OpenUSD's `semantics:labels:TAXONOMY` and the older
/// `semantic:NAME:params:semanticType`/`semanticData` of Isaac Sim.
fn labels(reader: &Reader, prim: &Record) -> Vec<(String, String)> {
    let mut labels = Vec::new();
    for name in &prim.properties {
        if let Some(taxonomy) = name.strip_prefix("semantics:labels:") {
            let values = reader.value(prim, name.as_str()).and_then(texts);
            for label in values.unwrap_or_default() {
                labels.push((taxonomy.to_owned(), label));
            }
        } else if let Some(instance) = name.strip_suffix(":params:semanticData")
            && name.starts_with("semantic:")
        {
            let taxonomy = reader
                .value(prim, &format!("{instance}:params:semanticType"))
                .and_then(text)
                .filter(|taxonomy| !taxonomy.is_empty());
            if let Some(label) = reader.value(prim, name.as_str()).and_then(text) {
                labels.push((taxonomy.unwrap_or_else(|| "class".to_owned()), label));
            }
        }
    }
    labels
}
