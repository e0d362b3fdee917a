//! Creates and writes all five assets repeatedly and prints the seconds of each run: `cargo xtask bench assets`
//! compares it with a Python script that does the same with `OpenUSD`.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

use oaktwin::catalog::Catalog;
use oaktwin::usd::asset::{AssetOptions, Format, files};

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = std::env::args_os().skip(1);
    let usage = "usage: time_assets DIR RUNS";
    let folder = PathBuf::from(args.next().ok_or(usage)?);
    let runs: u32 = args
        .next()
        .and_then(|runs| runs.to_str()?.parse().ok())
        .ok_or(usage)?;
    for _ in 0..runs {
        let start = Instant::now();
        write_all(&folder)?;
        println!("{:.6}", start.elapsed().as_secs_f64());
    }
    Ok(())
}

fn write_all(folder: &Path) -> Result<(), Box<dyn Error>> {
    let catalog = Catalog::builtin();
    let twins: Vec<_> = catalog.sheet().map(|device| catalog.nominal(device)).collect();
    for file in files(&twins, &AssetOptions::default(), Format::Usd)? {
        std::fs::write(folder.join(file.name), file.bytes)?;
    }
    Ok(())
}
