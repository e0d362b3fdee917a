//! Frames that are made by Ray, with the Python package.

use std::path::absolute;

use oaktwin::generate::Generation;
use oaktwin::progress::{Progress, Watch};
use serde_json::json;

use super::python::Python;
use crate::args::GenerateArgs;
use crate::context::{Context, Result};

/// Makes the missing frames on the cluster at an address.
pub(super) fn make(
    context: &Context,
    args: &GenerateArgs,
    address: &str,
    generation: &mut Generation,
    watch: &Watch<'_>,
) -> Result<()> {
    let total = generation.total();
    if total == 0 {
        return Ok(());
    }
    let request = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "job": {
            "recipe": args.recipe.as_deref().map(absolute).transpose()?,
            "output": args.output.as_deref().map(absolute).transpose()?,
            "formats": (!args.formats.is_empty()).then_some(&args.formats),
            "seed": args.seed,
            "save_scenes": args.save_scenes,
            "catalog": context.catalog_folder.as_deref().map(absolute).transpose()?,
        },
        "address": address,
        "workers": args.workers,
        "batches": generation.batches().iter().map(|batch| (batch.start, batch.end)).collect::<Vec<_>>(),
    });
    let mut python = Python::start(&format!("{request}\n"))?;
    let mut done = 0;
    loop {
        if watch(Progress { done, total }).is_break() {
            generation.interrupt();
            return Ok(());
        }
        if done == total {
            // Ray is shut down.
            python.process.wait()?;
            return Ok(());
        }
        if let Some(batch) = python.next()? {
            generation.add(&batch)?;
            done += batch.end - batch.start;
        }
    }
}
