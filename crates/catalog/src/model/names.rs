//! The names of a device.

use oaktwin_base::diagnostic::{Finding, Level, fold_name};

use super::Device;

impl Device {
    /// Returns a note if a name belongs to a model that is not in the catalog and that this device represents, as the D435i does the D435.
    #[must_use]
    pub fn stand_in(&self, name: &str) -> Option<Finding> {
        let mut others = self.stands_in_for.iter();
        let (other, difference) = others.find(|(other, _)| fold_name(other) == fold_name(name))?;
        Some(Finding::new(
            "stand-in",
            Level::Warning,
            other.clone(),
            format!(
                "the catalog has the {} instead; the {other} {difference}",
                self.name
            ),
            "",
        ))
    }

    /// Returns all names of the device: its id, its name, its aliases, and the names of the models that it represents.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.named_places().map(|(name, _)| name)
    }

    pub(crate) fn names_and_prim(&self) -> impl Iterator<Item = &str> {
        self.names().chain([self.prim.as_str()])
    }

    /// Returns all names with the keys that define them.
    pub(crate) fn named_places(&self) -> impl Iterator<Item = (&str, String)> {
        let own = [("id", &self.id), ("name", &self.name)];
        let own = own.into_iter().map(|(key, name)| (name.as_str(), key.to_owned()));
        let aliases = self.aliases.iter().enumerate();
        let others = self.stands_in_for.keys();
        own.chain(aliases.map(|(i, name)| (name.as_str(), format!("aliases.{i}"))))
            .chain(others.map(|name| (name.as_str(), format!("stands_in_for.{name}"))))
    }
}
