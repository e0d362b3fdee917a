use std::cmp::Ordering;

/// Whether a name is a valid identifier: a letter or underscore, then letters, digits and underscores.
///
/// OpenUSD 24.3 and later accept any Unicode identifier; ASCII is what all tools accept.
#[must_use]
pub fn is_identifier(name: &str) -> bool {
    let mut bytes = name.bytes();
    bytes.next().is_some_and(|b| b.is_ascii_alphabetic() || b == b'_')
        && bytes.all(|b| b.is_ascii_alphanumeric() || b == b'_')
}

/// Compares property names as OpenUSD does: case-insensitively, with runs of digits compared as numbers. Names that
/// are equal in this sense are compared byte by byte.
pub(super) fn dictionary_order(a: &str, b: &str) -> Ordering {
    let (left, right) = (a.as_bytes(), b.as_bytes());
    let (mut i, mut j) = (0, 0);
    while let (Some(&x), Some(&y)) = (left.get(i), right.get(j)) {
        if x.is_ascii_digit() && y.is_ascii_digit() {
            let (run_x, run_y) = (digits(&left[i..]), digits(&right[j..]));
            let order = significant(run_x)
                .len()
                .cmp(&significant(run_y).len())
                .then_with(|| significant(run_x).cmp(significant(run_y)));
            if order.is_ne() {
                return order;
            }
            i += run_x.len();
            j += run_y.len();
        } else {
            let order = x.to_ascii_lowercase().cmp(&y.to_ascii_lowercase());
            if order.is_ne() {
                return order;
            }
            i += 1;
            j += 1;
        }
    }
    (left.len() - i).cmp(&(right.len() - j)).then_with(|| a.cmp(b))
}

fn digits(bytes: &[u8]) -> &[u8] {
    let end = bytes
        .iter()
        .position(|b| !b.is_ascii_digit())
        .unwrap_or(bytes.len());
    &bytes[..end]
}

fn significant(digits: &[u8]) -> &[u8] {
    let start = digits.iter().position(|&b| b != b'0').unwrap_or(digits.len());
    &digits[start..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorts_names_like_openusd() {
        let mut names = [
            "user:d10",
            "user:d2",
            "xformOpOrder",
            "xformOp:translate",
            "fStop",
            "focalLength",
            "material:binding",
            "faceVertexCounts",
        ];
        names.sort_by(|a, b| dictionary_order(a, b));
        assert_eq!(
            names,
            [
                "faceVertexCounts",
                "focalLength",
                "fStop",
                "material:binding",
                "user:d2",
                "user:d10",
                "xformOp:translate",
                "xformOpOrder",
            ]
        );
    }

    #[test]
    fn accepts_ascii_identifiers_only() {
        for name in ["a", "_", "Camera_rgb_imx378"] {
            assert!(is_identifier(name), "{name}");
        }
        for name in ["", "4d", "a-b", "a b", "ä", "a:b", "a/b"] {
            assert!(!is_identifier(name), "{name}");
        }
    }
}
