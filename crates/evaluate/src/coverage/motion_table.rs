//! The coverage over a motion as a table.

use super::table::lost_columns;
use super::{CandidateCoverage, MotionCoverage, Shares};

const COLUMNS: [&str; 12] = [
    "rank",
    "model",
    "mount",
    "posture",
    "x_m",
    "y_m",
    "z_m",
    "own_robot",
    "hidden_by_robot",
    "seen",
    "measured",
    "median_absolute_error_mm",
];

impl MotionCoverage {
    /// Returns the mounts as a table in CSV, best first: a row for the whole motion (posture `all`), and one for each posture, with the
    /// position of the OAK in the world and the share of the surface that the robot hides. The last columns are the shares that are lost for each reason that occurs.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let postures = |index: &usize| self.mounts[*index].postures.iter().map(|posture| &posture.shares);
        let all =
            (self.ranking.iter()).flat_map(|index| postures(index).chain([&self.mounts[*index].together]));
        let reasons = lost_columns(all);
        let mut table = csv::Writer::from_writer(Vec::new());
        // Writing to memory does not fail.
        let _ = table.write_record(COLUMNS.iter().chain(&reasons));
        for (rank, &index) in (1_usize..).zip(&self.ranking) {
            let mount = &self.mounts[index];
            let mut write = |posture: String, position: [String; 3], own: [String; 2], shares: &Shares| {
                let mut row = vec![rank.to_string(), mount.model.clone(), mount.name.clone(), posture];
                row.extend(position);
                row.extend(own);
                row.extend([shares.seen, shares.measured].map(|share| share.to_string()));
                let error = shares.median_absolute_error_mm;
                row.push(error.map_or_else(String::new, |error| error.to_string()));
                let lost = |reason: &&str| shares.lost.get(*reason).copied().unwrap_or(0.0).to_string();
                row.extend(reasons.iter().map(lost));
                let _ = table.write_record(row);
            };
            write(
                "all".to_owned(),
                Default::default(),
                [mount.own_robot.to_string(), String::new()],
                &mount.together,
            );
            for (number, posture) in mount.postures.iter().enumerate() {
                let CandidateCoverage {
                    position_m,
                    shares,
                    own_robot,
                    ..
                } = posture;
                let own = own_robot.as_ref().map(|own| [own.share, own.hides]);
                let own = own.unwrap_or_default().map(|share| share.to_string());
                write(number.to_string(), position_m.map(|x| x.to_string()), own, shares);
            }
        }
        let bytes = table.into_inner().unwrap_or_default();
        String::from_utf8_lossy(&bytes).into_owned()
    }
}
