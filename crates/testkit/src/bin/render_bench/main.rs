//! Compares depth frames of this project's backends with Embree's, Open3D's and Mitsuba's: the same triangles, rays and
//! number of threads, alternately.
//!
//! Every engine runs in its own process, so that memory is separate and its threads are idle while others work; all
//! use [`protocol`]. `cargo xtask bench render` runs this program with the Python environment that it creates;
//! `render-bench --no-python` compares with Embree only, and `render-bench profile raster plane` renders one scene in this
//! process, for profilers.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

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
#[command(
    name = "render-bench",
    about = "Benchmark of depth rendering against other engines"
)]
struct Args {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    contest: contest::Args,
}

#[derive(Subcommand)]
enum Command {
    /// Render one scene repeatedly in this process, for a profiler
    Profile {
        /// raster, ray, embree
        engine: String,
        /// The scene's name
        scene: String,
        /// Number of frames
        #[arg(long, default_value_t = 20)]
        frames: usize,
        /// Number of threads
        #[arg(long, default_value_t = 1)]
        threads: usize,
        /// For Embree's library and the chess set's triangles, as without a command
        #[command(flatten)]
        places: contest::Places,
    },
    /// Run an engine that reads commands from standard input
    #[command(hide = true)]
    Worker {
        /// The engine
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
