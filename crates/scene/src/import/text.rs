//! Parses text files of numbers.

use std::borrow::Cow;

/// Converts a text file to UTF-8 without a byte-order mark and with `\n` at the end of its lines.
///
/// UTF-16 is recognized by its byte-order mark, or by the zero byte of an ASCII character at the start of the file.
pub(super) fn decoded(bytes: &[u8]) -> Cow<'_, [u8]> {
    let mut text = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_be_bytes)),
        [1..=255, 0, 1..=255, 0, ..] => Cow::Owned(from_utf16(bytes, u16::from_le_bytes)),
        [0, 1..=255, 0, 1..=255, ..] => Cow::Owned(from_utf16(bytes, u16::from_be_bytes)),
        _ => Cow::Borrowed(bytes),
    };
    if !text.contains(&b'\n') && text.contains(&b'\r') {
        for byte in text.to_mut() {
            if *byte == b'\r' {
                *byte = b'\n';
            }
        }
    }
    text
}

fn from_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let units = bytes.as_chunks().0.iter().map(|&pair| unit(pair));
    let text: String = char::decode_utf16(units)
        .map(|char| char.unwrap_or(char::REPLACEMENT_CHARACTER))
        .collect();
    text.into_bytes()
}

/// The lines of a file with their numbers from 1. A backslash at the end of a line does not continue it.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    (1..).zip(bytes.split(|&byte| byte == b'\n'))
}

/// Like [`lines`], but a backslash at the end of a line continues it, except in a comment: comments often end with the name of
/// a folder. The number is the first line's.
pub(super) fn continued_lines(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let mut lines = lines(bytes);
    std::iter::from_fn(move || {
        let (number, first) = lines.next()?;
        let mut line = Cow::Borrowed(first);
        while let Some(start) = line.trim_ascii_end().strip_suffix(b"\\") {
            if start.trim_ascii_start().starts_with(b"#") {
                break;
            }
            let next = lines.next().map_or(&b""[..], |(_, next)| next);
            line = Cow::Owned([start, b" ", next].concat());
        }
        Some((number, line))
    })
}

pub(super) fn words(line: &[u8]) -> impl Iterator<Item = &[u8]> {
    line.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// Parses a number.
pub(super) fn number<T: std::str::FromStr>(word: &[u8]) -> Option<T> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// Parses the first `N` words of a line as numbers.
pub(super) fn numbers<'a, T, const N: usize>(words: &mut impl Iterator<Item = &'a [u8]>) -> Option<[T; N]>
where
    T: std::str::FromStr + Default + Copy,
{
    let mut numbers = [T::default(); N];
    for slot in &mut numbers {
        *slot = number(words.next()?)?;
    }
    Some(numbers)
}

/// Formats bytes for a message.
pub(super) fn shown(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(40)]);
    text.trim().escape_debug().to_string()
}
