use oaktwin_camera::math::DMat3;

/// Formats a number for YAML 1.1, YAML 1.2 and OpenCV: with a decimal point and a sign in the exponent, and as many digits as
/// are needed to read back the same `f64`.
pub(super) fn number(x: f64) -> String {
    let text = format!("{:?}", x + 0.0);
    let Some((mantissa, exponent)) = text.split_once('e') else {
        return text;
    };
    let point = if mantissa.contains('.') { "" } else { ".0" };
    let sign = if exponent.starts_with('-') { "" } else { "+" };
    format!("{mantissa}{point}e{sign}{exponent}")
}

/// Returns the key of the first number in a YAML text of [`number`]s that is not finite.
pub(super) fn not_finite(text: &str) -> Option<String> {
    let mut path: Vec<(usize, &str)> = Vec::new();
    for line in text.lines() {
        let entry = line.trim_start_matches([' ', '-']);
        let indent = line.len() - entry.len();
        let value = match entry.split_once(':') {
            Some((key, value)) if !key.contains(['[', ',']) => {
                path.retain(|(outer, _)| *outer < indent);
                path.push((indent, key));
                value
            }
            _ => entry,
        };
        let mut words = value.split(|c: char| !c.is_ascii_alphanumeric());
        if words.any(|word| word == "NaN" || word == "inf") {
            let keys: Vec<&str> = path.iter().map(|(_, key)| *key).collect();
            return Some(keys.join("."));
        }
    }
    None
}

/// `[1.0, 2.0]`
pub(super) fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|x| number(*x)).collect();
    format!("[{}]", numbers.join(", "))
}

/// Returns the entries of a matrix, row by row.
pub(super) fn rows(m: DMat3) -> [f64; 9] {
    m.transpose().to_cols_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_numbers_that_are_not_finite() {
        let text = |number: f64| {
            let data = list(&[1.0, number]);
            format!("camera_name: left\nprojection_matrix:\n  rows: 3\n  data: {data}\n")
        };
        assert_eq!(not_finite(&text(2.0)), None);
        for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(not_finite(&text(number)).unwrap(), "projection_matrix.data");
        }
        let rows = "cam1:\n  T_cn_cnm1:\n  - [1.0, inf]\n";
        assert_eq!(not_finite(rows).unwrap(), "cam1.T_cn_cnm1");
    }

    #[test]
    fn formats_numbers_for_all_readers() {
        for (x, text) in [
            (0.0, "0.0"),
            (-0.0, "0.0"),
            (800.0, "800.0"),
            (1e-7, "1.0e-7"),
            (-2.5e-9, "-2.5e-9"),
            (1e21, "1.0e+21"),
        ] {
            assert_eq!(number(x), text);
        }
    }
}
