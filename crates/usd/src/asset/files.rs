use std::thread;

use oaktwin_base::diagnostic::Finding;
use oaktwin_catalog::Twin;

use super::{AssetError, AssetOptions, Format, asset};

/// The file of an asset, ready to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct AssetFile {
    /// The file name, such as `oak_d_pro_poe.usd`.
    pub name: String,
    /// The content.
    pub bytes: Vec<u8>,
    /// Notes and warnings about the asset.
    pub findings: Vec<Finding>,
}

/// Returns the asset files of several twins, in their order. Each twin is processed on its own thread.
///
/// # Errors
/// Returns the first twin's error, as [`asset`] does.
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
