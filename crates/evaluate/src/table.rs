//! Small CSV files with a header line.

use std::path::Path;

use csv::{ReaderBuilder, StringRecord, StringRecordsIntoIter, Trim};
use oaktwin_files::{self as files, FileError};

const MAX_ROWS: usize = 10_000;

/// A problem of a table and its remedy.
#[derive(Debug)]
pub(crate) struct TableProblem {
    pub(crate) what: String,
    pub(crate) remedy: String,
}

pub(crate) fn wrong(what: impl Into<String>, remedy: impl Into<String>) -> TableProblem {
    TableProblem {
        what: what.into(),
        remedy: remedy.into(),
    }
}

impl TableProblem {
    /// Returns the error for the file at `path`.
    pub(crate) fn of(self, path: &Path) -> FileError {
        FileError::new(path, self.what, self.remedy)
    }
}

/// Reads the text of a small table; `what` describes it in errors (`a measured curve`).
pub(crate) fn text(path: &Path, what: &str) -> Result<String, FileError> {
    let bytes = files::read(path, 1 << 20, what)?;
    String::from_utf8(bytes)
        .map_err(|_| FileError::new(path, "is not UTF-8 text", "give a CSV file in UTF-8"))
}

/// The requested fields of a row in the order of the request; empty if the row is too short.
#[derive(Clone, Debug)]
pub(crate) struct CsvRow<const N: usize> {
    /// The line number in the file, starting at 1.
    pub(crate) line: usize,
    pub(crate) fields: [String; N],
    names: [&'static str; N],
}

impl<const N: usize> CsvRow<N> {
    /// Parses a field as a finite number.
    pub(crate) fn number(&self, at: usize) -> Result<f64, TableProblem> {
        let (field, name) = (&self.fields[at], self.names[at]);
        let value = field.parse::<f64>().ok().filter(|value| value.is_finite());
        value.ok_or_else(|| {
            let what = format!("line {}: {name}: {field:?} is not a finite number", self.line);
            wrong(what, "correct it or remove the line")
        })
    }
}

/// Reads the named columns of a table. The columns may be in any order, and others are ignored.
pub(crate) fn rows<const N: usize>(
    text: &str,
    names: [&'static str; N],
) -> Result<Vec<CsvRow<N>>, TableProblem> {
    let text = text.trim_start_matches('\u{feff}');
    let mut records = records(text);
    let wanted = names.join(",");
    let Some((_, header)) = records.next().transpose()? else {
        return Err(wrong("is empty", format!("give the columns {wanted}")));
    };
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(names) {
        *place = position(&header, name).ok_or_else(|| missing(&header, name, &wanted))?;
    }
    let mut rows = Vec::new();
    for record in records {
        let (line, record) = record?;
        rows.push(CsvRow {
            line,
            fields: places.map(|at| record.get(at).map(plain).unwrap_or_default().to_owned()),
            names,
        });
        if rows.len() > MAX_ROWS {
            return Err(wrong(
                format!("has more than {MAX_ROWS} rows"),
                "check that it is the right file",
            ));
        }
    }
    if rows.is_empty() {
        return Err(wrong("has no rows below its header", "give at least one"));
    }
    Ok(rows)
}

/// Whether a table has a column of this name.
pub(crate) fn has_column(text: &str, name: &str) -> bool {
    let header = records(text.trim_start_matches('\u{feff}')).next();
    header.is_some_and(|header| header.is_ok_and(|(_, header)| position(&header, name).is_some()))
}

fn missing(header: &StringRecord, name: &str, wanted: &str) -> TableProblem {
    let separator = [';', '\t']
        .into_iter()
        .find(|c| header.iter().any(|field| field.contains(*c)));
    match separator {
        Some(c) => wrong(
            format!("line 1: there is no column {name}: the columns are separated by {c:?}"),
            "separate them with commas, and use decimal points in numbers",
        ),
        None => wrong(
            format!("line 1: there is no column {name}"),
            format!("name the columns {wanted} in the first line"),
        ),
    }
}

/// Returns the records that are not blank, each with the number of its first line.
fn records(text: &str) -> impl Iterator<Item = Result<(usize, StringRecord), TableProblem>> {
    let reader = ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(Trim::All)
        .from_reader(text.as_bytes());
    let records: StringRecordsIntoIter<&[u8]> = reader.into_records();
    records.filter_map(move |record| match record {
        Ok(record) if record.iter().all(str::is_empty) && record.len() < 2 => None,
        Ok(record) => Some(Ok((start_line(text, &record), record))),
        Err(error) => Some(Err(wrong(error.to_string(), "correct the CSV file"))),
    })
}

/// A record's position is the position of the blank lines before it.
fn start_line(text: &str, record: &StringRecord) -> usize {
    let position = record.position();
    let [line, byte] = position.map_or([1, 0], |at| [at.line(), at.byte()]);
    let [line, byte] = [line, byte].map(|n| usize::try_from(n).unwrap_or(usize::MAX));
    let rest = text.get(byte..).unwrap_or_default();
    let blank = rest.bytes().take_while(|b| matches!(b, b'\r' | b'\n'));
    line + blank.filter(|b| *b == b'\n').count()
}

fn position(header: &StringRecord, name: &str) -> Option<usize> {
    header.iter().position(|field| plain(field) == name)
}

/// Removes quotes that a leading space has preserved.
fn plain(field: &str) -> &str {
    field.trim_matches('"').trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn accepts_columns_in_any_order() {
        let text = "\u{feff}b,\"a\", c\r\n1, x ,2\r\n\r\n3\r\n";
        let rows = rows(text, ["a", "b"]).unwrap();
        assert_eq!(
            (rows[0].line, rows[0].fields.each_ref().map(String::as_str)),
            (2, ["x", "1"])
        );
        assert_eq!(
            (rows[1].line, rows[1].fields.each_ref().map(String::as_str)),
            (4, ["", "3"])
        );
        assert_eq!(rows[0].number(1).unwrap(), 1.0);
        assert!(rows[0].number(0).unwrap_err().what.contains("line 2: a: \"x\""));
        assert!(has_column(text, "c") && !has_column(text, "d") && !has_column("", "a"));
    }

    #[test]
    fn quoted_fields_may_contain_commas() {
        let rows = rows("file,distance_m\n\"a,b\",1.5\n\"c\",2\n", ["file", "distance_m"]).unwrap();
        assert_eq!(rows[0].fields, ["a,b", "1.5"]);
        assert_eq!((rows[1].line, rows[1].number(1).unwrap()), (3, 2.0));
    }

    #[test]
    fn rejects_too_many_rows() {
        let long = format!("a\n{}", "1\n".repeat(MAX_ROWS + 1));
        assert!(rows(&long, ["a"]).is_err());
    }
}
