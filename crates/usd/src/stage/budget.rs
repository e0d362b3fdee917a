//! Counts what a stage composes and stops at a limit.
//!
//! The USD library composes without a limit, and a few kilobytes of layers can describe more prims than fit in memory. It
//! composes one prim at a time, so the sites of each composed prim are counted after the fact, and two things bound one
//! prim: the resolver, which the library calls for each arc to another layer, counts these; and `stacks` bounds the
//! sites that arcs within a layer lead to, before the layer is composed.

use std::any::Any;
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::panic::resume_unwind;
use std::path::Path;

use oaktwin_base::diagnostic::Message;

use super::inspect::{Clips, Outline};
use super::stacks::{Growth, Links, Stacks};
use super::{SceneLimit, StageError};

/// The sites that every stage may compose, and those for each authored prim.
const SITES: (u64, u64) = (250_000, 16);
/// The layers of one stack (a layer, its sublayers, and theirs) and of a stage: for each layer that the library
/// opens it visits all others.
const LAYERS: (u64, u64) = (2000, 4000);
/// The value clips that a template describes.
const CLIPS: u64 = 100_000;
/// The prims that a traversal of any stage may visit, and those for each authored prim.
const VISITS: (u64, u64) = (1_000_000, 100);
/// The instances that every stage may have, and the bytes of layers for each further one: a point takes 16 bytes.
const INSTANCES: (u64, u64) = (1_000_000, 10);
/// The number of sites of one prim above which the library's time grows with their square.
const SITES_OF_QUADRATIC_TIME: u64 = 200;

/// The depth in the namespace above which the memory of a site grows with its depth.
const DEPTH_OF_SMALL_SITES: u64 = 8;

/// The counts of one stage.
#[derive(Debug, Default)]
pub(super) struct Budget {
    limit: SceneLimit,
    authored_prims: Cell<u64>,
    authored_bytes: Cell<u64>,
    sites: Cell<u64>,
    visits: Cell<u64>,
    instances: Cell<u64>,
    /// The arcs to other layers that the prim being composed has followed.
    followed: Cell<u64>,
    layers: Cell<u64>,
    /// Whether a prim may have arcs.
    has_arcs: Cell<bool>,
    clips: Cell<Clips>,
    is_animated: Cell<bool>,
    has_clips: Cell<bool>,
    stacks: RefCell<Stacks>,
    /// The prim being composed; empty before the first.
    place: RefCell<String>,
}

/// The payload with which the reading thread unwinds at a limit, or at what the library cannot compose.
#[derive(Debug)]
struct Exceeded {
    place: String,
    what: String,
    remedy: Message,
}

/// Returns the error of a limit if a thread unwound with one.
pub(super) fn exceeded(file: &str, payload: &(dyn Any + Send)) -> Option<StageError> {
    let exceeded = payload.downcast_ref::<Exceeded>()?;
    Some(StageError::new(
        file,
        &exceeded.place,
        &exceeded.what,
        exceeded.remedy.clone(),
    ))
}

/// Returns the name of a layer without its folder.
fn file_name(layer: &str) -> Cow<'_, str> {
    Path::new(layer).file_name().unwrap_or_default().to_string_lossy()
}

impl Budget {
    pub(super) fn new(limit: SceneLimit) -> Self {
        Self {
            limit,
            ..Self::default()
        }
    }

    /// Whether attributes of the layers so far may have time samples, splines or value clips.
    pub(super) fn is_animated(&self) -> bool {
        self.is_animated.get() || self.has_clips.get()
    }

    /// Whether prims of the layers so far may have value clips.
    pub(super) fn has_clips(&self) -> bool {
        self.has_clips.get()
    }

    /// Adds the layer `name` before the library reads it. `resolve` returns the name of the layer at an asset path.
    pub(super) fn layer(
        &self,
        name: &str,
        outline: &Outline,
        bytes: usize,
        resolve: impl Fn(&str) -> Option<String>,
    ) {
        self.authored_prims.set(self.authored_prims.get() + outline.prims);
        self.authored_bytes
            .set(self.authored_bytes.get() + u64::try_from(bytes).unwrap_or(u64::MAX));
        let clips = self.clips.get().with(outline.clips);
        self.clips.set(clips);
        let allowed = self.limit.times(CLIPS);
        if clips.count() > allowed {
            self.exceed(
                &file_name(name),
                "its templates describe value clips",
                allowed,
                "clips",
            );
        }
        let layers = self.layers.get() + 1;
        self.layers.set(layers);
        let allowed = self.limit.times(LAYERS.1);
        if layers > allowed {
            self.exceed(
                &file_name(name),
                "up to this one, layers multiply",
                allowed,
                "layers",
            );
        }
        self.has_arcs.set(self.has_arcs.get() || !outline.arcs.is_empty());
        self.is_animated
            .set(self.is_animated.get() || outline.is_animated);
        self.has_clips.set(self.has_clips.get() || outline.has_clips);
        let references = outline.references.iter().filter_map(|reference| {
            let target = reference.target.as_deref();
            Some((reference.prim.as_str(), resolve(&reference.asset)?, target))
        });
        let links = Links {
            sublayers: outline
                .sublayers
                .iter()
                .filter_map(|path| resolve(path))
                .collect(),
            arcs: &outline.arcs,
            references: references.collect(),
            default_prim: outline.default_prim.as_deref(),
        };
        for growth in self.stacks.borrow_mut().add(name, links) {
            match growth {
                Growth::Layers { layer, count } if count > self.limit.times(LAYERS.0) => {
                    let allowed = self.limit.times(LAYERS.0);
                    self.exceed(&file_name(&layer), "its sublayers multiply", allowed, "layers");
                }
                Growth::Sites { prim, count } if cost(count) > self.sites_left() => {
                    let what = "its references, inherits, specializes and variants multiply";
                    self.exceed(&prim, what, self.allowed_sites(), "sites");
                }
                Growth::Cycle { prim } => stop(Exceeded {
                    place: prim,
                    what: "inherits from or specializes itself, directly or through others".to_owned(),
                    remedy: "remove one of these arcs; OpenUSD ignores the last".into(),
                }),
                _ => {}
            }
        }
    }

    /// Counts an arc to another layer, authored in the layer `anchor`.
    pub(super) fn arc(&self, anchor: Option<&Path>) {
        let followed = self.followed.get() + 1;
        self.followed.set(followed);
        let place = self.place.borrow();
        self.has_arcs.set(self.has_arcs.get() || !place.is_empty());
        // Before the first prim, the arcs are those to sublayers, which are in one site.
        let (sites, place) = if place.is_empty() {
            let layer = anchor.and_then(Path::file_name).unwrap_or_default();
            (followed, layer.to_string_lossy())
        } else {
            (cost(self.stacks.borrow().sites(followed)), place.as_str().into())
        };
        if sites > self.sites_left() {
            let what = "its sublayers, references and payloads multiply";
            self.exceed(&place, what, self.allowed_sites(), "sites");
        }
    }

    /// Starts composing a prim.
    pub(super) fn start(&self, prim: &str) {
        self.followed.set(0);
        let mut place = self.place.borrow_mut();
        place.clear();
        place.push_str(prim);
    }

    /// Whether prims may have more than one site.
    pub(super) fn has_arcs(&self) -> bool {
        self.has_arcs.get()
    }

    /// Counts the prims composed since [`Budget::start`], each of `sites` sites. A site deep in the namespace takes more
    /// memory than one at its root.
    pub(super) fn composed(&self, prims: usize, sites: usize) {
        let wide = |count: usize| u64::try_from(count).unwrap_or(u64::MAX);
        let depth = self.place.borrow().split('/').count();
        let added = wide(prims)
            .saturating_mul(cost(wide(sites)))
            .saturating_mul(wide(depth) + DEPTH_OF_SMALL_SITES)
            .div_ceil(2 * DEPTH_OF_SMALL_SITES);
        let sites = self.sites.get().saturating_add(added);
        self.sites.set(sites);
        if sites > self.allowed_sites() {
            let what = "up to this prim, references and other arcs multiply the prims";
            let place = self.place.borrow().clone();
            self.exceed(&place, what, self.allowed_sites(), "sites");
        }
    }

    /// Counts the visits and instances of another pass over the same stage from 0.
    pub(super) fn restart(&self) {
        self.visits.set(0);
        self.instances.set(0);
    }

    /// Counts a visit of the prim at the scene path `path`.
    pub(super) fn visit(&self, path: &str) {
        let visits = self.visits.get() + 1;
        self.visits.set(visits);
        let allowed = self.allowed(VISITS.0, self.authored_prims.get().saturating_mul(VISITS.1));
        if visits > allowed {
            self.exceed(
                path,
                "up to this prim, instances multiply the prims",
                allowed,
                "prims",
            );
        }
    }

    /// Counts an instance at the scene path `path`.
    pub(super) fn instance(&self, path: &str) {
        let instances = self.instances.get() + 1;
        self.instances.set(instances);
        let allowed = self.allowed(INSTANCES.0, self.authored_bytes.get() / INSTANCES.1);
        if instances > allowed {
            self.exceed(path, "up to this one, instances multiply", allowed, "instances");
        }
    }

    fn allowed(&self, base: u64, authored: u64) -> u64 {
        self.limit.times(base.saturating_add(authored))
    }

    fn allowed_sites(&self) -> u64 {
        self.allowed(SITES.0, self.authored_prims.get().saturating_mul(SITES.1))
    }

    fn sites_left(&self) -> u64 {
        self.allowed_sites().saturating_sub(self.sites.get())
    }

    fn exceed(&self, place: &str, what: &str, allowed: u64, of: &str) -> ! {
        stop(Exceeded {
            place: place.to_owned(),
            what: format!("{what} beyond the limit of {allowed} {of}"),
            remedy: self.limit.remedy(),
        })
    }
}

/// Unwinds to [`super::guard`]: the library has no other way to stop.
fn stop(exceeded: Exceeded) -> ! {
    resume_unwind(Box::new(exceeded))
}

/// Returns the cost of composing a prim of `sites` sites, in sites of a simple prim.
fn cost(sites: u64) -> u64 {
    sites.saturating_add(sites.saturating_mul(sites) / SITES_OF_QUADRATIC_TIME)
}
