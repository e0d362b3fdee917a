//! XML as a tree whose elements know their file and line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use quick_xml::events::{BytesStart, Event};
use quick_xml::reader::Reader;

use crate::{FileError, read};

/// The maximum depth of elements.
const MAX_DEPTH: usize = 256;

/// The maximum number of elements, which take up to 200 bytes each.
const MAX_ELEMENTS: usize = 1 << 23;

/// A mistake in a file: `FILE: PLACE: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {place}{}{message}; {remedy}", file.display(), if place.is_empty() { "" } else { ": " })]
pub struct XmlError {
    /// The file.
    pub file: PathBuf,
    /// The line and element; empty if the whole file is concerned.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

impl From<FileError> for XmlError {
    fn from(error: FileError) -> Self {
        Self {
            file: error.path,
            place: String::new(),
            message: error.message.to_string(),
            remedy: error.remedy.to_string(),
        }
    }
}

/// An element of a file.
#[derive(Clone, Debug)]
pub struct Element {
    /// The name of its kind.
    pub tag: String,
    /// The elements in it.
    pub children: Vec<Self>,
    /// The text in it, without the text of its children.
    pub text: String,
    attributes: Vec<(String, String)>,
    file: Arc<Path>,
    line: usize,
}

impl Element {
    /// Reads the root element of a file of at most `limit` bytes. In errors, `what` names the kind of file, such as `a robot`, and `remedy` says
    /// which file to give instead.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or is not XML.
    pub fn open(path: &Path, limit: u64, what: &str, remedy: &str) -> Result<Self, XmlError> {
        Self::parse(&read(path, limit, what)?, path, remedy)
    }

    /// Reads the root element of the contents of a file.
    ///
    /// # Errors
    /// Returns an error if the contents are not XML.
    pub fn parse(bytes: &[u8], file: &Path, remedy: &str) -> Result<Self, XmlError> {
        parse(bytes, &Arc::from(file), remedy)
    }

    /// The place of the element in errors and findings: `line 12: <joint name="a">`.
    #[must_use]
    pub fn place(&self) -> String {
        let name = ["name", "id"]
            .into_iter()
            .find_map(|key| Some((key, self.get(key)?)));
        match name {
            Some((key, name)) => format!("line {}: <{} {key}=\"{name}\">", self.line, self.tag),
            None => format!("line {}: <{}>", self.line, self.tag),
        }
    }

    /// Returns an error about the element.
    pub fn wrong(&self, message: impl Into<String>, remedy: impl Into<String>) -> XmlError {
        XmlError {
            file: self.file.to_path_buf(),
            place: self.place(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    /// The line of its start tag.
    #[must_use]
    pub fn line(&self) -> usize {
        self.line
    }

    /// The file that contains it.
    #[must_use]
    pub fn file(&self) -> &Path {
        &self.file
    }

    /// Returns an attribute without spaces around it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&str> {
        let found = self.attributes.iter().find(|(own, _)| own == name);
        found.map(|(_, value)| value.trim())
    }

    /// Returns an attribute that the element must have.
    ///
    /// # Errors
    /// Returns an error if it is missing.
    pub fn required(&self, name: &str) -> Result<&str, XmlError> {
        self.get(name)
            .ok_or_else(|| self.wrong(format!("the attribute {name} is missing"), format!("add {name}")))
    }

    /// Sets the attributes that the element lacks.
    pub fn complete(&mut self, defaults: &[(String, String)]) {
        for (name, value) in defaults {
            if self.get(name).is_none() {
                self.attributes.push((name.clone(), value.clone()));
            }
        }
    }

    /// A copy of the element alone.
    #[must_use]
    pub fn without_children(&self) -> Self {
        Self {
            children: Vec::new(),
            tag: self.tag.clone(),
            text: self.text.clone(),
            attributes: self.attributes.clone(),
            file: Arc::clone(&self.file),
            line: self.line,
        }
    }

    /// The names and values of its attributes.
    #[must_use]
    pub fn attributes(&self) -> &[(String, String)] {
        &self.attributes
    }

    /// Returns the first child of a kind.
    #[must_use]
    pub fn child(&self, tag: &str) -> Option<&Self> {
        self.all(tag).next()
    }

    /// Returns the children of a kind.
    pub fn all(&self, tag: &str) -> impl Iterator<Item = &Self> {
        self.children.iter().filter(move |child| child.tag == tag)
    }

    /// Reads the numbers of an attribute, separated by spaces.
    ///
    /// # Errors
    /// Returns an error if one is not finite.
    pub fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, XmlError> {
        let text = self.get(name);
        text.map(|text| self.parsed(text, &format!("{name}: ")))
            .transpose()
    }

    /// Reads the numbers of its text, separated by spaces.
    ///
    /// # Errors
    /// Returns an error if one is not finite.
    pub fn text_numbers(&self) -> Result<Vec<f64>, XmlError> {
        self.parsed(&self.text, "")
    }

    fn parsed(&self, text: &str, what: &str) -> Result<Vec<f64>, XmlError> {
        let number = |word: &str| {
            let number = word.parse::<f64>().ok().filter(|number| number.is_finite());
            number.ok_or_else(|| {
                self.wrong(
                    format!("{what}'{}' is not a finite number", shown(word)),
                    "write numbers separated by spaces",
                )
            })
        };
        text.split_ascii_whitespace().map(number).collect()
    }

    /// Reads the `N` numbers of an attribute.
    ///
    /// # Errors
    /// Returns an error if there are more or fewer, or if one is not finite.
    pub fn exactly<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, XmlError> {
        let Some(numbers) = self.numbers(name)? else {
            return Ok(None);
        };
        let count = numbers.len();
        numbers
            .try_into()
            .map(Some)
            .map_err(|_| self.wrong(format!("{name} has {count} numbers"), format!("give {N}")))
    }

    /// Reads the number of an attribute.
    ///
    /// # Errors
    /// Returns an error if there is not exactly one, or if it is not finite.
    pub fn number(&self, name: &str) -> Result<Option<f64>, XmlError> {
        Ok(self.exactly::<1>(name)?.map(|[number]| number))
    }
}

/// The start of a word, for a message.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}

fn parse(bytes: &[u8], file: &Arc<Path>, remedy: &str) -> Result<Element, XmlError> {
    let mut reader = Reader::from_reader(bytes);
    let mut lines = Lines {
        bytes,
        at: 0,
        line: 1,
    };
    let fail = |line: usize, what: String| XmlError {
        file: file.to_path_buf(),
        place: format!("line {line}"),
        message: what,
        remedy: remedy.to_owned(),
    };
    let mut open: Vec<Element> = Vec::new();
    let mut left = MAX_ELEMENTS;
    let mut buffer = Vec::new();
    loop {
        let event = reader.read_event_into(&mut buffer);
        let line = lines.until(reader.buffer_position());
        let mut begin = |start: &BytesStart<'_>| {
            left = left
                .checked_sub(1)
                .ok_or_else(|| fail(line, format!("there are more than {MAX_ELEMENTS} elements")))?;
            element(start, file, line).map_err(|what| fail(line, what))
        };
        let closed = match event.map_err(|error| fail(line, error.to_string()))? {
            Event::Start(start) => {
                if open.len() >= MAX_DEPTH {
                    return Err(fail(line, format!("elements nest more than {MAX_DEPTH} deep")));
                }
                open.push(begin(&start)?);
                None
            }
            Event::Empty(start) => Some(begin(&start)?),
            Event::End(_) => open.pop(),
            Event::Text(text) => {
                add_text(&mut open, &text);
                None
            }
            Event::CData(text) => {
                add_text(&mut open, &text);
                None
            }
            Event::GeneralRef(reference) => {
                let text = format!("&{};", &*reference);
                let text =
                    quick_xml::escape::unescape(&text).map_err(|error| fail(line, error.to_string()))?;
                add_text(&mut open, &text);
                None
            }
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

/// Adds text to the innermost element; indentation is none.
fn add_text(open: &mut [Element], text: &str) {
    if let Some(element) = open.last_mut()
        && !(element.text.is_empty() && text.trim_ascii().is_empty())
    {
        element.text.push_str(text);
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
        text: String::new(),
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
