//! `cargo xtask`: the tasks of contributors and CI.

#![expect(clippy::print_stdout, reason = "its output is its purpose")]

mod bench;
mod conformance;
mod counts;
mod depthai_examples;
mod docs;
mod fuzz;
mod licenses;
mod processor;
mod python;
mod release;
mod report;
mod schema;
mod soak;
mod targets;
mod test;
mod web;
mod workflows;
mod workspace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(
    name = "cargo xtask",
    bin_name = "cargo xtask",
    about = "Tasks of contributors and CI"
)]
struct Args {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Run the formatter, clippy, docs, Rust tests and Python oracles.
    Test(test::Args),
    /// Compare the speed of this project with a peer's, in one run.
    #[command(subcommand)]
    Bench(bench::Bench),
    /// Compare renderings with Isaac Sim's; exit code 1 if they differ, 2 without the data.
    Conformance(conformance::Args),
    /// Run the examples of a checkout of depthai-core on a virtual device, and print the table of the manual.
    DepthaiExamples(depthai_examples::Args),
    /// Build the manual into target/docs and check its links.
    Docs,
    /// Run the program and the Python package for an hour: memory must stay flat, and results the same.
    Soak(soak::Args),
    /// Fuzz the readers, filters, engines and renderers; exit code 1 if an input breaks a promise.
    Fuzz(fuzz::Args),
    /// Regenerate the JSON schemas and other generated files.
    Schema,
    /// Regenerate the licences that the Python wheel contains.
    Licenses,
    /// Package the published crates and check the archives; without --dry-run, publish them.
    Release(release::Args),
    /// Bundle the page of `oaktwin studio` into crates/studio/dist; requires npm.
    Web(web::Args),
}

fn main() -> ExitCode {
    let result = match Args::parse().task {
        Task::Test(args) => return test::run(&args),
        Task::Conformance(args) => return conformance::run(&args),
        Task::Bench(bench) => bench::run(&bench),
        Task::DepthaiExamples(args) => depthai_examples::run(&args),
        Task::Docs => docs::run(),
        Task::Soak(args) => soak::run(&args),
        Task::Fuzz(args) => fuzz::run(&args),
        Task::Schema => schema::run(),
        Task::Licenses => licenses::run(),
        Task::Release(args) => release::run(&args),
        Task::Web(args) => web::run(&args),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            println!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
