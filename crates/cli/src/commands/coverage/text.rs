//! The result of `coverage` as text.

use std::fmt::Write;

use oaktwin::catalog::TextTable;
use oaktwin::coverage::{CandidateCoverage, Coverage, Occluder, SampledRegion, Shares};
use oaktwin::files::WrittenFile;

use crate::number::{millimetres, percent};
use crate::output;

/// The maximum number of candidates in the table.
const MAX_ROWS: usize = 20;

/// The maximum number of reasons in a row.
const MAX_REASONS: usize = 3;

pub(super) fn report(coverage: &Coverage, files: &[WrittenFile]) -> String {
    let mut text = region(&coverage.region);
    if !coverage.candidates.is_empty() {
        text += &output::number_table(&table(coverage));
        text += &remarks(coverage);
    }
    text + &written(files)
}

/// The files that were written, one on a line.
pub(super) fn written(files: &[WrittenFile]) -> String {
    let line = |file: &WrittenFile| format!("Written: {}\n", file.path.display());
    files.iter().map(line).collect()
}

pub(super) fn region(region: &SampledRegion) -> String {
    let mut places = region.objects.clone();
    if places.is_empty() {
        places.push("the whole scene".to_owned());
    }
    if let (Some(min), Some(max)) = (region.minimum_m, region.maximum_m) {
        let corner = |point: [f64; 3]| point.map(|x| x.to_string()).join(" ");
        places.push(format!("within {} to {} m", corner(min), corner(max)));
    }
    format!(
        "Region: {}\n{:.3} m² of surface, {} points, standard error up to {:.1} %\n",
        places.join(", "),
        region.area_m2,
        region.samples,
        region.standard_error * 100.0
    )
}

fn table(coverage: &Coverage) -> TextTable {
    let header = [
        "Rank",
        "Model",
        "Measured",
        "Seen",
        "Median error",
        "95 %",
        "Pose",
        "Lost",
    ];
    let rows = (1..).zip(&coverage.ranking).take(MAX_ROWS);
    TextTable {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: rows
            .map(|(rank, &index)| row(rank, &coverage.candidates[index]))
            .collect(),
    }
}

fn row(rank: usize, candidate: &CandidateCoverage) -> Vec<String> {
    let shares = &candidate.shares;
    vec![
        rank.to_string(),
        candidate.model.clone(),
        percent(shares.measured),
        percent(shares.seen),
        millimetres(shares.median_absolute_error_mm),
        millimetres(shares.p95_absolute_error_mm),
        candidate.name.clone(),
        losses(shares),
    ]
}

/// What the table does not contain.
fn remarks(coverage: &Coverage) -> String {
    let mut text = "\n".to_owned();
    let hidden = coverage.candidates.len().saturating_sub(MAX_ROWS);
    if hidden > 0 {
        let _ = writeln!(
            text,
            "{hidden} more candidates are in the CSV file and in the JSON output."
        );
    }
    if coverage.candidates.len() > 1 {
        let together = &coverage.together;
        let _ = writeln!(
            text,
            "All together: {} measured, {} seen, median error {}",
            percent(together.measured),
            percent(together.seen),
            millimetres(together.median_absolute_error_mm)
        );
    }
    if coverage.selection.len() > 1 {
        let chosen = coverage.selection.iter().map(|selected| {
            let rank = coverage
                .ranking
                .iter()
                .position(|&index| index == selected.candidate);
            format!(
                "#{} {}",
                rank.map_or(0, |rank| rank + 1),
                percent(selected.measured)
            )
        });
        let _ = writeln!(
            text,
            "Best combination, measured so far after each: {}",
            chosen.collect::<Vec<_>>().join(", ")
        );
    }
    let best = coverage.ranking.first().map(|&best| &coverage.candidates[best]);
    let occluders = best.map_or(&[][..], |best| &best.occluders);
    if !occluders.is_empty() {
        let _ = writeln!(text, "Hidden from #1 by {}", hiding(occluders));
    }
    text
}

/// The objects that hide the region, with their shares.
pub(super) fn hiding(occluders: &[Occluder]) -> String {
    let named = occluders.iter();
    let named = named.map(|occluder| format!("{} {}", occluder.path, percent(occluder.share)));
    named.collect::<Vec<_>>().join(", ")
}

pub(super) fn losses(shares: &Shares) -> String {
    let losses = shares.losses();
    let losses = losses.iter().take(MAX_REASONS);
    let losses: Vec<String> = losses
        .map(|(name, share)| format!("{} {}", name.replace('_', " "), percent(*share)))
        .collect();
    losses.join(", ")
}
