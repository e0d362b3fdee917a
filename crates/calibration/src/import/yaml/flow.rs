//! Flow collections: `[1, 2]` and `{rows: 3}`, also over several lines.

use super::Problem;
use super::scalar::{scalar, without_tag};
use crate::raw::{MAX_DEPTH, Node, Position, Value};

pub(super) struct Flow<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Flow<'a> {
    /// Starts at the first character of a text that begins on a line.
    pub(super) const fn new(text: &'a str, line: usize) -> Self {
        Self { rest: text, line }
    }

    /// Parses the whole text.
    pub(super) fn whole(mut self, depth: usize) -> Result<Node, Problem> {
        let node = self.node(depth)?;
        self.blanks();
        match self.rest.chars().next() {
            None => Ok(node),
            Some(c) => Err(Problem::new(
                self.line,
                format!("unexpected \"{c}\" after the value"),
            )),
        }
    }

    fn node(&mut self, depth: usize) -> Result<Node, Problem> {
        if depth > MAX_DEPTH {
            return Err(Problem::too_deep(self.line));
        }
        self.blanks();
        self.rest = without_tag(self.rest);
        let at = Position {
            line: self.line,
            column: 0,
        };
        let value = if self.takes('[') {
            Value::Array(self.items(']', |flow| flow.node(depth + 1))?)
        } else if self.takes('{') {
            Value::Object(self.items('}', |flow| flow.entry(depth + 1))?)
        } else {
            self.scalar()?
        };
        Ok(Node { value, at })
    }

    fn items<T>(
        &mut self,
        close: char,
        item: impl Fn(&mut Self) -> Result<T, Problem>,
    ) -> Result<Vec<T>, Problem> {
        let mut items = Vec::new();
        loop {
            self.blanks();
            if self.takes(close) {
                return Ok(items);
            }
            items.push(item(self)?);
            self.blanks();
            if !self.takes(',') && !self.rest.starts_with(close) {
                return Err(Problem::new(
                    self.line,
                    format!("a \",\" or \"{close}\" is missing"),
                ));
            }
        }
    }

    fn entry(&mut self, depth: usize) -> Result<(String, Node), Problem> {
        let key = match self.scalar()? {
            Value::String(text) | Value::Number(text) => text,
            other => return Err(Problem::new(self.line, format!("the key is {}", other.kind()))),
        };
        self.blanks();
        if !self.takes(':') {
            return Err(Problem::new(
                self.line,
                format!("a \":\" is missing after \"{key}\""),
            ));
        }
        Ok((key, self.node(depth)?))
    }

    fn scalar(&mut self) -> Result<Value, Problem> {
        let quote = self.rest.chars().next().filter(|c| ['"', '\''].contains(c));
        let end = match quote {
            Some(quote) => closing(self.rest, quote),
            None => self.rest.find([',', ']', '}', ':', '\n', '[', '{']),
        };
        let (text, rest) = self
            .rest
            .split_at_checked(end.unwrap_or(self.rest.len()))
            .unwrap_or((self.rest, ""));
        let value = scalar(text.trim_end());
        let is_missing = text.trim().is_empty();
        self.rest = rest;
        value
            .filter(|_| !is_missing)
            .ok_or_else(|| Problem::new(self.line, "a value is missing or a quote is not closed"))
    }

    fn takes(&mut self, c: char) -> bool {
        let rest = self.rest.strip_prefix(c);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn blanks(&mut self) {
        let rest = self.rest.trim_start();
        let skipped = self.rest.len() - rest.len();
        let blank = self.rest.get(..skipped).unwrap_or_default();
        self.line += blank.matches('\n').count();
        self.rest = rest;
    }
}

/// Returns the index after the closing quote of a text that begins with a quote.
fn closing(text: &str, quote: char) -> Option<usize> {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        if c == quote && !is_escaped {
            return Some(at + c.len_utf8());
        }
        is_escaped = quote == '"' && c == '\\' && !is_escaped;
    }
    None
}

/// Returns how many brackets of a line stay open, outside of quotes.
pub(super) fn open_brackets(text: &str) -> isize {
    let (mut open, mut rest) = (0, text);
    while let Some(at) = rest.find(['[', '{', ']', '}', '"', '\'']) {
        let found = rest.get(at..).unwrap_or_default();
        let end = match found.chars().next() {
            Some(c @ ('"' | '\'')) => closing(found, c).unwrap_or(found.len()),
            Some('[' | '{') => {
                open += 1;
                1
            }
            _ => {
                open -= 1;
                1
            }
        };
        rest = found.get(end..).unwrap_or_default();
    }
    open
}
