use std::rc::Rc;

use openusd::sdf::Path;

use super::super::reader::{Reader, Record};
use super::super::transform::{LocalTransform, local_transform};
use super::super::value::{text, texts};

/// What a prim itself says of what its children inherit.
pub(in crate::stage) struct Own {
    pub(super) transform: Option<LocalTransform>,
    pub(super) invisible: bool,
    pub(super) purpose: Option<Purpose>,
    pub(super) labels: Vec<(String, String)>,
    pub(super) bindings: Vec<(BindingPurpose, Binding)>,
    /// Whether it has primvars that its children may inherit.
    pub(super) has_primvars: bool,
}

/// What a part of the scene is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// For all.
    Default,
    /// For the final picture.
    Render,
    /// For a quick look, or for people who work on the scene.
    Other,
}

/// For which purpose a material is bound; the first that leads to a material wins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BindingPurpose {
    /// For the final picture.
    Full,
    /// For all.
    All,
    /// For a quick look.
    Preview,
}

impl BindingPurpose {
    pub(super) const ALL: [(Self, &str); 3] = [
        (Self::Full, "material:binding:full"),
        (Self::All, "material:binding"),
        (Self::Preview, "material:binding:preview"),
    ];
}

/// A material that is bound to a prim and what is below it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Binding {
    pub(super) material: Path,
    /// Whether it wins over what its descendants bind.
    pub(super) stronger_than_descendants: bool,
}

impl Own {
    pub(in crate::stage) fn of(reader: &Reader, prim: &Record) -> Self {
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
            bindings: bindings(reader, prim),
            has_primvars: prim.properties.iter().any(|name| name.starts_with("primvars:")),
        }
    }
}

/// Semantic labels: OpenUSD's `semantics:labels:TAXONOMY` and the older
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

/// Materials that are bound directly.
fn bindings(reader: &Reader, prim: &Record) -> Vec<(BindingPurpose, Binding)> {
    let mut found = Vec::new();
    for (purpose, name) in BindingPurpose::ALL {
        let Some(material) = reader.targets(prim, name).into_iter().next() else {
            continue;
        };
        let strength = prim
            .path
            .append_property(name)
            .ok()
            .and_then(|path| reader.field(&path, "bindMaterialAs"))
            .and_then(text);
        found.push((
            purpose,
            Binding {
                material,
                stronger_than_descendants: strength.is_some_and(|s| s == "strongerThanDescendants"),
            },
        ));
    }
    found
}

/// Which materials are bound, for each purpose.
#[derive(Clone, Debug, Default)]
pub(super) struct Bindings([Option<Rc<Binding>>; 3]);

impl Bindings {
    /// What holds for a prim that itself binds `own`.
    pub(super) fn with(&self, own: &[(BindingPurpose, Binding)]) -> Self {
        let mut all = self.clone();
        for (purpose, binding) in own {
            let slot = &mut all.0[*purpose as usize];
            if !slot.as_ref().is_some_and(|bound| bound.stronger_than_descendants) {
                *slot = Some(Rc::new(binding.clone()));
            }
        }
        all
    }

    /// The materials in the order in which they are to be tried.
    pub(super) fn candidates(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().flatten().map(|binding| &binding.material)
    }
}
