//! Depth frames of this project's backends beside Embree's, Open3D's and Mitsuba's: same triangles, same rays, same
//! number of threads, in turns.
//!
//! Every engine is a process of its own, so that its memory is its own and its threads rest while others work; all
//! speak [`protocol`]. `cargo xtask bench render` runs this program with the Python environment that it makes; alone,
//! `render-bench --no-python` compares with Embree, and `render-bench profile raster plane` renders one scene in this
//! very process, for profilers.

#![expect(
    clippy::print_stdout,
    reason = "a program for people: its output is what it is for"
)]

mod contest;
#[cfg(target_os = "linux")]
mod embree;
mod engine;
mod ours;
mod protocol;
mod scenes;
mod table;
mod triangles;
mod worker;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(name = "render-bench", about = "Depth frames beside other engines'")]
struct Args {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    contest: contest::Args,
}

#[derive(Subcommand)]
enum Command {
    /// Render one scene again and again in this process, for a profiler
    Profile {
        /// raster, ray, embree
        engine: String,
        /// The scene's name
        scene: String,
        /// How many frames
        #[arg(long, default_value_t = 20)]
        frames: usize,
        /// How many threads
        #[arg(long, default_value_t = 1)]
        threads: usize,
        /// For Embree's library and the chess set's triangles, as without a command
        #[command(flatten)]
        places: contest::Places,
    },
    /// Be an engine: commands come by standard input
    #[command(hide = true)]
    Worker {
        /// Which
        engine: String,
        /// Embree's library
        #[arg(long)]
        library: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    let args = Args::parse();
    let result = match args.command {
        None => contest::run(&args.contest),
        Some(Command::Worker { engine, library }) => worker::serve(&engine, library.as_deref()),
        Some(Command::Profile {
            engine,
            scene,
            frames,
            threads,
            places,
        }) => worker::profile(&engine, &scene, frames, threads, &places),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            println!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
