use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::rc::Rc;

use oaktwin_base::diagnostic::{Finding, Level, opt};
use oaktwin_base::message;
use openusd::sdf::{self, Path, Value};
use openusd::tf::Token;
use openusd::usd;

use super::budget::Budget;
use super::opinion::{self, OpinionKind};
use super::packages::Packages;

/// An error of the USD library.
pub(super) type Failure = Box<dyn std::error::Error + Send + Sync>;
pub(super) type Outcome<T> = Result<T, Failure>;

/// Reads composed prims and values of a stage at one time code. Each query visits every layer with an opinion, so a
/// prim's properties are listed once and only existing ones are queried.
pub(super) struct Reader {
    pub(super) stage: usd::Stage,
    /// The time code of values; `None` for default values.
    time: Cell<Option<f64>>,
    budget: Rc<Budget>,
    packages: Rc<Packages>,
    /// The attributes whose animation is a spline.
    splines: RefCell<BTreeSet<String>>,
}

/// The data of a prim that the traversal needs.
#[derive(Clone)]
pub(super) struct Record {
    /// The path at which it is composed; inside a prototype for prims shared by instances.
    pub(super) path: Path,
    /// The type; empty if it has none.
    pub(super) type_name: Token,
    /// The names of the authored properties.
    pub(super) properties: Vec<Token>,
    /// The names of the children; for an instance, its prototype's.
    pub(super) children: Vec<Token>,
    /// The prototype with the children of an instance.
    pub(super) prototype: Option<Path>,
    /// Whether the prim is active.
    pub(super) active: bool,
    /// The specifier: `def`, `over` or `class`.
    pub(super) specifier: sdf::Specifier,
}

impl Record {
    /// Whether a property is authored in any layer.
    pub(super) fn has(&self, property: &str) -> bool {
        self.properties.iter().any(|name| name.as_str() == property)
    }

    /// Returns the names and paths of the children.
    pub(super) fn child_paths(&self) -> impl Iterator<Item = (&Token, Path)> {
        let parent = self.prototype.as_ref().unwrap_or(&self.path);
        self.children
            .iter()
            .filter_map(|name| Some((name, child_path(parent, name.as_str())?)))
    }
}

/// Returns the path of a prim's child.
pub(super) fn child_path(parent: &Path, name: &str) -> Option<Path> {
    if parent.is_abs_root() {
        return Path::new(&format!("/{name}")).ok();
    }
    Path::new(&format!("{}/{name}", parent.as_str())).ok()
}

impl Reader {
    pub(super) fn new(
        stage: usd::Stage,
        time: Option<f64>,
        budget: Rc<Budget>,
        packages: Rc<Packages>,
    ) -> Self {
        Self {
            stage,
            time: Cell::new(time),
            budget,
            packages,
            splines: RefCell::default(),
        }
    }

    /// Reads at another time code from now on, in a pass of its own.
    pub(super) fn restart(&self, time: Option<f64>) {
        self.time.set(time);
        self.budget.restart();
    }

    /// Whether the value of an attribute changes with time.
    pub(super) fn is_sampled(&self, prim: &Path, name: &str) -> bool {
        self.budget.is_animated()
            && prim.append_property(name).is_ok_and(|path| {
                let attribute = self.stage.attribute(path);
                // Exporters often author a single sample.
                let is_constant = || attribute.time_sample_times().is_ok_and(|times| times.len() == 1);
                self.strongest(&attribute) == Some(OpinionKind::Samples)
                    && (self.budget.has_clips() || !is_constant())
            })
    }

    /// Returns the packages of the stage's files.
    pub(super) fn packages(&self) -> &Packages {
        &self.packages
    }

    /// Returns the counts of the stage.
    pub(super) fn budget(&self) -> &Budget {
        &self.budget
    }

    /// Returns the root prims.
    pub(super) fn roots(&self) -> Outcome<Vec<Path>> {
        let root = Path::abs_root();
        let names = self.stage.root_prims()?;
        Ok(names
            .iter()
            .filter_map(|name| child_path(&root, name.as_str()))
            .collect())
    }

    /// Returns a metadata field of a prim or a property.
    pub(super) fn field(&self, path: &Path, name: &str) -> Option<Value> {
        // The library's general accessor is private, but its accessor for attributes accepts prim paths.
        self.stage
            .attribute(path.clone())
            .get_metadata::<Value>(name)
            .ok()
            .flatten()
    }

    /// Composes the prim at `path`.
    pub(super) fn record(&self, path: Path) -> Outcome<Record> {
        self.budget.start(path.as_str());
        let before = self.stage.indexed_count();
        let record = self.composed(path)?;
        let composed = self.stage.indexed_count().saturating_sub(before);
        if composed > 0 {
            // Counting the sites copies the prim's index.
            let sites = if self.budget.has_arcs() {
                let index = self.stage.prim_index(record.path.clone());
                index.graph()?.all_nodes().count()
            } else {
                1
            };
            self.budget.composed(composed, sites);
        }
        Ok(record)
    }

    fn composed(&self, path: Path) -> Outcome<Record> {
        let prim = self.stage.prim(path);
        let path = prim.path().clone();
        let active = !matches!(self.field(&path, "active"), Some(Value::Bool(false)));
        let specifier = prim.specifier()?.unwrap_or(sdf::Specifier::Over);
        if !active {
            return Ok(Record {
                path,
                type_name: Token::default(),
                properties: Vec::new(),
                children: Vec::new(),
                prototype: None,
                active,
                specifier,
            });
        }
        let instanceable = matches!(self.field(&path, "instanceable"), Some(Value::Bool(true)));
        let prototype = if instanceable { prim.prototype()? } else { None };
        let children = match &prototype {
            Some(prototype) => self.stage.prim(prototype.clone()).child_names()?,
            None => prim.child_names()?,
        };
        Ok(Record {
            type_name: prim.type_name()?.unwrap_or_default(),
            properties: prim.property_names()?,
            children,
            prototype,
            active,
            specifier,
            path,
        })
    }

    /// Returns an attribute's value at the reader's time code; without one, the default value or else the first time
    /// sample. OpenUSD itself ignores samples at the default time, which would leave purely animated prims at the origin.
    pub(super) fn value(&self, record: &Record, name: &str) -> Option<Value> {
        if !record.has(name) {
            return None;
        }
        self.attribute_value(&record.path, name)
    }

    /// Like [`Reader::value`], for attributes that may not exist.
    pub(super) fn attribute_value(&self, prim: &Path, name: &str) -> Option<Value> {
        self.resolved(&self.stage.attribute(prim.append_property(name).ok()?))
    }

    /// Like [`Reader::value`], for an attribute.
    pub(super) fn resolved(&self, attribute: &usd::Attribute) -> Option<Value> {
        let default = || attribute.get::<Value>().ok().flatten();
        let at = |time: f64| attribute.get_at::<Value>(usd::TimeCode::new(time)).ok().flatten();
        let value = if !self.budget.is_animated() {
            default().or_else(|| self.strongest(attribute).and(None))
        } else if let Some(time) = self.time.get() {
            match self.strongest(attribute)? {
                OpinionKind::Default | OpinionKind::Spline => default(),
                OpinionKind::Samples => at(time),
            }
        } else {
            default().or_else(|| match self.strongest(attribute)? {
                OpinionKind::Default | OpinionKind::Spline => None,
                OpinionKind::Samples => at(*attribute.time_sample_times().ok()?.first()?),
            })
        };
        value.filter(|value| !matches!(value, Value::None | Value::ValueBlock))
    }

    /// Like [`Reader::value`], but without a time code only the default value.
    pub(super) fn posed(&self, record: &Record, name: &str) -> Option<Value> {
        if self.time.get().is_some() {
            return self.value(record, name);
        }
        let attribute = self.stage.attribute(record.path.append_property(name).ok()?);
        attribute.get::<Value>().ok().flatten()
    }

    /// Returns the kind of the strongest opinion on an attribute, and notes splines.
    fn strongest(&self, attribute: &usd::Attribute) -> Option<OpinionKind> {
        let source = opinion::strongest(&self.stage, attribute, self.budget.has_clips());
        if source == Some(OpinionKind::Spline) {
            self.splines.borrow_mut().insert(attribute.path().to_string());
        }
        source
    }

    /// Returns what the values that were read do not show.
    pub(super) fn findings(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        if self.time.get().is_none() && self.budget.is_animated() {
            let range = if self.stage.has_authored_time_code_range() {
                let (start, end) = (self.stage.start_time_code(), self.stage.end_time_code());
                format!(", from {start} to {end}")
            } else {
                String::new()
            };
            findings.push(Finding::new(
                "time",
                Level::Note,
                "stage",
                format!("is animated{range}; default values are read, or the first time samples where there are none"),
                message!["give the time code to read with ", opt("time")],
            ));
        }
        for path in self.splines.borrow().iter() {
            findings.push(Finding::new(
                "spline",
                Level::Warning,
                path,
                "its animation is a spline, which is not read; its default value is used",
                "bake it into time samples",
            ));
        }
        findings
    }

    /// Returns the targets of a relationship, in the prim's own namespace.
    pub(super) fn targets(&self, record: &Record, name: &str) -> Vec<Path> {
        if !record.has(name) {
            return Vec::new();
        }
        let Ok(path) = record.path.append_property(name) else {
            return Vec::new();
        };
        self.stage
            .relationship(path)
            .forwarded_targets()
            .unwrap_or_default()
    }
}
