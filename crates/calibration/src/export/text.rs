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
