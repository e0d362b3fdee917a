//! `cargo xtask fuzz`: runs libFuzzer on the targets of the crate `oaktwin-fuzz`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::{Value, json};

use crate::workspace::{self, check, output, root};

/// The options of libFuzzer: the limits on the memory and the time of one input, and its reports.
const FLAGS: [&str; 5] = [
    "-rss_limit_mb=2048",
    "-timeout=25",
    "-print_final_stats=1",
    "-verbosity=1",
    "-use_value_profile=0",
];

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Only these targets [default: all]
    target: Vec<String>,
    /// Duration of all targets together
    #[arg(long, default_value_t = 10.0)]
    minutes: f64,
    /// List the targets and what they check
    #[arg(long)]
    list: bool,
    /// Replace the corpora in the repository by the smallest ones with the same coverage
    #[arg(long)]
    minimize: bool,
    /// Build with this sanitizer, such as `address`, which halves the speed; for changes of unsafe code
    #[arg(long, default_value = "none")]
    sanitizer: String,
    /// Folder for the build
    #[arg(long)]
    target_dir: Option<PathBuf>,
}

struct FuzzTarget {
    name: String,
    max_len: String,
    about: String,
}

/// The outcome of a target.
#[derive(Debug, Default, PartialEq)]
struct Outcome {
    executions: u64,
    edges: u64,
    corpus: usize,
    /// What was found, and the file that reproduces it.
    finding: Option<String>,
}

/// Fuzzes, prints a table, and writes it below the target folder. An error if an input broke a promise.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let work = workspace::target().join("fuzz");
    let seeds = work.join("seeds");
    let targets = targets(&seeds)?;
    if args.list {
        for target in &targets {
            println!("{:<14} {}", target.name, target.about);
        }
        return Ok(());
    }
    let chosen = choose(&targets, &args.target)?;
    installed()?;
    let build = args.target_dir.clone().unwrap_or_else(|| work.join("build"));
    let mut cargo = fuzzer("build", &build);
    cargo.args(["--sanitizer", &args.sanitizer]);
    if let [only] = args.target.as_slice() {
        cargo.arg(only);
    }
    check(&mut cargo)?;
    let seconds = args.minutes * 60.0 / chosen.len() as f64;
    let mut rows = Vec::new();
    for target in chosen {
        println!("\n-- {}: {}", target.name, target.about);
        let outcome = fuzz(target, seconds, &work, &build)?;
        if args.minimize {
            minimize(target, &work, &build)?;
        }
        rows.push((target, outcome));
    }
    report(&rows, seconds, &work)
}

/// Builds the program that lists the targets and writes their seeds.
fn targets(seeds: &Path) -> Result<Vec<FuzzTarget>, String> {
    let program = workspace::build_program("fuzz-targets", &["--workspace", "--quiet"])?;
    let listed = output(Command::new(program).arg(seeds))?;
    let target = |line: &str| {
        let mut fields = line.splitn(3, '\t').map(str::to_owned);
        Some(FuzzTarget {
            name: fields.next()?,
            max_len: fields.next()?,
            about: fields.next()?,
        })
    };
    Ok(listed.lines().filter_map(target).collect())
}

fn choose<'a>(targets: &'a [FuzzTarget], names: &[String]) -> Result<Vec<&'a FuzzTarget>, String> {
    if names.is_empty() {
        return Ok(targets.iter().collect());
    }
    let find = |name: &String| {
        let found = targets.iter().find(|target| target.name == *name);
        found.ok_or_else(|| {
            let known: Vec<&str> = targets.iter().map(|target| target.name.as_str()).collect();
            format!("there is no target '{name}'; choose from {}", known.join(", "))
        })
    };
    names.iter().map(find).collect()
}

/// Checks that the nightly toolchain and cargo-fuzz are installed.
fn installed() -> Result<(), String> {
    let runs = |arguments: &[&str]| {
        let mut command = Command::new("cargo");
        command
            .args(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    if !runs(&["+nightly", "--version"]) {
        return Err("fuzzing requires the nightly toolchain; run: rustup toolchain install nightly".into());
    }
    if !runs(&["fuzz", "--version"]) {
        return Err("fuzzing requires cargo-fuzz; run: cargo install --locked cargo-fuzz".into());
    }
    Ok(())
}

/// Returns `cargo +nightly fuzz TASK`.
fn fuzzer(task: &str, build: &Path) -> Command {
    let mut command = Command::new("cargo");
    command
        .current_dir(root())
        .args(["+nightly", "fuzz", task, "--target-dir"])
        .arg(build);
    // The variables of the toolchain that runs xtask.
    for variable in ["CARGO", "RUSTC", "RUSTUP_TOOLCHAIN", "RUSTFLAGS"] {
        command.env_remove(variable);
    }
    command
}

/// The folders with inputs: the first receives new ones.
fn corpora(target: &FuzzTarget, work: &Path) -> Result<Vec<PathBuf>, String> {
    let growing = work.join("corpus").join(&target.name);
    fs::create_dir_all(&growing).map_err(|error| format!("{}: {error}", growing.display()))?;
    let kept = ["corpus", "regressions"].map(|folder| root().join("fuzz").join(folder).join(&target.name));
    let all = [growing, work.join("seeds").join(&target.name)]
        .into_iter()
        .chain(kept);
    Ok(all.filter(|folder| folder.is_dir()).collect())
}

fn fuzz(target: &FuzzTarget, seconds: f64, work: &Path, build: &Path) -> Result<Outcome, String> {
    let artifacts = work.join("artifacts").join(&target.name);
    fs::create_dir_all(&artifacts).map_err(|error| format!("{}: {error}", artifacts.display()))?;
    let corpora = corpora(target, work)?;
    let log = work.join(format!("{}.log", target.name));
    let stderr = fs::File::create(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    let mut command = Command::new(program(target, build)?);
    command.args(FLAGS).arg(format!("-max_len={}", target.max_len));
    command.arg(format!("-max_total_time={}", seconds.max(1.0).round()));
    command.arg(format!("-artifact_prefix={}/", artifacts.display()));
    command.args(&corpora).stdout(Stdio::null()).stderr(stderr);
    let status = command
        .status()
        .map_err(|error| format!("{}: {error}", workspace::shown(&command)))?;
    let text = fs::read(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    let text = String::from_utf8_lossy(&text);
    let mut outcome = parse(&text);
    outcome.corpus = corpora
        .iter()
        .map(|folder| fs::read_dir(folder).map_or(0, Iterator::count))
        .sum();
    if !status.success() {
        outcome.finding = Some(keep(target, &text)?);
    }
    Ok(outcome)
}

/// Returns the program that cargo-fuzz built.
fn program(target: &FuzzTarget, build: &Path) -> Result<PathBuf, String> {
    let folders = fs::read_dir(build).map_err(|error| format!("{}: {error}", build.display()))?;
    let mut programs = folders
        .flatten()
        .map(|folder| folder.path().join("release").join(&target.name));
    let found = programs.find(|program| program.is_file());
    found.ok_or_else(|| {
        format!(
            "{}: cargo fuzz built no program named {}",
            build.display(),
            target.name
        )
    })
}

/// Reads the numbers of executions and edges from libFuzzer's log.
fn parse(log: &str) -> Outcome {
    let number = |text: &str| text.split_whitespace().next()?.parse().ok();
    let mut outcome = Outcome::default();
    for line in log.lines() {
        if let Some(count) = line.strip_prefix("stat::number_of_executed_units:") {
            outcome.executions = number(count).unwrap_or(0);
        } else if let Some((_, rest)) = line.split_once(" cov: ") {
            outcome.edges = number(rest).unwrap_or(0);
            // `#1234  NEW  cov: 56 …`: all there is if the run ends with a crash.
            let so_far = line.strip_prefix('#').and_then(number).unwrap_or(0);
            outcome.executions = outcome.executions.max(so_far);
        }
    }
    outcome
}

/// Copies the input of a crash to the regressions. Returns what was found, and the path of the copy.
fn keep(target: &FuzzTarget, log: &str) -> Result<String, String> {
    let what = problem(log);
    let Some(artifact) = log
        .lines()
        .find_map(|line| line.split_once("Test unit written to "))
    else {
        let last: Vec<&str> = log.lines().rev().take(5).collect();
        return Ok(format!("{what}; no input was saved: {}", last.join(" | ")));
    };
    let artifact = Path::new(artifact.1.trim());
    let hash = artifact.file_name().unwrap_or_default().to_string_lossy();
    let hash = hash.rsplit('-').next().unwrap_or_default();
    let folder = root().join("fuzz/regressions").join(&target.name);
    let file = folder.join(format!("{}-{}", slug(&what), &hash[..hash.len().min(8)]));
    let copied = fs::create_dir_all(&folder).and_then(|()| fs::copy(artifact, &file));
    copied.map_err(|error| format!("{}: {error}", file.display()))?;
    Ok(format!("{what}: {}", file.display()))
}

/// Returns the message of a panic, or what libFuzzer or the sanitizer reported.
fn problem(log: &str) -> String {
    let mut lines = log.lines();
    while let Some(line) = lines.next() {
        if line.contains("panicked at ") {
            return lines.next().unwrap_or(line).trim().to_owned();
        }
        if let Some((_, report)) = line.split_once("ERROR: ") {
            return report.trim().to_owned();
        }
    }
    "ended without a report".to_owned()
}

/// Returns the first words of a message as a part of a file name.
fn slug(message: &str) -> String {
    // The name of a temporary file says nothing.
    let message = match message.split_once(": ") {
        Some((path, rest)) if path.starts_with('/') => rest,
        _ => message,
    };
    let mut words = message
        .split(|c: char| !c.is_ascii_alphanumeric())
        .filter(|word| !word.is_empty());
    let first: Vec<String> = words.by_ref().take(8).map(str::to_ascii_lowercase).collect();
    first.join("-").chars().take(60).collect()
}

/// Replaces the corpus in the repository by the smallest one with the same coverage.
fn minimize(target: &FuzzTarget, work: &Path, build: &Path) -> Result<(), String> {
    let merged = work.join("merged").join(&target.name);
    let _ = fs::remove_dir_all(&merged);
    fs::create_dir_all(&merged).map_err(|error| format!("{}: {error}", merged.display()))?;
    let mut command = Command::new(program(target, build)?);
    command
        .args(FLAGS)
        .arg(format!("-max_len={}", target.max_len))
        .arg("-set_cover_merge=1")
        .arg(&merged);
    check(
        command
            .args(corpora(target, work)?)
            .stdout(Stdio::null())
            .stderr(Stdio::null()),
    )?;
    let kept = root().join("fuzz/corpus").join(&target.name);
    let _ = fs::remove_dir_all(&kept);
    fs::create_dir_all(&kept).map_err(|error| format!("{}: {error}", kept.display()))?;
    for entry in fs::read_dir(&merged)
        .map_err(|error| format!("{}: {error}", merged.display()))?
        .flatten()
    {
        let copy = kept.join(entry.file_name());
        fs::copy(entry.path(), &copy).map_err(|error| format!("{}: {error}", copy.display()))?;
    }
    Ok(())
}

#[expect(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "for reading"
)]
fn report(rows: &[(&FuzzTarget, Outcome)], seconds: f64, work: &Path) -> Result<(), String> {
    println!(
        "\n{:<14} {:>12} {:>9} {:>7} {:>7}  findings",
        "target", "executions", "per s", "edges", "corpus"
    );
    let mut json = Vec::new();
    for (target, outcome) in rows {
        let per_second = (outcome.executions as f64 / seconds) as u64;
        let finding = outcome.finding.as_deref().unwrap_or("none");
        println!(
            "{:<14} {:>12} {:>9} {:>7} {:>7}  {finding}",
            target.name, outcome.executions, per_second, outcome.edges, outcome.corpus
        );
        json.push(json!({
            "target": target.name, "executions": outcome.executions, "seconds": seconds,
            "edges": outcome.edges, "corpusFiles": outcome.corpus, "finding": outcome.finding,
        }));
    }
    let path = work.join("report.json");
    let text = format!("{:#}\n", Value::from(json));
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("\n{}", path.display());
    match rows
        .iter()
        .filter(|(_, outcome)| outcome.finding.is_some())
        .count()
    {
        0 => Ok(()),
        count => Err(format!(
            "{count} targets found an input that breaks a promise; it is in fuzz/regressions: correct the library, then run cargo test -p oaktwin-fuzz"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_log() {
        let log =
            "#2\tINITED cov: 10 ft: 11\n#4096\tpulse  cov: 57 ft: 90\nstat::number_of_executed_units: 5000\n";
        let read = parse(log);
        assert_eq!((read.executions, read.edges), (5000, 57));
        assert_eq!(parse("#64\tNEW    cov: 57 ft: 90\n").executions, 64);
    }

    #[test]
    fn names_a_crash_by_its_message() {
        let panic = "thread panicked at src/a.rs:1:2:\nindex out of bounds: the len is 3\n==1== ERROR: libFuzzer: deadly signal";
        assert_eq!(slug(&problem(panic)), "index-out-of-bounds-the-len-is-3");
        let file = "/tmp/.tmp0/x.usda: line 4: contains a zero byte";
        assert_eq!(slug(file), "line-4-contains-a-zero-byte");
        let leak = "==1==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x1";
        assert!(slug(&problem(leak)).starts_with("addresssanitizer-heap-buffer-overflow"));
    }
}
