//! The numbers of a mesh: `<source>` elements, through their accessors.

use oaktwin_files::xml::{Element, XmlError};

use super::super::error::DAMAGED;

/// Reads a source of values with `N` components. Missing components are an error, further ones are ignored.
pub(super) fn read<const N: usize>(source: &Element) -> Result<Vec<[f64; N]>, XmlError> {
    let array = source
        .child("float_array")
        .ok_or_else(|| source.wrong("<float_array> is missing", DAMAGED))?;
    let numbers = array.text_numbers()?;
    if whole(array, "count")?.is_some_and(|count| count != numbers.len()) {
        let message = format!(
            "the count is {}, but there are {} numbers",
            array.get("count").unwrap_or_default(),
            numbers.len()
        );
        return Err(array.wrong(message, DAMAGED));
    }
    let accessor = source
        .child("technique_common")
        .and_then(|technique| technique.child("accessor"))
        .ok_or_else(|| source.wrong("<accessor> is missing", DAMAGED))?;
    let count = whole(accessor, "count")?.unwrap_or(0);
    let stride = whole(accessor, "stride")?.unwrap_or(1);
    let offset = whole(accessor, "offset")?.unwrap_or(0);
    let columns = columns::<N>(accessor)?;
    let last = columns.iter().max().copied().unwrap_or(0);
    let fits = last < stride
        && count
            .checked_mul(stride)
            .and_then(|needed| needed.checked_add(offset))
            .is_some_and(|needed| needed <= numbers.len());
    if !fits && count > 0 {
        let message = format!(
            "{count} values of {stride} numbers from {offset} do not fit into the {} numbers of the array",
            numbers.len()
        );
        return Err(accessor.wrong(message, DAMAGED));
    }
    let value = |number: usize| columns.map(|column| numbers[offset + number * stride + column]);
    Ok((0..count).map(value).collect())
}

/// The places of the components within a value. A `<param>` without a name is a number that is skipped.
fn columns<const N: usize>(accessor: &Element) -> Result<[usize; N], XmlError> {
    let params: Vec<&Element> = accessor.all("param").collect();
    let is_named = |param: &Element| param.get("name").is_some_and(|name| !name.is_empty());
    let has_names = params.iter().any(|param| is_named(param));
    let mut found = (0..params.len()).filter(|&at| !has_names || is_named(params[at]));
    let mut columns = [0; N];
    for (number, column) in columns.iter_mut().enumerate() {
        *column = match found.next() {
            Some(at) => at,
            None if params.is_empty() => number,
            None => {
                let message = format!("has {number} components instead of {N}");
                return Err(accessor.wrong(message, DAMAGED));
            }
        };
    }
    Ok(columns)
}

/// Reads an attribute that is a whole number.
pub(super) fn whole(element: &Element, name: &str) -> Result<Option<usize>, XmlError> {
    let Some(text) = element.get(name) else {
        return Ok(None);
    };
    let number = text.parse::<u32>().ok().and_then(|n| usize::try_from(n).ok());
    number
        .map(Some)
        .ok_or_else(|| element.wrong(format!("{name}: '{text}' is not a whole number"), DAMAGED))
}

/// Reads the whole numbers of an element's text. Numbers that are too large or below 0 become −1.
pub(super) fn indices(element: &Element) -> Result<Vec<i32>, XmlError> {
    let index = |word: &str| {
        let number = word.parse::<i64>().map_err(|_| {
            let shown: String = word.chars().take(40).collect();
            element.wrong(format!("'{shown}' is not a whole number"), DAMAGED)
        })?;
        Ok(i32::try_from(number)
            .ok()
            .filter(|number| *number >= 0)
            .unwrap_or(-1))
    };
    element.text.split_ascii_whitespace().map(index).collect()
}
