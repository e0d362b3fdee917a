use std::rc::Rc;

use oaktwin_camera::math::DAffine3;
use oaktwin_scene::Label;
use openusd::sdf::Path;

use super::super::binding::Bindings;
use super::super::prim_opinions::{PrimOpinions, Purpose};
use super::super::reader::Record;

/// The state that a prim inherits from its ancestors.
#[derive(Clone)]
pub(in crate::stage) struct Context {
    /// The transform from the prim's frame to the stage's, both in stage units.
    pub(in crate::stage) stage_from_prim: DAffine3,
    /// Whether it is drawn: visible, and not a point instancer's prototype.
    pub(in crate::stage) drawn: bool,
    pub(super) purpose: Purpose,
    /// The semantic labels: the prim's own first, then its parent's, and so on.
    pub(super) labels: Rc<[Label]>,
    pub(super) bindings: Bindings,
    pub(super) primvars: Option<Rc<Primvars>>,
    /// The nearest `SkelRoot` and its transform.
    pub(super) skeleton_root: Option<(Path, DAffine3)>,
    /// The bound skeleton.
    pub(super) skeleton: Option<Path>,
    /// The bound animation.
    pub(super) animation: Option<Path>,
    /// The number of the nearest prim that can move, among those of [`Motion`](crate::stage::motion::Motion).
    pub(in crate::stage) node: Option<usize>,
}

/// A linked list of ancestors with primvars, nearest first.
pub(super) struct Primvars {
    pub(super) prim: Path,
    pub(super) names: Vec<openusd::tf::Token>,
    pub(super) above: Option<Rc<Primvars>>,
}

impl Default for Context {
    fn default() -> Self {
        Self {
            stage_from_prim: DAffine3::IDENTITY,
            drawn: true,
            purpose: Purpose::Default,
            labels: Rc::from([]),
            bindings: Bindings::default(),
            primvars: None,
            skeleton_root: None,
            skeleton: None,
            animation: None,
            node: None,
        }
    }
}

impl Context {
    /// Returns the state of the child at scene path `path` with the opinions `opinions`.
    pub(in crate::stage) fn with(&self, opinions: &PrimOpinions, path: &str) -> Self {
        let mut inner = self.clone();
        if let Some(local) = &opinions.transform {
            inner.stage_from_prim = local.below(self.stage_from_prim);
        }
        inner.drawn &= !opinions.invisible;
        if let Some(purpose) = opinions.purpose {
            inner.purpose = purpose;
        }
        if !opinions.labels.is_empty() {
            let labels = opinions.labels.iter().map(|(taxonomy, name)| Label {
                prim: path.to_owned(),
                taxonomy: taxonomy.clone(),
                name: name.clone(),
            });
            inner.labels = labels.chain(self.labels.iter().cloned()).collect();
        }
        inner.bindings = self.bindings.with(&opinions.bindings);
        if let Some(root) = &opinions.skeleton_root {
            inner.skeleton_root = Some((root.clone(), inner.stage_from_prim));
        }
        if opinions.skeleton.is_some() {
            inner.skeleton.clone_from(&opinions.skeleton);
        }
        if opinions.animation.is_some() {
            inner.animation.clone_from(&opinions.animation);
        }
        inner
    }

    /// Returns the state that the children of `prim` inherit.
    pub(in crate::stage) fn hand_down(mut self, prim: &Record, opinions: &PrimOpinions) -> Self {
        if opinions.has_primvars {
            self.primvars = Some(Rc::new(Primvars {
                prim: prim.path.clone(),
                names: prim
                    .properties
                    .iter()
                    .filter(|name| name.starts_with("primvars:"))
                    .cloned()
                    .collect(),
                above: self.primvars.take(),
            }));
        }
        self
    }

    /// Returns the nearest ancestor with a primvar.
    pub(super) fn ancestor_with(&self, primvar: &str) -> Option<&Path> {
        let mut at = self.primvars.as_deref();
        while let Some(primvars) = at {
            if primvars.names.iter().any(|name| name.as_str() == primvar) {
                return Some(&primvars.prim);
            }
            at = primvars.above.as_deref();
        }
        None
    }

    /// Whether a skeleton is bound to it.
    pub(in crate::stage) fn is_skinned(&self) -> bool {
        self.skeleton.is_some()
    }

    /// Whether its geometry is rendered.
    pub(super) fn is_drawn(&self) -> bool {
        self.drawn && self.purpose != Purpose::Other
    }
}
