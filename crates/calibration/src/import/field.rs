use oaktwin_base::diagnostic::{Finding, Level, Message};

use crate::CalibrationError;
use crate::raw::{Node, Value};

/// Returns an error of a file.
pub(super) fn error(
    file: &str,
    place: &str,
    code: &'static str,
    what: impl Into<Message>,
    remedy: impl Into<Message>,
) -> CalibrationError {
    CalibrationError::Invalid {
        file: file.to_owned(),
        errors: vec![Finding::new(code, Level::Error, place, what, remedy)],
    }
}

/// A value of a file with its path, such as `cam0.intrinsics`.
#[derive(Clone)]
pub(super) struct Field<'a> {
    pub(super) node: &'a Node,
    pub(super) file: &'a str,
    path: String,
}

impl<'a> Field<'a> {
    pub(super) fn root(node: &'a Node, file: &'a str) -> Self {
        let path = String::new();
        Self { node, file, path }
    }

    pub(super) fn path(&self) -> &str {
        if self.path.is_empty() {
            "the document"
        } else {
            &self.path
        }
    }

    pub(super) fn key_path(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// Returns the value of a key that is present and not null.
    pub(super) fn get(&self, key: &str) -> Option<Self> {
        let node = self.node.get(key)?;
        (node.value != Value::Null).then(|| Self {
            node,
            file: self.file,
            path: self.key_path(key),
        })
    }

    /// Returns the value of the first key that is present.
    pub(super) fn any(&self, keys: &[&str]) -> Option<Self> {
        keys.iter().find_map(|key| self.get(key))
    }

    /// Returns the value of the first key that is present, or the error that the first key is missing.
    pub(super) fn require(&self, keys: &[&str]) -> Result<Self, CalibrationError> {
        self.any(keys).ok_or_else(|| {
            let place = self.key_path(keys.first().copied().unwrap_or_default());
            let remedy = "add it, or write the calibration again";
            error(self.file, &place, "missing-key", "missing or empty", remedy)
        })
    }

    /// Returns the error about this field.
    pub(super) fn error(
        &self,
        code: &'static str,
        what: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> CalibrationError {
        error(self.file, self.path(), code, what, remedy)
    }

    fn wrong_type(&self, wanted: &str) -> CalibrationError {
        let what = format!("{} instead of {wanted}", self.node.value.kind());
        self.error("wrong-type", what, "correct it, or write the calibration again")
    }

    pub(super) fn text(&self) -> Result<&'a str, CalibrationError> {
        match &self.node.value {
            Value::String(text) | Value::Number(text) => Ok(text),
            _ => Err(self.wrong_type("a text")),
        }
    }

    /// Returns a finite number in the range of a 32-bit float, which `DepthAI` stores.
    pub(super) fn number(&self) -> Result<f64, CalibrationError> {
        let Value::Number(text) = &self.node.value else {
            return Err(self.wrong_type("a number"));
        };
        let found = text.parse().ok().filter(|x: &f64| x.abs() <= f64::from(f32::MAX));
        found.ok_or_else(|| {
            let shown: String = text.chars().take(40).collect();
            self.error(
                "not-finite",
                format!("{shown} is not a finite number in the range of a 32-bit float"),
                "calibrate again",
            )
        })
    }

    /// Returns the width or height of an image, from 1 to 65535.
    pub(super) fn side(&self) -> Result<u32, CalibrationError> {
        let number = self.number()?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "checked on the same line"
        )]
        let side = (number.fract() == 0.0 && (1.0..=65535.0).contains(&number)).then_some(number as u32);
        side.ok_or_else(|| {
            self.error(
                "image-size",
                format!("{number} is not a whole number from 1 to 65535"),
                "state the size of the images in pixels",
            )
        })
    }

    pub(super) fn items(&self) -> Result<Vec<Self>, CalibrationError> {
        let Value::Array(items) = &self.node.value else {
            return Err(self.wrong_type("a list"));
        };
        let item = |(i, node)| Self {
            node,
            file: self.file,
            path: format!("{}[{i}]", self.path),
        };
        Ok(items.iter().enumerate().map(item).collect())
    }

    /// Returns the numbers of a list, a list of lists, or a matrix with the keys rows, cols and data, row by row.
    pub(super) fn numbers(&self) -> Result<Vec<f64>, CalibrationError> {
        let Some(data) = self.get("data") else {
            let mut numbers = Vec::new();
            for item in self.items()? {
                match &item.node.value {
                    Value::Array(_) => {
                        for inner in item.items()? {
                            numbers.push(inner.number()?);
                        }
                    }
                    _ => numbers.push(item.number()?),
                }
            }
            return Ok(numbers);
        };
        let numbers: Vec<f64> = data.items()?.iter().map(Self::number).collect::<Result<_, _>>()?;
        if let (Some(rows), Some(cols)) = (self.get("rows"), self.get("cols")) {
            let (rows, cols) = (rows.side()?, cols.side()?);
            if u64::from(rows) * u64::from(cols) != numbers.len() as u64 {
                let what = format!("{} numbers in a {rows}x{cols} matrix", numbers.len());
                return Err(self.error("matrix-size", what, "correct it, or write the calibration again"));
            }
        }
        Ok(numbers)
    }

    /// Returns exactly `N` numbers; `what` names them in the error.
    pub(super) fn exactly<const N: usize>(&self, what: &str) -> Result<[f64; N], CalibrationError> {
        let numbers = self.numbers()?;
        <[f64; N]>::try_from(numbers.as_slice()).map_err(|_| {
            let message = format!("{} numbers; {what} has {N}", numbers.len());
            self.error(
                "matrix-size",
                message,
                "correct it, or write the calibration again",
            )
        })
    }
}
