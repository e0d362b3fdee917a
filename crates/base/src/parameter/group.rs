use std::fmt;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::parameter::{About, Kind, Platform, Table};

/// A parameter with its default on a platform.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The table that the parameter belongs to, [`Table::GROUP`].
    pub table: &'static str,
    /// The description.
    pub about: About,
    /// The default as text.
    pub default: String,
}

/// The heading above the parameters that people change first.
pub const COMMON: &str = "changed first";

impl Listing {
    /// The heading under which front ends list the parameter: its table, or [`COMMON`].
    #[must_use]
    pub fn heading(&self) -> &'static str {
        match self.about.common {
            0 => self.table,
            _ => COMMON,
        }
    }
}

/// The parameter as JSON: what `oaktwin params --json` prints and Python returns.
impl Serialize for Listing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let about = &self.about;
        let finite = |limit: f64| (limit.abs() < f64::MAX).then_some(limit);
        let min = if about.min == f64::MIN_POSITIVE {
            0.0
        } else {
            about.min
        };
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("name", about.name)?;
        map.serialize_entry("table", self.table)?;
        map.serialize_entry("type", about.kind.name())?;
        map.serialize_entry("default", &self.default)?;
        map.serialize_entry("unit", &(!about.unit.is_empty()).then_some(about.unit))?;
        map.serialize_entry("min", &finite(min))?;
        map.serialize_entry("max", &finite(about.max))?;
        if let Kind::Choice(names) = about.kind {
            map.serialize_entry("values", names)?;
        }
        map.serialize_entry("platform", &about.platform.map(Platform::title))?;
        map.serialize_entry("source", &about.source)?;
        map.serialize_entry("description", about.doc)?;
        map.end()
    }
}

/// A group of parameters that can be listed without knowledge of their type.
#[derive(Clone, Copy)]
pub struct Group {
    /// The name: `stereo-noise`.
    pub name: &'static str,
    /// One line about the group.
    pub about: &'static str,
    tables: &'static [fn(Platform) -> Vec<Listing>],
}

impl fmt::Debug for Group {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Group").field(&self.name).finish()
    }
}

impl Group {
    /// Returns a group of the parameters that [`Group::list_of`] lists.
    #[must_use]
    pub const fn new(
        name: &'static str,
        about: &'static str,
        tables: &'static [fn(Platform) -> Vec<Listing>],
    ) -> Self {
        Self { name, about, tables }
    }

    /// The parameters of a table with their defaults on a platform.
    #[must_use]
    pub fn list_of<T: Table>(platform: Platform) -> Vec<Listing> {
        let defaults = T::defaults(platform);
        let listing = |row: &'static super::ParameterRow<T>| Listing {
            table: T::GROUP,
            about: row.about,
            default: (row.get)(&defaults),
        };
        T::rows().map(listing).collect()
    }

    /// The parameters of the group with their defaults on a platform.
    #[must_use]
    pub fn list(&self, platform: Platform) -> Vec<Listing> {
        self.tables.iter().flat_map(|list| list(platform)).collect()
    }

    /// The same, after the parameters that people change first.
    #[must_use]
    pub fn list_common_first(&self, platform: Platform) -> Vec<Listing> {
        let (mut list, others): (Vec<Listing>, Vec<Listing>) =
            (self.list(platform).into_iter()).partition(|row| row.about.common > 0);
        list.sort_by_key(|row| row.about.common);
        list.extend(others);
        list
    }
}
