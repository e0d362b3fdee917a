use oaktwin::catalog::compare;

use crate::args::{CompareArgs, TableFormat};
use crate::context::{Context, Exit, Result};
use crate::output;

pub(crate) fn run(context: &Context, args: &CompareArgs) -> Result<Exit> {
    let tables = compare(&context.catalog, &context.devices(&args.models)?);
    match args.format {
        TableFormat::Json => output::print_json(&tables)?,
        TableFormat::Text => {
            output::print(
                &tables
                    .iter()
                    .map(output::text_table)
                    .collect::<Vec<_>>()
                    .join("\n"),
            )?;
        }
        TableFormat::Markdown => {
            output::print(
                &tables
                    .iter()
                    .map(output::markdown_table)
                    .collect::<Vec<_>>()
                    .join("\n"),
            )?;
        }
    }
    Ok(Exit::Success)
}
