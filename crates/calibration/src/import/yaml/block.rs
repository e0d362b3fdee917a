//! Block collections, whose structure is the indentation.

use std::collections::BTreeSet;

use super::Problem;
use super::flow::{Flow, open_brackets};
use super::line::YamlLine;
use super::scalar::{scalar, without_tag};
use crate::raw::{MAX_DEPTH, Node, Position, Value};

/// Parses lines, of which there is at least one.
pub(super) fn document(lines: &[YamlLine<'_>]) -> Result<Node, Problem> {
    let mut block = Block {
        lines: lines.to_vec(),
        at: 0,
    };
    let indent = lines.first().map_or(0, |line| line.indent);
    let node = block.node(indent, 0)?;
    match block.peek() {
        None => Ok(node),
        Some(line) => Err(Problem::new(
            line.number,
            "unexpected indentation, or a value over several lines",
        )),
    }
}

struct Block<'a> {
    lines: Vec<YamlLine<'a>>,
    at: usize,
}

impl<'a> Block<'a> {
    fn peek(&self) -> Option<YamlLine<'a>> {
        self.lines.get(self.at).copied()
    }

    /// Parses the value that begins on the current line, which is indented by `indent`.
    fn node(&mut self, indent: usize, depth: usize) -> Result<Node, Problem> {
        let Some(line) = self.peek() else {
            return Ok(Value::Null.into());
        };
        if depth > MAX_DEPTH {
            return Err(Problem::too_deep(line.number));
        }
        let value = if is_item(line.text) {
            Value::Array(self.sequence(indent, depth)?)
        } else if key_and_rest(line).is_some() {
            Value::Object(self.mapping(indent, depth)?)
        } else {
            return self.inline(line.text, depth);
        };
        Ok(Node {
            value,
            at: position(line),
        })
    }

    fn sequence(&mut self, indent: usize, depth: usize) -> Result<Vec<Node>, Problem> {
        let mut items = Vec::new();
        while let Some(line) = self
            .peek()
            .filter(|line| line.indent == indent && is_item(line.text))
        {
            let rest = line.text.get(1..).unwrap_or_default().trim_start();
            if rest.is_empty() {
                self.at += 1;
                items.push(self.below(indent, depth)?);
                continue;
            }
            // What follows the dash is a line of its own, indented by its column.
            let inner = indent + line.text.len() - rest.len();
            if let Some(current) = self.lines.get_mut(self.at) {
                (current.indent, current.text) = (inner, rest);
            }
            items.push(self.node(inner, depth + 1)?);
        }
        Ok(items)
    }

    fn mapping(&mut self, indent: usize, depth: usize) -> Result<Vec<(String, Node)>, Problem> {
        let mut entries: Vec<(String, Node)> = Vec::new();
        let mut known: BTreeSet<String> = BTreeSet::new();
        while let Some(line) = self.peek().filter(|line| line.indent == indent) {
            let Some((key, rest)) = key_and_rest(line) else {
                return Err(Problem::new(line.number, "a \": \" is missing after the key"));
            };
            if !known.insert(key.clone()) {
                return Err(Problem::new(
                    line.number,
                    format!("the key \"{key}\" is repeated"),
                ));
            }
            let rest = without_tag(rest);
            let value = if rest.is_empty() {
                self.at += 1;
                match self.peek() {
                    // A sequence may have the indentation of its key.
                    Some(next) if next.indent == indent && is_item(next.text) => {
                        self.node(indent, depth + 1)?
                    }
                    _ => self.below(indent, depth)?,
                }
            } else {
                self.inline(rest, depth)?
            };
            entries.push((key, value));
        }
        Ok(entries)
    }

    /// Parses a value on the following, deeper lines; null if there are none.
    fn below(&mut self, indent: usize, depth: usize) -> Result<Node, Problem> {
        match self.peek() {
            Some(next) if next.indent > indent => self.node(next.indent, depth + 1),
            _ => Ok(Value::Null.into()),
        }
    }

    /// Parses a scalar or flow collection that begins on the current line with `text`, and moves to the line after it.
    fn inline(&mut self, text: &str, depth: usize) -> Result<Node, Problem> {
        let Some(line) = self.peek() else {
            return Ok(Value::Null.into());
        };
        self.at += 1;
        let first = text.chars().next().unwrap_or_default();
        if ['&', '*', '|', '>', '@', '`'].contains(&first) {
            let what =
                format!("\"{first}\" begins an anchor, alias or block text, which no calibration needs");
            return Err(Problem::new(line.number, what));
        }
        if !['[', '{'].contains(&first) {
            let value = scalar(text).ok_or_else(|| Problem::new(line.number, "a quote is not closed"))?;
            return Ok(Node {
                value,
                at: position(line),
            });
        }
        let (mut whole, mut open) = (text.to_owned(), open_brackets(text));
        let mut before = line.number;
        while open > 0 {
            let Some(next) = self.peek() else {
                let what = format!("the \"{first}\" is not closed; the file may be truncated");
                return Err(Problem::new(line.number, what));
            };
            whole.extend(std::iter::repeat_n('\n', next.number - before));
            whole.push_str(next.text);
            (before, open) = (next.number, open + open_brackets(next.text));
            self.at += 1;
        }
        Flow::new(&whole, line.number).whole(depth + 1)
    }
}

fn position(line: YamlLine<'_>) -> Position {
    Position {
        line: line.number,
        column: line.indent + 1,
    }
}

fn is_item(text: &str) -> bool {
    text == "-" || text.starts_with("- ")
}

/// Splits `key: value`.
fn key_and_rest(line: YamlLine<'_>) -> Option<(String, &str)> {
    let text = line.text;
    if text.starts_with(['[', '{']) {
        return None;
    }
    let from = text
        .strip_prefix(['"', '\''])
        .map_or(0, |rest| rest.find(['"', '\'']).map_or(0, |end| end + 2));
    let (key, rest) = match text.get(from..)?.find(": ") {
        Some(at) => (text.get(..from + at)?, text.get(from + at + 1..)?),
        None => (text.strip_suffix(':')?, ""),
    };
    match scalar(key.trim())? {
        Value::String(key) | Value::Number(key) => Some((key, rest.trim())),
        _ => None,
    }
}
