//! The values of statements.

use crate::import::text;

/// Parses a colour: three numbers, or one for a grey.
pub(super) fn color<'a>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<[f32; 3]> {
    let [r] = text::numbers(words)?;
    // A single number is a grey.
    let color = match text::numbers(words) {
        Some([g, b]) => [r, g, b],
        None => [r; 3],
    };
    color.iter().all(|x: &f32| x.is_finite()).then_some(color)
}

/// Parses a finite number.
pub(super) fn number(word: Option<&[u8]>) -> Option<f32> {
    text::number(word?).filter(|number: &f32| number.is_finite())
}
