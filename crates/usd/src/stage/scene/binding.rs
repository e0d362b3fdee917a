//! Which material a prim is bound to, by OpenUSD's rules: the nearest binding wins unless one further up is stronger
//! than its descendants'; on one prim collections come before direct bindings.

use std::rc::Rc;

use openusd::sdf::Path;

use super::super::reader::{Reader, Record};
use super::super::value::{boolean, text};

/// For which purpose a material is bound, in the order in which they are tried: for the final picture, for all, for a
/// quick look.
const PURPOSES: [&str; 3] = [":full", "", ":preview"];
const PREFIX: &str = "material:binding";

/// A material that a prim binds for itself and what is below it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Binding {
    /// Into [`PURPOSES`].
    purpose: usize,
    material: Path,
    stronger_than_descendants: bool,
    /// What it is bound to; `None` for all.
    collection: Option<Collection>,
}

/// Prims that are named.
#[derive(Clone, Debug, PartialEq)]
struct Collection {
    includes: Vec<Path>,
    excludes: Vec<Path>,
    /// Whether what is below the included prims belongs to it too.
    expands: bool,
    everything: bool,
}

/// The bindings that a prim authors, those to collections first.
pub(super) fn bindings(reader: &Reader, prim: &Record) -> Vec<Binding> {
    if !prim.properties.iter().any(|name| name.starts_with(PREFIX)) {
        return Vec::new();
    }
    let strong = |name: &str| {
        let path = prim.path.append_property(name).ok();
        let strength = path.and_then(|path| reader.field(&path, "bindMaterialAs"));
        strength
            .and_then(text)
            .is_some_and(|s| s == "strongerThanDescendants")
    };
    let mut found = Vec::new();
    for name in &prim.properties {
        let Some(rest) = name.strip_prefix("material:binding:collection:") else {
            continue;
        };
        let purpose = match rest.split_once(':') {
            Some(("full", _)) => 0,
            Some(("preview", _)) => 2,
            _ => 1,
        };
        if let [collection, material] = &reader.targets(prim, name.as_str())[..] {
            found.extend(Collection::read(reader, collection).map(|collection| Binding {
                purpose,
                material: material.clone(),
                stronger_than_descendants: strong(name.as_str()),
                collection: Some(collection),
            }));
        }
    }
    for (purpose, suffix) in PURPOSES.iter().enumerate() {
        let name = format!("{PREFIX}{suffix}");
        found.extend(
            reader
                .targets(prim, &name)
                .into_iter()
                .next()
                .map(|material| Binding {
                    purpose,
                    material,
                    stronger_than_descendants: strong(&name),
                    collection: None,
                }),
        );
    }
    found
}

impl Collection {
    /// Reads the collection at `/Prim.collection:NAME`.
    fn read(reader: &Reader, path: &Path) -> Option<Self> {
        let (prim, name) = path.split_property()?;
        let name = name.trim_start_matches('.');
        let targets = |what: &str| {
            let path = prim.append_property(format!("{name}:{what}")).ok();
            let relationship = path.map(|path| reader.stage.relationship(path));
            relationship
                .and_then(|of| of.forwarded_targets().ok())
                .unwrap_or_default()
        };
        let value = |what: &str| reader.attribute_value(&prim, &format!("{name}:{what}"));
        Some(Self {
            includes: targets("includes"),
            excludes: targets("excludes"),
            expands: value("expansionRule")
                .and_then(text)
                .is_none_or(|rule| rule != "explicitOnly"),
            everything: value("includeRoot").is_some_and(|v| boolean(&v) == Some(true)),
        })
    }

    /// Whether a prim belongs to it: the nearest of it and its ancestors that is named decides.
    fn contains(&self, prim: &Path) -> bool {
        if !self.expands {
            return self.includes.contains(prim);
        }
        let mut at = Some(prim.clone());
        while let Some(path) = at.filter(|path| !path.is_abs_root()) {
            if self.excludes.contains(&path) {
                return false;
            }
            if self.includes.contains(&path) {
                return true;
            }
            at = path.parent();
        }
        self.everything
    }
}

/// The bindings of a prim and its ancestors, its own first.
#[derive(Clone, Debug, Default)]
pub(super) struct Bindings(Option<Rc<Level>>);

#[derive(Debug)]
struct Level {
    own: Vec<Binding>,
    above: Bindings,
}

impl Bindings {
    /// What holds for a prim that itself binds `own`.
    pub(super) fn with(&self, own: &[Binding]) -> Self {
        if own.is_empty() {
            return self.clone();
        }
        Self(Some(Rc::new(Level {
            own: own.to_vec(),
            above: self.clone(),
        })))
    }

    /// The materials of a prim in the order in which they are to be tried. It is composed at `composed`, and the
    /// scene knows it as `path`; collections may name it either way.
    pub(super) fn candidates(&self, composed: &Path, path: &str) -> Vec<&Path> {
        let path = Path::new(path).unwrap_or_else(|_| composed.clone());
        let mut found = [None; PURPOSES.len()];
        let mut at = self.0.as_deref();
        while let Some(level) = at {
            for (purpose, slot) in found.iter_mut().enumerate() {
                let here = level.own.iter().find(|binding| {
                    let belongs = |to: &Collection| to.contains(composed) || to.contains(&path);
                    binding.purpose == purpose && binding.collection.as_ref().is_none_or(belongs)
                });
                if let Some(binding) = here
                    && (slot.is_none() || binding.stronger_than_descendants)
                {
                    *slot = Some(&binding.material);
                }
            }
            at = level.above.0.as_deref();
        }
        found.into_iter().flatten().collect()
    }
}
