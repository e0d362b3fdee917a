//! Lists the targets for `cargo xtask fuzz`, or writes their seeds into a folder.

#![allow(clippy::print_stdout, reason = "its output is its purpose")]

use std::path::Path;
use std::{fs, io};

use oaktwin_fuzz::TARGETS;

fn main() -> io::Result<()> {
    let folder = std::env::args_os().nth(1);
    for target in TARGETS {
        println!("{}\t{}\t{}", target.name, target.max_len, target.about);
        if let Some(folder) = &folder {
            let folder = Path::new(folder).join(target.name);
            fs::create_dir_all(&folder)?;
            for (number, seed) in (target.seeds)().into_iter().enumerate() {
                fs::write(folder.join(format!("seed-{number}")), seed)?;
            }
        }
    }
    Ok(())
}
