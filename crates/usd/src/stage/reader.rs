use std::rc::Rc;

use openusd::sdf::{self, Path, Value};
use openusd::tf::Token;
use openusd::usd;

use super::budget::Budget;
use super::packages::Packages;
use super::value::number;

/// An error of the USD library.
pub(super) type Failure = Box<dyn std::error::Error + Send + Sync>;
pub(super) type Outcome<T> = Result<T, Failure>;

/// Reads composed prims and values of a stage at one time code. Each query visits every layer with an opinion, so a
/// prim's properties are listed once and only existing ones are queried.
pub(super) struct Reader {
    pub(super) stage: usd::Stage,
    /// The time code of values; `None` for default values.
    time: Option<f64>,
    budget: Rc<Budget>,
    packages: Rc<Packages>,
}

/// The data of a prim that the traversal needs.
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
            time,
            budget,
            packages,
        }
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
        let attribute = self.stage.attribute(prim.append_property(name).ok()?);
        let at = |time| attribute.get_at::<Value>(time).ok().flatten();
        let value = match self.time {
            Some(time) => match at(Some(usd::TimeCode::new(time))) {
                Some(Value::Int64(_) | Value::Double(_)) => scalar_at(&attribute, time),
                other => other,
            },
            None => attribute.get::<Value>().ok().flatten().or_else(|| {
                let times = attribute.time_sample_times().ok()?;
                at(Some(usd::TimeCode::new(*times.first()?)))
            }),
        };
        value.filter(|value| !matches!(value, Value::None | Value::ValueBlock))
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

/// Returns a number interpolated between samples. In a text layer's samples the library reads `0` as an integer and
/// `0.5` as a double, whatever the attribute's type, and does not interpolate between the two.
fn scalar_at(attribute: &usd::Attribute, time: f64) -> Option<Value> {
    let at = |time| attribute.get_at::<Value>(usd::TimeCode::new(time)).ok().flatten();
    let kind = attribute.type_name().ok().flatten();
    let is_continuous = kind.is_some_and(|kind| matches!(kind.as_str(), "half" | "float" | "double"));
    let bracket = attribute.bracketing_time_samples(time).ok().flatten();
    let Some((before, after)) = bracket.filter(|(before, after)| is_continuous && before < after) else {
        return at(time);
    };
    let (from, to) = (number(&at(before)?)?, number(&at(after)?)?);
    Some(Value::Double(
        from + (to - from) * (time - before) / (after - before),
    ))
}
