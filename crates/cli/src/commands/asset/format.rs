use oaktwin::usd::asset::Format;

use crate::args::AssetArgs;
use crate::context::Result;
use crate::destination;

/// Returns the format from `--format`, else from the output's extension.
pub(super) fn of(args: &AssetArgs) -> Result<Format> {
    let requested = args.format;
    if destination::names_folder(&args.output) {
        return Ok(requested.unwrap_or_default());
    }
    let extension = args.output.extension().and_then(|e| e.to_str());
    let from_name = extension.and_then(|e| {
        [Format::Usda, Format::Usd, Format::Usdz]
            .into_iter()
            .find(|f| f.extension() == e)
    });
    let path = args.output.display();
    match (requested, from_name, extension) {
        (Some(requested), Some(from_name), _) if requested != from_name => Err(format!(
            "{path}: --format {} contradicts the extension; omit one of them",
            requested.extension()
        )
        .into()),
        (None, None, Some(extension)) => Err(format!(
            "{path}: .{extension} is not a USD format; use .usda, .usd or .usdz, or give --format",
        )
        .into()),
        _ => Ok(requested.or(from_name).unwrap_or_default()),
    }
}
