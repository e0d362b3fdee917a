//! The result table.

use serde::Serialize;

use crate::protocol::{Frames, Loaded, ViewJson};

#[derive(Serialize)]
pub(crate) struct Outcome {
    title: &'static str,
    pub(crate) triangles: u64,
    width: u32,
    height: u32,
    threads: usize,
    frames: usize,
    /// The engine whose depth is the reference.
    pub(crate) reference: String,
    pub(crate) rows: Vec<BenchRow>,
    /// The engines that were skipped, with the reason.
    pub(crate) skipped: Vec<(String, String)>,
}

#[derive(Serialize)]
pub(crate) struct BenchRow {
    pub(crate) engine: String,
    pub(crate) mode: String,
    pub(crate) loaded: Loaded,
    pub(crate) all_threads: Frames,
    pub(crate) one_thread: Frames,
    pub(crate) agreement: Option<Agreement>,
}

/// The differences between two depth images.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Agreement {
    /// Pixels with a hit in the first image.
    hits: usize,
    /// Pixels that are a miss in only one image, or whose relative difference exceeds [`SAME`].
    differing: usize,
    /// The maximum relative difference of the other pixels.
    largest: f64,
    /// The median relative difference of pixels with hits in both images.
    median: f64,
}

/// The relative difference up to which two depths count as equal.
const SAME: f64 = 1e-5;

impl Agreement {
    pub(crate) fn between(depth: &[f32], reference: &[f32]) -> Self {
        let mut relative = Vec::new();
        let mut one_sided = depth.len().abs_diff(reference.len());
        for (&ours, &theirs) in depth.iter().zip(reference) {
            match (ours.is_finite(), theirs.is_finite()) {
                (true, true) => {
                    let (ours, theirs) = (f64::from(ours), f64::from(theirs));
                    relative.push((ours - theirs).abs() / theirs);
                }
                (false, false) => {}
                _ => one_sided += 1,
            }
        }
        let same: Vec<_> = relative.iter().copied().filter(|r| *r <= SAME).collect();
        Self {
            hits: depth.iter().filter(|z| z.is_finite()).count(),
            differing: one_sided + relative.len() - same.len(),
            largest: same.iter().copied().fold(0.0, f64::max),
            median: median(&relative),
        }
    }
}

impl Outcome {
    pub(crate) fn new(title: &'static str, view: &ViewJson, threads: usize, frames: usize) -> Self {
        Self {
            title,
            triangles: 0,
            width: view.width,
            height: view.height,
            threads,
            frames,
            reference: String::new(),
            rows: Vec::new(),
            skipped: Vec::new(),
        }
    }

    pub(crate) fn print(&self) {
        println!(
            "\n### {}: {} triangles, {} × {}, {} threads, medians of {} frames in turns; × by time (by processor time)\n",
            self.title, self.triangles, self.width, self.height, self.threads, self.frames
        );
        if !self.rows.is_empty() {
            println!(
                "| engine | frame, ms | × Open3D | × Embree 16 | × Embree 8 | CPU, ms | 1 thread, ms | scaling | build, ms | \
                 MB | B/triangle | peak MB | pixels ≠ {} | largest rel. diff. of the rest | median |",
                self.reference
            );
            println!("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
            for row in &self.rows {
                self.print_row(row);
            }
        }
        for (what, reason) in &self.skipped {
            println!("skipped: {what}: {}", reason.lines().last().unwrap_or_default());
        }
    }

    #[expect(clippy::cast_precision_loss, reason = "displayed sizes")]
    fn print_row(&self, row: &BenchRow) {
        let frame = median(&row.all_threads.wall_s);
        let cpu = median(&row.all_threads.cpu_s);
        let one = if self.threads > 1 {
            median(&row.one_thread.wall_s)
        } else {
            frame
        };
        let ratio = |engine: &str, mode: &str| {
            let peer = self.rows.iter().find(|r| r.engine == engine && r.mode == mode);
            peer.map_or("–".to_owned(), |peer| {
                let times = &peer.all_threads;
                format!(
                    "{:.2} ({:.2})",
                    median(&times.wall_s) / frame,
                    median(&times.cpu_s) / cpu
                )
            })
        };
        let bytes = row.loaded.resident_bytes as f64;
        let agreement = row.agreement.map_or("– | – | –".to_owned(), |a| {
            format!("{} | {:.1e} | {:.1e}", a.differing, a.largest, a.median)
        });
        println!(
            "| {} | {:.2} | {} | {} | {} | {:.2} | {:.2} | {:.2} | {:.0} | {:.0} | {:.0} | {:.0} | {agreement} |",
            format!("{} {}", row.engine, row.mode).trim(),
            frame * 1e3,
            ratio("open3d", ""),
            ratio("embree", "16"),
            ratio("embree", "8"),
            cpu * 1e3,
            one * 1e3,
            one / frame,
            row.loaded.build_s * 1e3,
            bytes / 1e6,
            bytes / self.triangles as f64,
            row.loaded.peak_bytes as f64 / 1e6,
        );
    }
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    match sorted.get(middle) {
        None => f64::NAN,
        Some(upper) if sorted.len() % 2 == 1 => *upper,
        Some(upper) => f64::midpoint(sorted[middle - 1], *upper),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_wrong_depths() {
        let inf = f32::INFINITY;
        let reference = [1.0, 2.0, inf, 4.0, inf];
        let ours = [1.0, 2.000_001, inf, 4.1, 5.0];
        let agreement = Agreement::between(&ours, &reference);
        assert_eq!((agreement.hits, agreement.differing), (4, 2));
        assert!(agreement.largest > 1e-7 && agreement.largest < 1e-6);
        let nan = Agreement::between(&[f32::NAN], &[1.0]);
        assert_eq!(nan.differing, 1);
    }
}
