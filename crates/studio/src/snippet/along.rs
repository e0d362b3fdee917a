//! Commands that render a frame of a trajectory.

use std::sync::Arc;

use crate::protocol::{ExportRequest, Failure, OakState};
use crate::studio::Studio;
use crate::trajectory::Dropped;

/// The trajectory along which a command renders the frame of a state.
pub(super) struct Along(pub(super) Arc<Dropped>);

/// Returns the trajectory to which the frame of a state belongs. The first frame of any path is one frame at its pose.
pub(super) fn along(studio: &Studio, request: &ExportRequest) -> Result<Option<Along>, Failure> {
    let OakState { frame, pose, .. } = request.state;
    if frame == 0 {
        return Ok(None);
    }
    let dropped = (request.trajectory.as_ref()).map(|id| studio.trajectories.get(id));
    let dropped = dropped.transpose()?;
    let own = |dropped: &Dropped| {
        let place = usize::try_from(frame).ok()?;
        dropped.info.poses.get(place).copied()
    };
    match dropped.filter(|dropped| own(dropped) == Some(pose)) {
        Some(dropped) => Ok(Some(Along(dropped))),
        None => {
            let error = format!("frame {frame} is none of a trajectory; pause the timeline");
            Err(Failure::of("frame", &error))
        }
    }
}

impl Along {
    /// The time codes of the frames, as `--frames` takes them.
    pub(super) fn codes(&self, request: &ExportRequest) -> Result<String, Failure> {
        let Some([first, step]) = request.codes else {
            return Err(Failure::of("codes", "are missing; load the page again"));
        };
        let count = self.0.info.poses.len().saturating_sub(1);
        Ok(format!("{first:?}:{:?}:{step:?}", first + count as f64 * step))
    }
}
