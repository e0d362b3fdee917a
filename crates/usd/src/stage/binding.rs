//! Material bindings by OpenUSD's rules: the nearest binding applies unless an ancestor's is stronger than its
//! descendants'; on one prim, collection bindings take precedence over direct ones.

use std::rc::Rc;

use openusd::sdf::Path;

use super::reader::{Reader, Record};
use super::value::{boolean, text};

/// The purposes of bindings, in the order in which they are tried: full, all-purpose, preview.
const PURPOSES: [&str; 3] = [":full", "", ":preview"];
const PREFIX: &str = "material:binding";

/// A material binding of a prim and its descendants.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Binding {
    /// The index in [`PURPOSES`].
    purpose: usize,
    material: Path,
    stronger_than_descendants: bool,
    /// The collection that it applies to; `None` for all prims.
    collection: Option<Collection>,
}

/// A collection of prims.
#[derive(Clone, Debug, PartialEq)]
struct Collection {
    includes: Vec<Path>,
    excludes: Vec<Path>,
    /// Whether it includes the descendants of included prims.
    expands: bool,
    everything: bool,
}

/// Returns the bindings authored on a prim, collection bindings first.
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

    /// Whether it contains a prim, depending on the nearest included or excluded ancestor or the prim itself.
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

/// The bindings of a prim and its ancestors, the prim's own first.
#[derive(Clone, Debug, Default)]
pub(super) struct Bindings(Option<Rc<Level>>);

#[derive(Debug)]
struct Level {
    own: Vec<Binding>,
    above: Bindings,
}

impl Bindings {
    /// Returns the bindings of a child with the bindings `own`.
    pub(super) fn with(&self, own: &[Binding]) -> Self {
        if own.is_empty() {
            return self.clone();
        }
        Self(Some(Rc::new(Level {
            own: own.to_vec(),
            above: self.clone(),
        })))
    }

    /// Returns the materials of a prim in the order in which to try them. Collections may contain its composed path or
    /// its scene path.
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
