use std::fmt;

use crate::{About, Platform, Table};

/// A parameter with its default on a platform.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// The description.
    pub about: About,
    /// The default as text.
    pub default: String,
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
        let listing = |row: &'static crate::Row<T>| Listing {
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
}
