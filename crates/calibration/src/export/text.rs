use oaktwin_camera::math::DMat3;

/// A number that YAML 1.1 and 1.2 and OpenCV read as one: with a point, and a sign in its exponent. The shortest digits
/// that give the same `f64` back.
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

/// A matrix's entries row by row.
pub(super) fn rows(m: DMat3) -> [f64; 9] {
    m.transpose().to_cols_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_numbers_everywhere() {
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
