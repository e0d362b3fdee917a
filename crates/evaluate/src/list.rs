//! Lists of numbers as text.

/// The maximum number of steps of a range, and of numbers in a list.
const MAX_NUMBERS: usize = 10_000;

/// An invalid item of a list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct InvalidItem {
    /// The text of the item.
    pub(crate) text: String,
    /// The problem.
    pub(crate) what: String,
}

/// Parses a comma-separated list of numbers and ranges `FROM:TO:STEP`. `check` assesses every number and the ends of ranges;
/// `name` names an item (`a distance`).
pub(crate) fn parse(
    text: &str,
    name: &str,
    check: impl Fn(f64) -> Result<f64, &'static str>,
) -> Result<Vec<f64>, InvalidItem> {
    let wrong = |part: &str, what: &str| InvalidItem {
        text: part.to_owned(),
        what: what.to_owned(),
    };
    let mut numbers = Vec::new();
    for part in text.split(',').map(str::trim) {
        let items = part
            .split(':')
            .map(|number| number.trim().parse::<f64>())
            .collect::<Result<Vec<f64>, _>>()
            .map_err(|_| wrong(part, "is not a number"))?;
        match items[..] {
            [number] => numbers.push(check(number).map_err(|what| wrong(part, what))?),
            [from, to, step] => {
                for end in [from, to] {
                    check(end).map_err(|what| wrong(part, what))?;
                }
                let steps = (to - from) / step;
                if !(step > 0.0 && (0.0..MAX_NUMBERS as f64).contains(&steps)) {
                    return Err(wrong(part, "is empty or has too many steps"));
                }
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "below 10 000"
                )]
                let last = (steps + 1e-9) as u32;
                numbers.extend((0..=last).map(|i| tidy(from + f64::from(i) * step)));
            }
            _ => return Err(wrong(part, &format!("is neither {name} nor a range"))),
        }
        if numbers.len() > MAX_NUMBERS {
            return Err(wrong(text, "are too many"));
        }
    }
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    Ok(numbers)
}

/// Removes rounding errors of multiplications.
pub(crate) fn tidy(number: f64) -> f64 {
    (number * 1e6).round() / 1e6
}

#[cfg(test)]
mod tests {
    use super::*;

    fn any(text: &str) -> Result<Vec<f64>, InvalidItem> {
        parse(text, "a number", |number| {
            if number.is_finite() {
                Ok(number)
            } else {
                Err("is not finite")
            }
        })
    }

    #[test]
    fn parses_lists_and_ranges() {
        assert_eq!(any("2, 1,0.5,2").unwrap(), [0.5, 1.0, 2.0]);
        assert_eq!(any("0.1:0.4:0.1,9").unwrap(), [0.1, 0.2, 0.3, 0.4, 9.0]);
        assert_eq!(any("-20:10:15,-3").unwrap(), [-20.0, -5.0, -3.0, 10.0]);
        assert_eq!(any("1:1:0.5").unwrap(), [1.0]);
    }

    #[test]
    fn names_the_invalid_item() {
        for (text, item, what) in [
            ("", "", "is not a number"),
            ("1,,2", "", "is not a number"),
            ("1, x", "x", "is not a number"),
            ("1:2", "1:2", "is neither a number nor a range"),
            ("1:2:3:4", "1:2:3:4", "is neither a number nor a range"),
            ("2:1:1", "2:1:1", "is empty or has too many steps"),
            ("1:2:0", "1:2:0", "is empty or has too many steps"),
            ("1:2:-1", "1:2:-1", "is empty or has too many steps"),
            ("1:2:nan", "1:2:nan", "is empty or has too many steps"),
            ("0:1e9:1", "0:1e9:1", "is empty or has too many steps"),
            ("0,inf", "inf", "is not finite"),
            ("nan:1:1", "nan:1:1", "is not finite"),
        ] {
            let error = any(text).unwrap_err();
            assert_eq!((error.text.as_str(), error.what.as_str()), (item, what), "{text}");
        }
        assert!(any("0:9000:1,0.5:9000:1").is_err());
    }
}
