use std::thread;

use oaktwin_catalog::Twin;
use oaktwin_diagnostic::Finding;

use super::{AssetError, AssetOptions, Format, asset};

/// The file of an asset, not yet written.
#[derive(Clone, Debug, PartialEq)]
pub struct AssetFile {
    /// Its name, `oak_d_pro_poe.usd`.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
    /// What the user should know.
    pub findings: Vec<Finding>,
}

/// The assets' files of several twins, in their order, made side by side on as many threads.
///
/// # Errors
/// As [`asset`]: the first twin's that fails.
pub fn files(twins: &[Twin], options: &AssetOptions, format: Format) -> Result<Vec<AssetFile>, AssetError> {
    thread::scope(|scope| {
        let made: Vec<_> = twins
            .iter()
            .map(|twin| scope.spawn(move || file(twin, options, format)))
            .collect();
        made.into_iter()
            .map(|made| {
                made.join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            })
            .collect()
    })
}

fn file(twin: &Twin, options: &AssetOptions, format: Format) -> Result<AssetFile, AssetError> {
    let made = asset(twin, options)?;
    Ok(AssetFile {
        name: made.file_name(format),
        bytes: made.bytes(format)?,
        findings: made.findings,
    })
}
