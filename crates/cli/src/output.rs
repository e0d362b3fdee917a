//! Standard output, where a closed pipe is not an error, and messages on standard error.

use std::io::{self, Write};
use std::path::Path;

use comfy_table::{CellAlignment, ContentArrangement, ContentLineStyle, LineStyle, TableStyle, presets};
use oaktwin::catalog::TextTable;
use oaktwin::diagnostic::{self, Finding, Opt};
use serde::Serialize;

use crate::context::Result;

/// Prints text to standard output.
pub(crate) fn print(text: &str) -> Result<()> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(not_written(&error)),
        written => Ok(written?),
    }
}

/// Returns the error for a failed write to standard output.
pub(crate) fn not_written(error: &io::Error) -> Box<dyn std::error::Error> {
    format!("standard output: cannot be written ({error}); redirect it elsewhere").into()
}

pub(crate) fn print_json(value: &impl Serialize) -> Result<()> {
    print(&(serde_json::to_string_pretty(value)? + "\n"))
}

/// Prints a value as one line of JSON.
#[cfg(feature = "bridge")]
pub(crate) fn print_json_line(value: &impl Serialize) -> Result<()> {
    print(&(serde_json::to_string(value)? + "\n"))
}

/// Prints a message to standard error, if that is open.
pub(crate) fn say(message: &str) {
    let _ = writeln!(io::stderr(), "{message}");
}

/// Prints findings to standard error, each with the file that it refers to. Findings that differ only in their places share
/// a line.
pub(crate) fn say_findings(file: &Path, findings: &[Finding]) {
    for group in diagnostic::group(findings) {
        say(&format!("{}: {group}", file.display()));
    }
}

/// Formats an option or a command as on the command line: `--fx 500`, `oaktwin models`.
pub(crate) fn flag(option: &Opt) -> String {
    if option.is_command() {
        return format!("`oaktwin {}`", option.name());
    }
    match option.value() {
        Some(value) => format!("--{} {value}", option.name()),
        None => format!("--{}", option.name()),
    }
}

pub(crate) fn is_closed_pipe(error: &(dyn std::error::Error + 'static)) -> bool {
    error
        .downcast_ref::<io::Error>()
        .is_some_and(|e| e.kind() == io::ErrorKind::BrokenPipe)
}

/// Columns separated by two spaces, a line below the header.
const PLAIN: TableStyle = TableStyle::new()
    .header_lines(ContentLineStyle::none().junction(' '))
    .header_separator(LineStyle::none().fill('─').junction('─'))
    .content_lines(ContentLineStyle::none().junction(' '));

/// Formats a table, wrapped to the terminal's width if there is one.
pub(crate) fn text_table(table: &TextTable) -> String {
    let mut drawn = comfy_table::Table::new();
    drawn
        .load_style(PLAIN)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_header(&table.header);
    drawn.add_rows(&table.rows);
    format!("{}\n{}\n", table.title, drawn.trim_fmt())
}

/// Formats a table of numbers: all columns except the last are right-aligned.
pub(crate) fn number_table(table: &TextTable) -> String {
    let mut drawn = comfy_table::Table::new();
    drawn.load_style(PLAIN).set_header(&table.header);
    drawn.add_rows(&table.rows);
    let last = table.header.len().saturating_sub(1);
    for column in drawn.column_iter_mut().take(last) {
        column.set_cell_alignment(CellAlignment::Right);
        column.set_padding((0, 1));
    }
    format!("{}\n{}\n", table.title, drawn.trim_fmt())
}

pub(crate) fn markdown_table(table: &TextTable) -> String {
    let escaped = |cells: &[String]| {
        cells
            .iter()
            .map(|cell| cell.replace('|', "\\|"))
            .collect::<Vec<_>>()
    };
    let mut drawn = comfy_table::Table::new();
    drawn
        .load_style(presets::ASCII_MARKDOWN)
        .set_header(escaped(&table.header));
    drawn.add_rows(table.rows.iter().map(|row| escaped(row)));
    format!("### {}\n\n{drawn}\n", table.title)
}
