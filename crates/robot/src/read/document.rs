//! XML as a tree whose elements know their file and line.

use std::path::Path;
use std::sync::Arc;

use oaktwin_camera::math::DVec3;
use oaktwin_files as files;
use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

use super::RobotFileError;

/// The maximum depth of elements.
const MAX_DEPTH: usize = 256;

/// The maximum size of a file in bytes; meshes are in files of their own.
const MAX_BYTES: u64 = 16 << 20;

/// An element of a file.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) tag: String,
    attributes: Vec<(String, String)>,
    pub(super) children: Vec<Self>,
    file: Arc<Path>,
    line: usize,
}

impl Element {
    /// Reads the outermost element of a file.
    pub(super) fn open(path: &Path) -> Result<Self, RobotFileError> {
        parse(&files::read(path, MAX_BYTES, "a robot")?, &Arc::from(path))
    }

    /// The place of the element in errors and findings: `line 12: <joint name="a">`.
    pub(super) fn place(&self) -> String {
        match self.get("name") {
            Some(name) => format!("line {}: <{} name=\"{name}\">", self.line, self.tag),
            None => format!("line {}: <{}>", self.line, self.tag),
        }
    }

    /// Returns an error about the element.
    pub(super) fn wrong(&self, message: impl Into<String>, remedy: impl Into<String>) -> RobotFileError {
        RobotFileError::new(&self.file, self.place(), message.into(), remedy.into())
    }

    pub(super) fn line(&self) -> usize {
        self.line
    }

    pub(super) fn file(&self) -> &Path {
        &self.file
    }

    pub(super) fn get(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(own, _)| own == name);
        found.map(|(_, value)| value.trim())
    }

    /// Returns an attribute that the element must have.
    pub(super) fn required(&self, name: &str) -> Result<&str, RobotFileError> {
        self.get(name)
            .ok_or_else(|| self.wrong(format!("the attribute {name} is missing"), format!("add {name}")))
    }

    /// Sets the attributes that the element lacks.
    pub(super) fn complete(&mut self, defaults: &[(String, String)]) {
        for (name, value) in defaults {
            if self.get(name).is_none() {
                self.attributes.push((name.clone(), value.clone()));
            }
        }
    }

    /// A copy of the element alone.
    pub(super) fn without_children(&self) -> Self {
        Self {
            children: Vec::new(),
            tag: self.tag.clone(),
            attributes: self.attributes.clone(),
            file: Arc::clone(&self.file),
            line: self.line,
        }
    }

    pub(super) fn attributes(&self) -> &[(String, String)] {
        &self.attributes
    }

    pub(super) fn child(&self, tag: &str) -> Option<&Self> {
        self.all(tag).next()
    }

    pub(super) fn all(&self, tag: &str) -> impl Iterator<Item = &Self> {
        self.children.iter().filter(move |child| child.tag == tag)
    }

    /// Reads the numbers of an attribute, separated by spaces.
    pub(super) fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, RobotFileError> {
        let Some(text) = self.get(name) else {
            return Ok(None);
        };
        let number = |word: &str| {
            let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
            number.ok_or_else(|| {
                self.wrong(
                    format!("{name}: '{word}' is not a finite number"),
                    "write numbers separated by spaces",
                )
            })
        };
        text.split_ascii_whitespace()
            .map(number)
            .collect::<Result<_, _>>()
            .map(Some)
    }

    /// Reads the `N` numbers of an attribute.
    pub(super) fn exactly<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, RobotFileError> {
        let Some(numbers) = self.numbers(name)? else {
            return Ok(None);
        };
        let count = numbers.len();
        numbers
            .try_into()
            .map(Some)
            .map_err(|_| self.wrong(format!("{name} has {count} numbers"), format!("give {N}")))
    }

    pub(super) fn number(&self, name: &str) -> Result<Option<f64>, RobotFileError> {
        Ok(self.exactly::<1>(name)?.map(|[number]| number))
    }

    pub(super) fn vector(&self, name: &str) -> Result<Option<DVec3>, RobotFileError> {
        Ok(self.exactly::<3>(name)?.map(DVec3::from))
    }
}

fn parse(bytes: &[u8], file: &Arc<Path>) -> Result<Element, RobotFileError> {
    let mut reader = Reader::from_reader(bytes);
    let mut lines = Lines {
        bytes,
        at: 0,
        line: 1,
    };
    let fail = |line: usize, what: String| {
        let remedy = "give a complete URDF or MJCF file";
        RobotFileError::new(file, format!("line {line}"), what, remedy.to_owned())
    };
    let mut open: Vec<Element> = Vec::new();
    let mut buffer = Vec::new();
    loop {
        let event = reader.read_event_into(&mut buffer);
        let line = lines.until(reader.buffer_position());
        let closed = match event.map_err(|error| fail(line, error.to_string()))? {
            Event::Start(start) => {
                if open.len() >= MAX_DEPTH {
                    return Err(fail(line, format!("elements nest more than {MAX_DEPTH} deep")));
                }
                open.push(element(&start, file, line).map_err(|what| fail(line, what))?);
                None
            }
            Event::Empty(start) => Some(element(&start, file, line).map_err(|what| fail(line, what))?),
            Event::End(_) => open.pop(),
            Event::Eof => {
                let what = open.last().map_or_else(
                    || "there is no element".to_owned(),
                    |element| format!("<{}> of line {} is not closed", element.tag, element.line),
                );
                return Err(fail(line, what));
            }
            _ => None,
        };
        if let Some(closed) = closed {
            match open.last_mut() {
                Some(parent) => parent.children.push(closed),
                None => return Ok(closed),
            }
        }
        buffer.clear();
    }
}

fn element(start: &BytesStart<'_>, file: &Arc<Path>, line: usize) -> Result<Element, String> {
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| error.to_string())?;
        let value = quick_xml::escape::unescape(&attribute.value).map_err(|error| error.to_string())?;
        attributes.push((attribute.key.as_ref().to_owned(), value.into_owned()));
    }
    Ok(Element {
        tag: start.name().as_ref().to_owned(),
        attributes,
        children: Vec::new(),
        file: Arc::clone(file),
        line,
    })
}

/// Counts lines.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl Lines<'_> {
    /// Returns the line of a position, which is not before the last one.
    fn until(&mut self, position: u64) -> usize {
        let end = usize::try_from(position)
            .unwrap_or(usize::MAX)
            .min(self.bytes.len());
        let passed = self.bytes.get(self.at..end).unwrap_or_default();
        self.line += passed.iter().filter(|byte| **byte == b'\n').count();
        self.at = end;
        self.line
    }
}
