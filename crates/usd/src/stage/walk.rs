use std::collections::HashMap;
use std::rc::Rc;

use openusd::sdf::{Path, Specifier};

use super::reader::{Outcome, Reader, Record, child_path};

/// Namespaces nest no deeper than this in what people make; references that nest layers in layers could.
const DEEPEST: usize = 1000;

/// Something that is done with every prim.
pub(super) trait Visitor {
    /// What a prim hands down to its children.
    type Context;

    /// The prim that the scene knows as `path`; `None` keeps away from its children.
    fn prim(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        context: &Self::Context,
    ) -> Outcome<Option<Self::Context>>;
}

/// A depth-first traversal over active, defined and concrete prims and into instances. What instances share is read
/// once.
pub(super) struct Walk<'a> {
    pub(super) reader: &'a Reader,
    shared: std::cell::RefCell<HashMap<Path, Rc<Record>>>,
}

/// Which prims a traversal comes by.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    /// What is defined and not a class.
    Defined,
    /// Whatever is not deactivated: what is drawn by a point instancer may lie in classes and overrides.
    Active,
}

impl<'a> Walk<'a> {
    pub(super) fn new(reader: &'a Reader) -> Self {
        Self {
            reader,
            shared: std::cell::RefCell::default(),
        }
    }

    /// The prim at `path`, from memory if it was read as a shared one.
    pub(super) fn record(&self, path: &Path, shared: bool) -> Outcome<Rc<Record>> {
        if !shared {
            return Ok(Rc::new(self.reader.record(path.clone())?));
        }
        if let Some(known) = self.shared.borrow().get(path) {
            return Ok(known.clone());
        }
        let record = Rc::new(self.reader.record(path.clone())?);
        self.shared.borrow_mut().insert(path.clone(), record.clone());
        Ok(record)
    }

    /// Visits the whole stage.
    pub(super) fn stage<V: Visitor>(&self, visitor: &mut V, context: &V::Context) -> Outcome<()> {
        for path in self.reader.roots()? {
            let name = path.as_str().to_owned();
            self.from(visitor, &path, &name, context, Which::Defined)?;
        }
        Ok(())
    }

    /// Visits the prim composed at `composed`, which the scene knows as `path`, and all below it.
    pub(super) fn from<V: Visitor>(
        &self,
        visitor: &mut V,
        composed: &Path,
        path: &str,
        context: &V::Context,
        which: Which,
    ) -> Outcome<()> {
        let shared = which == Which::Active || is_in_prototype(composed);
        self.below(visitor, composed, path, context, which, shared, 0)
    }

    #[expect(clippy::too_many_arguments, reason = "what recursion carries along")]
    fn below<V: Visitor>(
        &self,
        visitor: &mut V,
        composed: &Path,
        path: &str,
        context: &V::Context,
        which: Which,
        shared: bool,
        depth: usize,
    ) -> Outcome<()> {
        if depth >= DEEPEST {
            return Err(format!("<{path}>: prims nest more than {DEEPEST} deep").into());
        }
        let record = self.record(composed, shared)?;
        let wanted = match which {
            Which::Defined => record.specifier == Specifier::Def,
            Which::Active => true,
        };
        if !record.active || !wanted {
            return Ok(());
        }
        let Some(inner) = visitor.prim(self, &record, path, context)? else {
            return Ok(());
        };
        let shared = shared || record.prototype.is_some();
        let parent = record.prototype.as_ref().unwrap_or(&record.path);
        for name in &record.children {
            let Some(child) = child_path(parent, name.as_str()) else {
                continue;
            };
            let path = format!("{path}/{name}");
            self.below(visitor, &child, &path, &inner, which, shared, depth + 1)?;
        }
        Ok(())
    }
}

/// Whether a path lies in what instances share.
pub(super) fn is_in_prototype(path: &Path) -> bool {
    path.as_str().starts_with("/__Prototype_")
}
