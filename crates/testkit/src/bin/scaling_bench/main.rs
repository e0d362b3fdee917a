//! Measures how costs grow, for `cargo xtask bench scaling`.
//!
//! `scaling-bench axes` prints the names of the axes. `scaling-bench AXIS FRAMES` prints a JSON object per point: what is measured
//! with its unit, the place on the axis and the measured values.

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

mod axes;
mod scenes;

use std::error::Error;

use oaktwin_testkit::process::{self, Elapsed};
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "usage: scaling-bench axes | AXIS FRAMES";
    let name = arguments.next().ok_or(usage)?;
    if name == "axes" {
        axes::ALL.iter().for_each(|(name, _)| println!("{name}"));
        return Ok(());
    }
    let frames: u32 = arguments.next().ok_or(usage)?.parse()?;
    let axis = axes::ALL.iter().find(|(known, _)| *known == name);
    let (_, measure) = axis.ok_or_else(|| {
        let names: Vec<&str> = axes::ALL.iter().map(|(name, _)| *name).collect();
        format!("unknown axis {name}; expected one of {}", names.join(", "))
    })?;
    measure(&Measurement { frames })
}

/// The measurement of a point.
struct Measurement {
    /// How often work is timed.
    frames: u32,
}

impl Measurement {
    /// Times work after a warm-up, and prints the milliseconds of processor time.
    fn frames(&self, what: &str, at: u64, work: impl FnMut()) {
        self.times(what, at, work, |time| time.cpu_s);
    }

    /// Times work after a warm-up, and prints the elapsed milliseconds.
    fn elapsed(&self, what: &str, at: u64, work: impl FnMut()) {
        self.times(what, at, work, |time| time.wall_s);
    }

    fn times(&self, what: &str, at: u64, mut work: impl FnMut(), seconds: fn(Elapsed) -> f64) {
        work();
        let times = (0..self.frames.max(1)).map(|_| seconds(process::timed(&mut work).1) * 1e3);
        print(&format!("{what}, ms"), at, &times.collect::<Vec<_>>());
    }
}

fn print(what: &str, at: u64, values: &[f64]) {
    println!("{}", json!({ "what": what, "at": at, "values": values }));
}
