//! The names of a device.

use oaktwin_base::diagnostic::{Finding, Level, fold_name};

use super::Device;

impl Device {
    /// Reports a name that is another model's, for which this one stands in.
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

    /// Returns all names of the device: id, name, aliases, and the models for which it stands in.
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
