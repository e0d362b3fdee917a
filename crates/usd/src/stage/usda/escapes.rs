//! The escape sequences of strings.

/// Decodes the content of a string as OpenUSD does: up to two hexadecimal or three octal digits make one byte, and an
/// unknown sequence is its character.
pub(super) fn unescape(raw: &str) -> String {
    if !raw.contains('\\') {
        return raw.to_owned();
    }
    let mut bytes = Vec::with_capacity(raw.len());
    let mut rest = raw.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        rest = after;
        if byte != b'\\' {
            bytes.push(byte);
            continue;
        }
        let Some((&kind, after)) = rest.split_first() else {
            break;
        };
        let digits = |from: &[u8], radix: u32, maximum: usize| {
            let digit = |byte: &u8| char::from(*byte).to_digit(radix);
            let count = from.iter().take(maximum).take_while(|byte| digit(byte).is_some());
            count.count()
        };
        let (byte, length) = match kind {
            b'a' => (0x07, 1),
            b'b' => (0x08, 1),
            b'f' => (0x0c, 1),
            b'n' => (b'\n', 1),
            b'r' => (b'\r', 1),
            b't' => (b'\t', 1),
            b'v' => (0x0b, 1),
            b'x' => {
                let count = digits(after, 16, 2);
                (number(&after[..count], 16), 1 + count)
            }
            b'0'..=b'7' => {
                let count = digits(rest, 8, 3);
                (number(&rest[..count], 8), count)
            }
            other => (other, 1),
        };
        bytes.push(byte);
        rest = &rest[length..];
    }
    String::from_utf8(bytes).unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
}

/// Returns the lowest byte of a number.
fn number(digits: &[u8], radix: u8) -> u8 {
    digits.iter().fold(0, |number: u8, digit| {
        let digit = char::from(*digit).to_digit(radix.into()).unwrap_or(0);
        number
            .wrapping_mul(radix)
            .wrapping_add(u8::try_from(digit).unwrap_or(0))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expected values are OpenUSD 26.11's; `test_usd_strings.py` compares with the library itself.
    #[test]
    fn decodes_like_openusd() {
        for (raw, text) in [
            (r"a\tb\r\a\b\f\v", "a\tb\r\u{7}\u{8}\u{c}\u{b}"),
            (r"\x41 \x4142 \x4g \xg", "A A42 \u{4}g \0g"),
            (r"\101 \1012 \18 \8 \0 \400", "A A2 \u{1}8 8 \0 \0"),
            (r"\q \? \é \u00e9", "q ? é u00e9"),
            (r"\xc3\xa9 \xff", "é \u{fffd}"),
            (r"\\x41", r"\x41"),
        ] {
            assert_eq!(unescape(raw), text, "{raw}");
        }
    }
}
