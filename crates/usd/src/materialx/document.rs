use std::collections::BTreeMap;

use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

use super::MaterialXError;

/// The maximum depth of elements.
const MAX_DEPTH: usize = 64;

/// An element of the document.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Element {
    pub(super) category: String,
    pub(super) attributes: BTreeMap<String, String>,
    pub(super) children: Vec<Self>,
}

impl Element {
    pub(super) fn get(&self, attribute: &str) -> Option<&str> {
        self.attributes.get(attribute).map(String::as_str)
    }

    pub(super) fn name(&self) -> &str {
        self.get("name").unwrap_or_default()
    }

    /// Returns the child called `name`.
    pub(super) fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name() == name)
    }

    /// Returns the `input` children.
    pub(super) fn inputs(&self) -> impl Iterator<Item = &Self> {
        self.children.iter().filter(|child| child.category == "input")
    }

    /// Returns the input called `name`.
    pub(super) fn input(&self, name: &str) -> Option<&Self> {
        self.inputs().find(|input| input.name() == name)
    }
}

/// Reads the document's `materialx` element.
pub(super) fn parse(bytes: &[u8]) -> Result<Element, MaterialXError> {
    let mut reader = Reader::from_reader(bytes);
    let fail = |at: u64, what: String| MaterialXError { offset: at, what };
    let mut open: Vec<Element> = Vec::new();
    let mut buffer = Vec::new();
    loop {
        let at = reader.buffer_position();
        let event = reader
            .read_event_into(&mut buffer)
            .map_err(|error| fail(at, error.to_string()))?;
        let closed = match event {
            Event::Start(start) => {
                if open.len() >= MAX_DEPTH {
                    return Err(fail(at, format!("elements nest more than {MAX_DEPTH} deep")));
                }
                open.push(element(&start).map_err(|what| fail(at, what))?);
                None
            }
            Event::Empty(start) => Some(element(&start).map_err(|what| fail(at, what))?),
            Event::End(_) => open.pop(),
            Event::Eof => return Err(fail(at, "missing `materialx` element".to_owned())),
            _ => None,
        };
        if let Some(closed) = closed {
            match open.last_mut() {
                Some(parent) => parent.children.push(closed),
                None if closed.category == "materialx" => return Ok(closed),
                None => {}
            }
        }
        buffer.clear();
    }
}

fn element(start: &BytesStart<'_>) -> Result<Element, String> {
    let mut attributes = BTreeMap::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| error.to_string())?;
        let value = quick_xml::escape::unescape(&attribute.value).map_err(|error| error.to_string())?;
        attributes.insert(attribute.key.as_ref().to_owned(), value.into_owned());
    }
    Ok(Element {
        category: start.name().as_ref().to_owned(),
        attributes,
        children: Vec::new(),
    })
}
