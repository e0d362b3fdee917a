//! The result over the postures of a robot as text.

use std::fmt::Write;

use oaktwin::catalog::TextTable;
use oaktwin::coverage::{CandidateCoverage, MotionCoverage, MountCoverage};
use oaktwin::files::WrittenFile;

use super::text::{hiding, losses, region, written};
use crate::number::{millimetres, percent};
use crate::output;

/// The maximum number of mounts, or postures, in a table.
const MAX_ROWS: usize = 20;

/// The maximum number of links in a row.
const MAX_LINKS: usize = 3;

pub(super) fn report(coverage: &MotionCoverage, files: &[WrittenFile]) -> String {
    let mut text = region(&coverage.region);
    if let Some(&best) = coverage.ranking.first() {
        let _ = writeln!(text, "\nOver the whole motion");
        text += &output::number_table(&mounts(coverage));
        let hidden = coverage.ranking.len().saturating_sub(MAX_ROWS);
        if hidden > 0 {
            let _ = writeln!(text, "{hidden} more are in the CSV file and in the JSON output.");
        }
        let best = &coverage.mounts[best];
        if best.postures.len() > 1 {
            let _ = writeln!(text, "\nPostures of #1");
            text += &output::number_table(&postures(best));
            text += &remarks(best);
        }
    }
    text + &written(files)
}

fn mounts(coverage: &MotionCoverage) -> TextTable {
    let header = [
        "Rank",
        "Model",
        "Measured",
        "Seen",
        "Median error",
        "95 %",
        "Own robot",
        "Pose",
        "Lost",
    ];
    let row = |(rank, &index): (usize, &usize)| {
        let mount = &coverage.mounts[index];
        let shares = &mount.together;
        vec![
            rank.to_string(),
            mount.model.clone(),
            percent(shares.measured),
            percent(shares.seen),
            millimetres(shares.median_absolute_error_mm),
            millimetres(shares.p95_absolute_error_mm),
            percent(mount.own_robot),
            mount.name.clone(),
            losses(shares),
        ]
    };
    TextTable {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: (1..).zip(&coverage.ranking).take(MAX_ROWS).map(row).collect(),
    }
}

fn postures(mount: &MountCoverage) -> TextTable {
    let header = [
        "Posture",
        "Measured",
        "Seen",
        "Median error",
        "Own robot",
        "Links in view",
        "Lost",
    ];
    let row = |(number, posture): (usize, &CandidateCoverage)| {
        let shares = &posture.shares;
        let own = posture.own_robot.clone().unwrap_or_default();
        let links = own.links.iter().take(MAX_LINKS);
        let links: Vec<String> = links
            .map(|(link, share)| format!("{link} {}", percent(*share)))
            .collect();
        vec![
            number.to_string(),
            percent(shares.measured),
            percent(shares.seen),
            millimetres(shares.median_absolute_error_mm),
            percent(own.share),
            links.join(", "),
            losses(shares),
        ]
    };
    TextTable {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: mount
            .postures
            .iter()
            .enumerate()
            .take(MAX_ROWS)
            .map(row)
            .collect(),
    }
}

/// What the table of the postures does not contain.
fn remarks(mount: &MountCoverage) -> String {
    let mut text = "\n".to_owned();
    let hidden = mount.postures.len().saturating_sub(MAX_ROWS);
    if hidden > 0 {
        let _ = writeln!(
            text,
            "{hidden} more postures are in the CSV file and in the JSON output."
        );
    }
    if mount.selection.len() > 1 {
        let chosen = (mount.selection.iter())
            .map(|selected| format!("{} {}", selected.candidate, percent(selected.measured)));
        let _ = writeln!(
            text,
            "Best combination of postures, measured so far after each: {}",
            chosen.collect::<Vec<_>>().join(", ")
        );
    }
    let worst = (mount.postures.iter()).max_by(|a, b| {
        let hides = |one: &CandidateCoverage| one.occluders.iter().map(|hiding| hiding.share).sum::<f64>();
        hides(a).total_cmp(&hides(b))
    });
    if let Some(worst) = worst.filter(|worst| !worst.occluders.is_empty()) {
        let _ = writeln!(
            text,
            "Most is hidden in {}: by {}",
            worst.name,
            hiding(&worst.occluders)
        );
    }
    text
}
