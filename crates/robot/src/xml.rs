//! A small writer of XML.

use std::fmt::Write;

/// An element with attributes and either text or children.
#[derive(Clone, Debug, Default)]
pub(crate) struct XmlElement {
    name: &'static str,
    attributes: Vec<(&'static str, String)>,
    text: Option<String>,
    comment: Option<String>,
    children: Vec<XmlElement>,
}

impl XmlElement {
    pub(crate) fn new(name: &'static str) -> Self {
        Self {
            name,
            ..Self::default()
        }
    }

    /// Creates an element that contains text only.
    pub(crate) fn text(name: &'static str, text: impl Into<String>) -> Self {
        Self {
            text: Some(text.into()),
            ..Self::new(name)
        }
    }

    pub(crate) fn set(mut self, name: &'static str, value: impl Into<String>) -> Self {
        self.attributes.push((name, value.into()));
        self
    }

    pub(crate) fn with(mut self, child: Self) -> Self {
        self.children.push(child);
        self
    }

    pub(crate) fn with_all(mut self, children: impl IntoIterator<Item = Self>) -> Self {
        self.children.extend(children);
        self
    }

    /// Adds a comment before the element.
    pub(crate) fn commented(mut self, comment: impl Into<String>) -> Self {
        self.comment = Some(comment.into());
        self
    }

    /// Returns the document with this root.
    pub(crate) fn document(&self) -> String {
        let mut out = String::from("<?xml version=\"1.0\"?>\n");
        self.write(&mut out, 0);
        out
    }

    fn write(&self, out: &mut String, depth: usize) {
        let indent = "  ".repeat(depth);
        if let Some(comment) = &self.comment {
            // A comment must not contain two hyphens in a row.
            let _ = writeln!(out, "{indent}<!-- {} -->", comment.replace("--", "- -"));
        }
        let _ = write!(out, "{indent}<{}", self.name);
        for (name, value) in &self.attributes {
            let _ = write!(out, " {name}=\"{}\"", escaped(value));
        }
        match &self.text {
            Some(text) => {
                let _ = writeln!(out, ">{}</{}>", escaped(text), self.name);
            }
            None if self.children.is_empty() => out.push_str("/>\n"),
            None => {
                out.push_str(">\n");
                for child in &self.children {
                    child.write(out, depth + 1);
                }
                let _ = writeln!(out, "{indent}</{}>", self.name);
            }
        }
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Returns a number with at most nine decimals, which is a nanometre or a nanoradian.
pub(crate) fn number(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

/// Returns numbers separated by spaces.
pub(crate) fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    let texts: Vec<String> = values.into_iter().map(number).collect();
    texts.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn special_characters_are_escaped() {
        let element = XmlElement::new("a")
            .set("b", "\"<&>")
            .with(XmlElement::text("c", "1 < 2").commented("x -- y"));
        assert_eq!(
            element.document(),
            "<?xml version=\"1.0\"?>\n<a b=\"&quot;&lt;&amp;&gt;\">\n  <!-- x - - y -->\n  <c>1 &lt; 2</c>\n</a>\n"
        );
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            numbers([0.0375, -0.0, 1e-12, 2.0, -1.0 / 3.0]),
            "0.0375 0 0 2 -0.333333333"
        );
    }
}
