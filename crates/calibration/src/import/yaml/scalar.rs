use crate::raw::Value;

/// Returns the value of a scalar on one line, or `None` if a quote is not closed.
pub(super) fn scalar(text: &str) -> Option<Value> {
    if let Some(rest) = text.strip_prefix('"') {
        let inner = rest.strip_suffix('"')?;
        return Some(Value::String(inner.replace("\\\"", "\"").replace("\\\\", "\\")));
    }
    if let Some(rest) = text.strip_prefix('\'') {
        return Some(Value::String(rest.strip_suffix('\'')?.replace("''", "'")));
    }
    Some(plain(text))
}

fn plain(text: &str) -> Value {
    match text {
        "" | "~" | "null" | "Null" => return Value::Null,
        "true" | "True" => return Value::Bool(true),
        "false" | "False" => return Value::Bool(false),
        _ => {}
    }
    let unsigned = text.trim_start_matches(['+', '-']);
    let not_finite = ["nan", ".nan", "inf", ".inf"].contains(&unsigned.to_ascii_lowercase().as_str());
    let is_number = unsigned.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        && text.contains(|c: char| c.is_ascii_digit())
        && text.parse::<f64>().is_ok();
    if not_finite || is_number {
        Value::Number(text.to_owned())
    } else {
        Value::String(text.to_owned())
    }
}

/// Returns the text without a leading tag such as `!!opencv-matrix`.
pub(super) fn without_tag(text: &str) -> &str {
    match text.strip_prefix('!') {
        Some(_) => text
            .split_once(char::is_whitespace)
            .map_or("", |(_, rest)| rest.trim_start()),
        None => text,
    }
}
