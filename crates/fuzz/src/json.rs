//! Changes of JSON documents.

use serde_json::Value;

use crate::random::Random;

/// Changes a few places of a document, as the bytes of the input say.
pub(crate) fn change(document: &mut Value, random: &mut Random<'_>) {
    for _ in 0..32 {
        if random.is_empty() {
            return;
        }
        let place = place(document, random, 12);
        change_value(place, random);
    }
}

/// Returns a value below a value, more often a leaf than not.
fn place<'a>(value: &'a mut Value, random: &mut Random<'_>, depth: u32) -> &'a mut Value {
    let count = match value {
        Value::Array(items) => items.len(),
        Value::Object(entries) => entries.len(),
        _ => 0,
    };
    if count == 0 || depth == 0 || random.up_to(15) == 15 {
        return value;
    }
    let at = random.up_to(u32::try_from(count - 1).unwrap_or(0)) as usize;
    match value {
        Value::Array(items) => place(&mut items[at], random, depth - 1),
        Value::Object(entries) => {
            let mut values = entries.values_mut();
            let child = values.nth(at).unwrap_or_else(|| panic!("counted"));
            place(child, random, depth - 1)
        }
        leaf => leaf,
    }
}

fn change_value(place: &mut Value, random: &mut Random<'_>) {
    match random.up_to(7) {
        0 => *place = Value::from(random.number()),
        1 => *place = Value::from(i64::from(random.up_to(40)) - 3),
        2 => *place = Value::String(random.text()),
        3 => {
            *place = match random.up_to(2) {
                0 => Value::Null,
                1 => Value::Bool(true),
                _ => Value::Object(serde_json::Map::new()),
            }
        }
        4 => match place {
            Value::Array(items) => {
                let length = random.up_to(20) as usize;
                let filler = items.first().cloned().unwrap_or(Value::Null);
                items.resize(length, filler);
            }
            Value::Number(number) => {
                let factor = random.number();
                *place = Value::from(number.as_f64().unwrap_or(1.0) * factor);
            }
            _ => *place = Value::Array(vec![place.take(); 2]),
        },
        5 => {
            if let Value::Object(entries) = place {
                let at = random.up_to(u32::try_from(entries.len()).unwrap_or(0)) as usize;
                if let Some(key) = entries.keys().nth(at).cloned() {
                    entries.shift_remove(&key);
                }
            }
        }
        6 => {
            if let Value::Object(entries) = place {
                entries.insert(random.text(), Value::from(random.number()));
            }
        }
        _ => {
            // A second entry in the place of the first.
            if let Value::Array(items) = place
                && items.len() > 1
            {
                let at = random.up_to(u32::try_from(items.len() - 1).unwrap_or(0)) as usize;
                items[0] = items[at].clone();
            }
        }
    }
}
