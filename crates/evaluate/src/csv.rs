//! Small tables as people write them: comma-separated values below a line of names.

use std::path::Path;

use oaktwin_files::{self as files, FileError};

/// Far more than anybody measures.
const MOST_ROWS: usize = 10_000;

/// What is wrong with a table, and what to do.
#[derive(Debug)]
pub(crate) struct Wrong {
    pub(crate) what: String,
    pub(crate) remedy: String,
}

pub(crate) fn wrong(what: impl Into<String>, remedy: impl Into<String>) -> Wrong {
    Wrong {
        what: what.into(),
        remedy: remedy.into(),
    }
}

impl Wrong {
    /// As an error about a file.
    pub(crate) fn of(self, path: &Path) -> FileError {
        FileError::new(path, self.what, self.remedy)
    }
}

/// The text of a small table, which is `what` (`a measured curve`).
pub(crate) fn text(path: &Path, what: &str) -> Result<String, FileError> {
    let bytes = files::read(path, 1 << 20, what)?;
    String::from_utf8(bytes).map_err(|_| FileError::new(path, "is no text", "give a CSV file in UTF-8"))
}

/// A row's wanted fields, in the order in which they were asked for.
#[derive(Clone, Debug)]
pub(crate) struct Row<'a, const N: usize> {
    /// The line in the file, from 1.
    pub(crate) line: usize,
    pub(crate) fields: [&'a str; N],
    names: [&'static str; N],
}

impl<const N: usize> Row<'_, N> {
    /// A field that is a finite number.
    pub(crate) fn number(&self, at: usize) -> Result<f64, Wrong> {
        let (field, name) = (self.fields[at], self.names[at]);
        let value = field.parse::<f64>().ok().filter(|value| value.is_finite());
        value.ok_or_else(|| {
            let what = format!("line {}: {name}: {field:?} is no finite number", self.line);
            wrong(what, "correct it, or leave the line out")
        })
    }
}

/// The rows of a table, of which these columns are wanted, in whatever order they stand and whatever others there are.
pub(crate) fn rows<'a, const N: usize>(
    text: &'a str,
    names: [&'static str; N],
) -> Result<Vec<Row<'a, N>>, Wrong> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, line)| !line.trim().is_empty());
    let wanted = names.join(",");
    let Some((_, header)) = lines.next() else {
        return Err(wrong("is empty", format!("give the columns {wanted}")));
    };
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(names) {
        *place = fields(header).position(|field| field == name).ok_or_else(|| {
            let separator = [';', '\t'].into_iter().find(|c| header.contains(*c));
            match separator {
                Some(c) => wrong(
                    format!("line 1: there is no column {name}: they are apart by {c:?}"),
                    "separate them by commas, with points in the numbers",
                ),
                None => wrong(
                    format!("line 1: there is no column {name}"),
                    format!("name the columns {wanted} in the first line"),
                ),
            }
        })?;
    }
    let mut rows = Vec::new();
    for (line, text) in lines {
        let all: Vec<&str> = fields(text).collect();
        rows.push(Row {
            line,
            fields: places.map(|at| all.get(at).copied().unwrap_or_default()),
            names,
        });
        if rows.len() > MOST_ROWS {
            return Err(wrong(
                format!("has more than {MOST_ROWS} rows"),
                "check that it is the right file",
            ));
        }
    }
    if rows.is_empty() {
        return Err(wrong("has no row below its header", "give at least one"));
    }
    Ok(rows)
}

/// Whether a table has a column of this name.
pub(crate) fn has_column(text: &str, name: &str) -> bool {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let header = text.lines().find(|line| !line.trim().is_empty());
    header.is_some_and(|header| fields(header).any(|field| field == name))
}

fn fields(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|field| field.trim().trim_matches('"').trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_in_any_order() {
        let text = "\u{feff}b,\"a\", c\r\n1, x ,2\r\n\r\n3\r\n";
        let rows = rows(text, ["a", "b"]).unwrap();
        assert_eq!((rows[0].line, rows[0].fields), (2, ["x", "1"]));
        assert_eq!((rows[1].line, rows[1].fields), (4, ["", "3"]));
        assert_eq!(rows[0].number(1).unwrap(), 1.0);
        assert!(rows[0].number(0).unwrap_err().what.contains("line 2: a: \"x\""));
        assert!(has_column(text, "c") && !has_column(text, "d") && !has_column("", "a"));
    }

    #[test]
    fn a_table_ends() {
        let long = format!("a\n{}", "1\n".repeat(MOST_ROWS + 1));
        assert!(rows(&long, ["a"]).is_err());
    }
}
