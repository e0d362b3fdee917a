//! Classes of defaults.

use std::collections::HashMap;

use oaktwin_base::diagnostic::suggest;

use super::super::document::{Element, XmlError};

type Attributes = Vec<(String, String)>;

/// The class of elements that name none.
const MAIN: &str = "main";

/// For each class, the default attributes of each tag, including the ones that it inherits from the enclosing classes.
#[derive(Debug, Default)]
pub(super) struct Classes(HashMap<String, HashMap<String, Attributes>>);

impl Classes {
    pub(super) fn new(root: &Element) -> Result<Self, XmlError> {
        let mut classes = Self::default();
        classes.0.insert(MAIN.to_owned(), HashMap::new());
        for default in root.all("default") {
            classes.add(default, MAIN, MAIN)?;
        }
        Ok(classes)
    }

    /// Adds a class within another one, and the classes within it.
    fn add(&mut self, default: &Element, parent: &str, unnamed: &str) -> Result<(), XmlError> {
        let name = default.get("class").unwrap_or(unnamed);
        if name.is_empty() {
            return Err(default.wrong("has no class", "add class=\"…\""));
        }
        let mut own = self.0.get(parent).cloned().unwrap_or_default();
        if let Some(known) = self.0.get(name) {
            own.clone_from(known);
        }
        for child in default.children.iter().filter(|child| child.tag != "default") {
            let known = own.remove(&child.tag).unwrap_or_default();
            let mut merged = known;
            merged.retain(|(name, _)| child.get(name).is_none());
            merged.extend_from_slice(child.attributes());
            own.insert(child.tag.clone(), merged);
        }
        self.0.insert(name.to_owned(), own);
        for inner in default.all("default") {
            self.add(inner, name, "")?;
        }
        Ok(())
    }

    /// Returns an element with the attributes that its class, or the one around it, gives it.
    pub(super) fn complete(&self, element: &Element, around: Option<&str>) -> Result<Element, XmlError> {
        let name = element.get("class").or(around).unwrap_or(MAIN);
        let Some(class) = self.0.get(name) else {
            let mut known: Vec<&str> = self.0.keys().map(String::as_str).collect();
            known.sort_unstable();
            return Err(element.wrong(format!("there is no class '{name}'"), suggest(name, known)));
        };
        let mut complete = element.without_children();
        if let Some(defaults) = class.get(&element.tag) {
            complete.complete(defaults);
        }
        Ok(complete)
    }
}
