//! Parses text files of numbers.

/// The lines of a file with their numbers from 1. A backslash at the end of a line does not continue it.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, &[u8])> {
    (1..).zip(bytes.split(|&byte| byte == b'\n'))
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
