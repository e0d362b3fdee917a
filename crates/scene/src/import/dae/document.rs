use std::collections::HashMap;

use oaktwin_files::xml::{Element, XmlError};

/// A file whose elements are found by their ids.
pub(super) struct Document<'a> {
    pub(super) root: &'a Element,
    /// Never iterated. The first element with an id takes precedence.
    ids: HashMap<&'a str, &'a Element>,
}

impl<'a> Document<'a> {
    pub(super) fn new(root: &'a Element) -> Self {
        let mut ids = HashMap::new();
        let mut stack = vec![root];
        while let Some(element) = stack.pop() {
            if let Some(id) = element.get("id") {
                ids.entry(id).or_insert(element);
            }
            stack.extend(element.children.iter().rev());
        }
        Self { root, ids }
    }

    pub(super) fn find(&self, id: &str) -> Option<&'a Element> {
        self.ids.get(id).copied()
    }

    /// Returns the element of a kind that an attribute refers to.
    pub(super) fn follow(
        &self,
        element: &Element,
        attribute: &str,
        tag: &str,
    ) -> Result<&'a Element, XmlError> {
        let url = element.required(attribute)?;
        let Some(id) = url.strip_prefix('#') else {
            let message = format!("{attribute}: '{url}' is in another file");
            return Err(element.wrong(message, "export the scene to one file"));
        };
        self.find(id).filter(|found| found.tag == tag).ok_or_else(|| {
            let message = format!("{attribute}: there is no <{tag} id=\"{id}\">");
            element.wrong(message, super::super::error::DAMAGED)
        })
    }
}

/// The element's name or id, without the rest of a path.
pub(super) fn name(element: &Element) -> &str {
    let name = element.get("name").filter(|name| !name.is_empty());
    name.or_else(|| element.get("id")).unwrap_or_default()
}
