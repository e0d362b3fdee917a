//! `cargo xtask test`: runs every check of the project as a step, and continues after a failure.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::thread;

use crate::counts::{self, Counts};
use crate::docs;
use crate::python::{
    self, BARE, BLENDER, ENVIRONMENTS, Environment, Interpreter, PACKAGE, PEERS, RENDER, Readiness, TORCH,
};
use crate::report::TestReport;
use crate::{targets, web, workflows, workspace};

/// The variable that names the folder of the public test data.
const TEST_DATA: &str = "OAKTWIN_TEST_DATA";

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Formatter, clippy and the Rust tests only, without the tests of every model and option (`exhaustive_…`) and with fewer random
    /// cases: under 3 minutes on two cores from a warm target
    #[arg(long, conflicts_with_all = ["all", "portable"])]
    fast: bool,
    /// Also run the slow tests (`slow_…` in Rust, `slow` in Python), --portable, and `PyTorch` and Blender
    #[arg(long)]
    all: bool,
    /// Also run the Rust tests with the scalar twins of all vector code
    #[arg(long)]
    portable: bool,
    /// Also check that everything compiles for the other systems whose standard libraries are installed
    #[arg(long)]
    targets: bool,
    /// Skip the Python oracles
    #[arg(long)]
    skip_python: bool,
}

/// The programs that the Python tests and the page run, and the native module of the Python package.
struct Built {
    oaktwin: PathBuf,
    camera_eval: PathBuf,
    depth_eval: PathBuf,
    scene_dump: PathBuf,
    module: PathBuf,
}

/// Runs the steps; the last line it prints is `N passed, N failed, N skipped`.
pub(crate) fn run(args: &Args) -> ExitCode {
    let mut report = TestReport::default();
    let skip_python = args.skip_python || args.fast;
    // Downloads take most of the time, so this runs beside the Rust steps.
    let wanted = wanted(args);
    let environments = (!skip_python).then(|| thread::spawn(move || prepare_environments(&wanted)));
    let built = rust_steps(&mut report, args);
    match environments {
        None if args.fast => report.skip("docs, Python oracles, page", "--fast"),
        None => report.skip("Python oracles", "--skip-python"),
        Some(environments) => match environments.join() {
            Ok(environments) => python_steps(&mut report, args, built.as_ref(), environments),
            Err(_) => {
                report.step("Python environments", || {
                    Err::<(), _>("the thread that makes them panicked".into())
                });
            }
        },
    }
    if args.targets {
        targets::steps(&mut report);
    }
    if !args.fast {
        workflows::steps(&mut report);
        web::steps(&mut report, built.as_ref().map(|built| &*built.oaktwin));
    }
    report.finish()
}

/// Returns what the other steps run, if it was built.
fn rust_steps(report: &mut TestReport, args: &Args) -> Option<Built> {
    let no_tests: fn(&str) -> Option<Counts> = |_| None;
    report.command(
        "format",
        workspace::cargo().args(["fmt", "--all", "--check"]),
        no_tests,
    );
    let clippy = ["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"];
    report.command("clippy", workspace::cargo().args(clippy), no_tests);
    if !args.fast {
        let doc = ["doc", "--workspace", "--no-deps"];
        report.command(
            "docs",
            workspace::cargo().args(doc).env("RUSTDOCFLAGS", "-D warnings"),
            no_tests,
        );
    }
    // The fast tests run nothing else, and `cargo test` builds them.
    let built = match args.fast {
        true => None,
        false => Some(report.step("build", build)?),
    };
    report.command("Rust tests", &mut rust_tests(args, &[]), counts::of_cargo_test);
    if args.all || args.portable {
        report.command(
            "Rust tests without vector instructions",
            &mut rust_tests(args, &["--features", "oaktwin-simd/portable"]),
            counts::of_cargo_test,
        );
    }
    if args.all {
        let mut slow = workspace::cargo();
        slow.args(["test", "--workspace", "--no-fail-fast", "--tests"]);
        slow.args(["--", "--ignored", "slow_"]);
        report.command("slow Rust tests", &mut slow, counts::of_filtered_cargo_test);
        let mut rrd = workspace::cargo();
        rrd.args(["test", "--locked", "--manifest-path", "rrd/Cargo.toml"]);
        report.command("recordings for Rerun", &mut rrd, counts::of_cargo_test);
    }
    built
}

/// Returns the command for all Rust tests but the slow ones, and the exhaustive ones if they have to be fast. Tests that need
/// the public test data run, and have to find it, if [`TEST_DATA`] is set; otherwise they count as skipped.
fn rust_tests(args: &Args, features: &[&str]) -> Command {
    let mut test = workspace::cargo();
    test.args(["test", "--workspace", "--no-fail-fast"]);
    test.args(features);
    if args.fast {
        // Each documentation test is a separate program to compile.
        test.arg("--tests");
        // A quarter of the default.
        test.env("PROPTEST_CASES", "64");
    }
    test.arg("--");
    if std::env::var_os(TEST_DATA).is_some() {
        test.args(["--include-ignored", "--skip", "slow_"]);
    }
    if args.fast {
        test.args(["--skip", "exhaustive_"]);
    }
    test
}

/// Returns the environments to test in.
fn wanted(args: &Args) -> Vec<&'static Environment> {
    let mut wanted: Vec<_> = ENVIRONMENTS.iter().collect();
    wanted.extend([&PEERS, &BARE]);
    if args.all {
        wanted.extend([&TORCH, &RENDER, &BLENDER]);
    }
    wanted
}

fn prepare_environments(wanted: &[&'static Environment]) -> Vec<(&'static Environment, Readiness)> {
    let interpreters = Interpreter::find_all();
    wanted
        .iter()
        .map(|environment| (*environment, environment.readiness(&interpreters)))
        .collect()
}

fn python_steps(
    report: &mut TestReport,
    args: &Args,
    built: Option<&Built>,
    environments: Vec<(&'static Environment, Readiness)>,
) {
    // Packed once, in the first environment that has what it is packed with.
    let mut wheel = None;
    for (environment, readiness) in environments {
        let kind = if environment.has_package() {
            "package"
        } else {
            "oracles"
        };
        let name = format!("Python {kind}, {}", environment.name);
        let (python, built) = match (readiness, built) {
            (Readiness::Skipped(reason), _) => {
                report.skip(&name, reason);
                continue;
            }
            (Readiness::Failed(message), _) => {
                report.step(&name, || Err::<(), _>(message));
                continue;
            }
            (Readiness::Ready(_), None) => {
                report.skip(&name, "the programs were not built");
                continue;
            }
            (Readiness::Ready(python), Some(built)) => (python, built),
        };
        if environment.has_package() && !install(report, environment, &python, &built.module, &mut wheel) {
            continue;
        }
        if environment.name == BARE.name {
            let mut script = interpreter(&python);
            // Isolated: neither this checkout's packages nor the user's.
            script.arg("-I").args(environment.tests);
            report.command(&name, &mut script, counts::of_pytest);
        } else {
            let mut tests = pytest(&python, environment.tests, built, args);
            report.command(&name, &mut tests, pytest_counts());
        }
        let has_pdoc = [PACKAGE.name, PEERS.name].contains(&environment.name);
        if has_pdoc {
            report.step("manual", || docs::build(&python));
        }
    }
}

/// Installs the package in an environment, and returns whether that succeeded.
fn install(
    report: &mut TestReport,
    environment: &Environment,
    python: &Path,
    module: &Path,
    wheel: &mut Option<PathBuf>,
) -> bool {
    let installed = report.step(
        &format!("wheel of the Python package, {}", environment.name),
        || {
            let built = match wheel.take() {
                Some(built) => built,
                None if environment.name == BARE.name => return Err("it was not packed".to_owned()),
                None => python::pack_wheel(python, module)?,
            };
            python::install_wheel(python, wheel.insert(built))
        },
    );
    installed.is_some()
}

/// Returns the function that counts pytest's results. If the public test data are set, a test that was skipped because it did
/// not find them counts as failed.
fn pytest_counts() -> fn(&str) -> Option<Counts> {
    if std::env::var_os(TEST_DATA).is_some() {
        |line| counts::of_pytest(line).or_else(|| counts::of_data_skipped_by_pytest(line, TEST_DATA))
    } else {
        counts::of_pytest
    }
}

/// Builds the tests and what the other steps run at once, because cargo chooses the features of all packages of one build together:
/// in several builds, most of them would be compiled several times.
fn build() -> Result<Built, String> {
    let mut built = workspace::build(&["--workspace", "--lib", "--bins", "--tests", "--examples"])?;
    let mut take = |name| built.remove(name).ok_or(format!("cargo built no {name}"));
    Ok(Built {
        oaktwin: take("oaktwin")?,
        camera_eval: take("camera-eval")?,
        depth_eval: take("depth-eval")?,
        scene_dump: take("scene-dump")?,
        module: take(workspace::MODULE)?,
    })
}

/// Returns a pinned environment's interpreter, isolated from the user's own Python.
fn interpreter(python: &Path) -> Command {
    let mut command = python::isolated(python);
    command
        .current_dir(workspace::root())
        .env("PYTHONDONTWRITEBYTECODE", "1");
    command
}

fn pytest(python: &Path, tests: &[&str], built: &Built, args: &Args) -> Command {
    let mut command = interpreter(python);
    command.args([
        "-m",
        "pytest",
        "--quiet",
        "-rs",
        "--color=no",
        "-p",
        "no:cacheprovider",
    ]);
    command.args(tests);
    // The tests of a file stay together: they share what is made once.
    command.args([
        "--numprocesses",
        "auto",
        "--maxprocesses",
        "8",
        "--dist",
        "loadfile",
    ]);
    // Copies of the documentation's inputs would fill gigabytes.
    command.args(["-o", "tmp_path_retention_policy=failed"]);
    if args.all {
        command.arg("--slow");
    }
    command.env("OAKTWIN_BIN", &built.oaktwin);
    command.env("OAKTWIN_CAMERA_EVAL", &built.camera_eval);
    command.env("OAKTWIN_DEPTH_EVAL", &built.depth_eval);
    command.env("OAKTWIN_SCENE_DUMP", &built.scene_dump);
    command
}
