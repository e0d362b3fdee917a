//! The page of `oaktwin studio`: `cargo xtask web` bundles it, and the tests compare the bundle and open it in a browser.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use crate::counts;
use crate::report::TestReport;
use crate::workspace::{self, output};

/// The files of the bundle.
const BUNDLE: [&str; 4] = ["index.html", "licenses.txt", "studio.css", "studio.js"];

/// The folder of the committed bundle. It is inside the crate that serves it, so that the published crate contains it.
const COMMITTED: &str = "crates/studio/dist";

/// The browsers that the page is tested in, and a variable that names another one.
const BROWSERS: [&str; 3] = [
    "/usr/bin/chromium",
    "/usr/bin/chromium-browser",
    "/usr/bin/google-chrome",
];
const BROWSER: &str = "OAKTWIN_BROWSER";

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Also take the manual's picture of the page, in a browser
    #[arg(long)]
    pictures: bool,
}

/// Installs what the page is built with, checks its types, and bundles it.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let dist = committed();
    bundle(&dist)?;
    for name in BUNDLE {
        let path = dist.join(name);
        let bytes = std::fs::metadata(&path)
            .map_err(|error| format!("{}: {error}", path.display()))?
            .len();
        println!("{}: {bytes} bytes", path.display());
    }
    if args.pictures {
        let program = workspace::oaktwin("dev")?;
        let server = Server::of(&program)?;
        let mut pictures = npm(&["run", "pictures", "--"]);
        pictures.arg(workspace::root().join("docs/images"));
        output(pictures.env("OAKTWIN_STUDIO_URL", &server.link))?;
    }
    Ok(())
}

/// Checks that the committed bundle is what the sources build, and tests the page in a browser.
pub(crate) fn steps(report: &mut TestReport, program: Option<&Path>) {
    if Command::new("npm").arg("--version").output().is_err() {
        return report.skip("page", "npm is not installed");
    }
    if report.step("bundle of the page", is_committed).is_none() {
        return;
    }
    let Some(browser) = browser() else {
        let reason = format!("no Chromium is installed; {BROWSER} can name one");
        return report.skip("page in a browser", reason);
    };
    let Some(program) = program else {
        return report.skip("page in a browser", "the program was not built");
    };
    let Some(server) = report.step("server of the page", || Server::of(program)) else {
        return;
    };
    let mut tests = npm(&["test"]);
    tests
        .env("OAKTWIN_STUDIO_URL", &server.link)
        .env(BROWSER, browser);
    report.command("page in a browser", &mut tests, counts::of_node_test);
}

fn folder() -> PathBuf {
    workspace::root().join("web")
}

fn committed() -> PathBuf {
    workspace::root().join(COMMITTED)
}

pub(crate) fn npm(arguments: &[&str]) -> Command {
    npm_in(&folder(), arguments)
}

fn npm_in(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new("npm");
    command.args(arguments).current_dir(folder);
    command
}

/// Installs what the page is built and tested with.
pub(crate) fn install() -> Result<(), String> {
    install_pinned(&folder())
}

/// Installs what the lock file of a folder pins, without running scripts of packages.
pub(crate) fn install_pinned(folder: &Path) -> Result<(), String> {
    let arguments = ["ci", "--ignore-scripts", "--no-audit", "--no-fund"];
    output(&mut npm_in(folder, &arguments)).map(drop)
}

fn bundle(dist: &Path) -> Result<(), String> {
    install()?;
    output(&mut npm(&["run", "check"]))?;
    let mut build = npm(&["run", "build", "--"]);
    output(build.arg(dist))?;
    Ok(())
}

/// Returns an error if the committed bundle is not what the sources build.
fn is_committed() -> Result<(), String> {
    let built = workspace::target().join("web");
    bundle(&built)?;
    for name in BUNDLE {
        let read = |folder: &Path| {
            let path = folder.join(name);
            std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))
        };
        if read(&built)? != read(&committed())? {
            return Err(format!(
                "{COMMITTED}/{name} is not what the sources build; run cargo xtask web and commit it"
            ));
        }
    }
    Ok(())
}

fn browser() -> Option<PathBuf> {
    let named = std::env::var_os(BROWSER).map(PathBuf::from);
    let known = BROWSERS.iter().map(PathBuf::from).find(|path| path.exists());
    named.or(known)
}

/// A running server, which stops when it is dropped.
pub(crate) struct Server {
    child: Child,
    pub(crate) link: String,
}

impl Server {
    /// Starts a program's server and waits for its link.
    pub(crate) fn of(program: &Path) -> Result<Self, String> {
        let mut command = Command::new(program);
        command
            .args(["studio", "--no-open"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null());
        let mut child = command
            .spawn()
            .map_err(|error| format!("{}: {error}", program.display()))?;
        let mut link = String::new();
        let read = child
            .stdout
            .take()
            .map(|out| BufReader::new(out).read_line(&mut link));
        let server = Self {
            child,
            link: link.trim().to_owned(),
        };
        match read {
            Some(Ok(length)) if length > 0 => Ok(server),
            _ => Err(format!("{}: printed no link", program.display())),
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
