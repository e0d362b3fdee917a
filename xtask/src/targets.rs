//! Whether the workspace compiles for other systems than this one.

use std::process::Command;

use crate::report::TestReport;
use crate::workspace;

/// A target, and the C compiler that the crate `zstd-sys` needs for it.
struct Triple {
    name: &'static str,
    compiler: &'static str,
}

/// One for each system and processor with code of its own.
const TARGETS: [Triple; 4] = [
    Triple {
        name: "x86_64-unknown-linux-gnu",
        compiler: "x86_64-linux-gnu-gcc",
    },
    Triple {
        name: "aarch64-unknown-linux-gnu",
        compiler: "aarch64-linux-gnu-gcc",
    },
    Triple {
        name: "x86_64-pc-windows-gnu",
        compiler: "x86_64-w64-mingw32-gcc",
    },
    Triple {
        name: "aarch64-apple-darwin",
        // With the headers of macOS, which only macOS has; elsewhere CC_aarch64_apple_darwin names one.
        compiler: "xcrun",
    },
];

/// Checks the workspace for each target that can be built for here, except this machine's own.
pub(crate) fn steps(report: &mut TestReport) {
    for target in TARGETS {
        let name = format!("check for {}", target.name);
        match obstacle(&target) {
            Some(reason) => report.skip(&name, reason),
            None => {
                let mut check = workspace::cargo();
                check.args(["check", "--workspace", "--all-targets", "--target", target.name]);
                // The package is built for the stable interface of all versions of Python.
                check.env("PYO3_NO_PYTHON", "1");
                report.command(&name, &mut check, |_| None);
            }
        }
    }
}

/// Why a target cannot be checked.
fn obstacle(target: &Triple) -> Option<String> {
    let print = |arguments: &[&str]| workspace::output(Command::new("rustc").arg("--print").args(arguments));
    match print(&["host-tuple"]) {
        Ok(host) if host.trim() == target.name => return Some("tested already".into()),
        Ok(_) => {}
        Err(error) => return Some(error),
    }
    let library = print(&["target-libdir", "--target", target.name]);
    if !library.is_ok_and(|folder| std::path::Path::new(folder.trim()).is_dir()) {
        return Some(format!(
            "its standard library is missing; rustup target add {}",
            target.name
        ));
    }
    let variable = format!("CC_{}", target.name.replace('-', "_"));
    let is_found = || Command::new(target.compiler).arg("--version").output().is_ok();
    (std::env::var_os(&variable).is_none() && !is_found()).then(|| {
        format!(
            "no C compiler: install {}, or name one in {variable}",
            target.compiler
        )
    })
}
