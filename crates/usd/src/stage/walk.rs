use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;
use std::ops::Deref;
use std::rc::Rc;

use openusd::sdf::{Path, Specifier};

use super::prim_opinions::PrimOpinions;
use super::reader::{Outcome, Reader, Record, child_path};

/// The maximum depth of prims. Only layers that reference themselves through others exceed it.
const MAX_DEPTH: usize = 1000;

/// A prim of a traversal.
pub(super) struct VisitedPrim {
    record: Record,
    opinions: OnceCell<PrimOpinions>,
}

impl VisitedPrim {
    fn new(record: Record) -> Self {
        Self {
            record,
            opinions: OnceCell::new(),
        }
    }

    /// Returns the prim's own inheritable opinions, which are read once.
    pub(super) fn opinions(&self, reader: &Reader) -> &PrimOpinions {
        self.opinions
            .get_or_init(|| PrimOpinions::of(reader, &self.record))
    }
}

impl Deref for VisitedPrim {
    type Target = Record;

    fn deref(&self) -> &Record {
        &self.record
    }
}

/// A visitor of all prims of a traversal.
pub(super) trait Visitor {
    /// The state that a prim passes on to its children.
    type Context;

    /// Visits the prim with the scene path `path`. Returns the state for its children, or `None` to skip them.
    fn prim(
        &mut self,
        walk: &Walk<'_>,
        prim: &VisitedPrim,
        path: &str,
        context: &Self::Context,
    ) -> Outcome<Option<Self::Context>>;
}

/// A depth-first traversal over active, defined and concrete prims, including those inside instances. Prims shared by
/// instances are read once.
pub(super) struct Walk<'a> {
    pub(super) reader: &'a Reader,
    shared: RefCell<HashMap<Path, Rc<VisitedPrim>>>,
}

/// The prims that a traversal visits.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Which {
    /// Defined prims, except classes.
    Defined,
    /// All active prims.
    Active,
    /// The prims of a point instancer's prototype, which may be classes and overrides. They are read once.
    Prototype,
}

impl<'a> Walk<'a> {
    pub(super) fn new(reader: &'a Reader) -> Self {
        Self {
            reader,
            shared: RefCell::default(),
        }
    }

    /// Returns the prim at `path`; shared prims are cached.
    pub(super) fn record(&self, path: &Path, shared: bool) -> Outcome<Rc<VisitedPrim>> {
        if !shared {
            return Ok(Rc::new(VisitedPrim::new(self.reader.record(path.clone())?)));
        }
        if let Some(known) = self.shared.borrow().get(path) {
            return Ok(known.clone());
        }
        let record = Rc::new(VisitedPrim::new(self.reader.record(path.clone())?));
        self.shared.borrow_mut().insert(path.clone(), record.clone());
        Ok(record)
    }

    /// Visits the whole stage.
    pub(super) fn stage<V: Visitor>(
        &self,
        visitor: &mut V,
        context: &V::Context,
        which: Which,
    ) -> Outcome<()> {
        for path in self.reader.roots()? {
            let name = path.as_str().to_owned();
            self.from(visitor, &path, &name, context, which)?;
        }
        Ok(())
    }

    /// Visits the prim composed at `composed`, with the scene path `path`, and its descendants.
    pub(super) fn from<V: Visitor>(
        &self,
        visitor: &mut V,
        composed: &Path,
        path: &str,
        context: &V::Context,
        which: Which,
    ) -> Outcome<()> {
        let shared = which == Which::Prototype || is_in_prototype(composed);
        self.below(visitor, composed, path, context, which, shared, 0)
    }

    #[expect(clippy::too_many_arguments, reason = "the state of the recursion")]
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
        if depth >= MAX_DEPTH {
            return Err(format!("<{path}>: prims nest more than {MAX_DEPTH} deep").into());
        }
        self.reader.budget().visit(path);
        let record = self.record(composed, shared)?;
        let wanted = match which {
            Which::Defined => record.specifier == Specifier::Def,
            Which::Active | Which::Prototype => true,
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

/// Whether a path is inside a prototype, which instances share.
pub(super) fn is_in_prototype(path: &Path) -> bool {
    path.as_str().starts_with("/__Prototype_")
}
