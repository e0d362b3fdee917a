use std::fmt::Write as _;

use super::{Node, Value};

/// Formats a document like `eepromToJsonFile`: `nlohmann::json` with `setw(4)`, then a newline.
pub(super) fn document(root: &Node) -> String {
    let mut text = String::new();
    node(&mut text, root, 0);
    text.push('\n');
    text
}

fn node(text: &mut String, node: &Node, depth: usize) {
    match &node.value {
        Value::Null => text.push_str("null"),
        Value::Bool(value) => text.push_str(if *value { "true" } else { "false" }),
        Value::Number(number) => text.push_str(number),
        Value::String(value) => string(text, value),
        Value::Array(items) => block(text, depth, ('[', ']'), items.iter(), |text, item| {
            self::node(text, item, depth + 1);
        }),
        Value::Object(entries) => block(text, depth, ('{', '}'), entries.iter(), |text, (key, item)| {
            string(text, key);
            text.push_str(": ");
            self::node(text, item, depth + 1);
        }),
    }
}

fn block<T>(
    text: &mut String,
    depth: usize,
    (open, close): (char, char),
    items: impl ExactSizeIterator<Item = T>,
    write_item: impl Fn(&mut String, T),
) {
    text.push(open);
    let empty = items.len() == 0;
    for (i, item) in items.enumerate() {
        text.push_str(if i == 0 { "\n" } else { ",\n" });
        indent(text, depth + 1);
        write_item(text, item);
    }
    if !empty {
        text.push('\n');
        indent(text, depth);
    }
    text.push(close);
}

fn indent(text: &mut String, depth: usize) {
    text.extend(std::iter::repeat_n("    ", depth));
}

fn string(text: &mut String, value: &str) {
    text.push('"');
    for c in value.chars() {
        match c {
            '"' => text.push_str("\\\""),
            '\\' => text.push_str("\\\\"),
            '\u{8}' => text.push_str("\\b"),
            '\u{c}' => text.push_str("\\f"),
            '\n' => text.push_str("\\n"),
            '\r' => text.push_str("\\r"),
            '\t' => text.push_str("\\t"),
            // Writing to a string cannot fail.
            c if u32::from(c) < 0x20 => _ = write!(text, "\\u{:04x}", u32::from(c)),
            c => text.push(c),
        }
    }
    text.push('"');
}
