//! Checks of single values.

use oaktwin_base::diagnostic::fold_name;

use super::Checked;
use crate::document::Document;

pub(super) fn text(doc: &Document<'_>, place: &str, value: &str) -> Checked {
    if fold_name(value).is_empty() || value.contains(char::is_control) {
        return Err(doc.error(
            place,
            format!("{value:?} is not a name"),
            "give a name on one line",
        ));
    }
    Ok(())
}

/// Checks a name of USD prims and asset files.
pub(super) fn prim_name(doc: &Document<'_>, place: &str, name: &str) -> Checked {
    let mut chars = name.chars();
    let first = chars.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
    if !(first && chars.all(|c| c.is_ascii_alphanumeric() || c == '_')) {
        return Err(doc.error(
            place,
            format!("{name:?} cannot name a prim"),
            "use letters, digits and underscores, and begin with no digit",
        ));
    }
    Ok(())
}

pub(super) fn unique_prim<'a>(
    doc: &Document<'_>,
    place: &str,
    name: &'a str,
    taken: &mut Vec<&'a str>,
) -> Checked {
    prim_name(doc, place, name)?;
    if taken.contains(&name) {
        return Err(doc.error(
            place,
            format!("a second prim '{name}'"),
            "give each prim its own name",
        ));
    }
    taken.push(name);
    Ok(())
}

/// A token that USD allows.
pub(super) fn one_of(doc: &Document<'_>, place: &str, value: &str, allowed: &[&str]) -> Checked {
    if allowed.contains(&value) {
        return Ok(());
    }
    let allowed: Vec<String> = allowed.iter().map(|token| format!("'{token}'")).collect();
    Err(doc.error(
        place,
        format!("unknown value {value:?}"),
        format!("use one of {}", allowed.join(", ")),
    ))
}

pub(super) fn positive(doc: &Document<'_>, place: &str, value: f64) -> Checked {
    if value > 0.0 {
        Ok(())
    } else {
        Err(doc.error(place, format!("{value} is not above 0"), "give a positive number"))
    }
}

pub(super) fn not_negative(doc: &Document<'_>, place: &str, value: f64) -> Checked {
    if value >= 0.0 {
        Ok(())
    } else {
        Err(doc.error(place, format!("{value} is below 0"), "give 0 or more"))
    }
}

pub(super) fn between(doc: &Document<'_>, place: &str, value: f64, limit: f64, remedy: &str) -> Checked {
    if value > 0.0 && value < limit {
        Ok(())
    } else {
        Err(doc.error(place, format!("a field of view of {value} degrees"), remedy))
    }
}

pub(super) fn ascending(doc: &Document<'_>, place: &str, (near, far): (f64, f64)) -> Checked {
    if near > 0.0 && far > near {
        Ok(())
    } else {
        Err(doc.error(
            place,
            format!("a range from {near} to {far}"),
            "give the nearer end first, both more than 0",
        ))
    }
}
