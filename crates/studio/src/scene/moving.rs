//! Animated scenes at other times than the one they are opened at.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::render::{AnimatedScene, Renderer, SceneChange};
use oaktwin::usd::stage::StageTiming;

use super::LoadedScene;
use crate::protocol::{AnimationInfo, Failure};

/// The number of times of a scene that are kept: the shown one, and the one that is about to be shown.
const KEPT: usize = 2;
/// The frames per second of an animation whose own rate is none of frames, such as glTF's, whose time codes are seconds.
const FRAME_RATE: f64 = 30.0;
const FRAME_RATES: std::ops::RangeInclusive<f64> = 10.0..=60.0;
/// The largest number of frames that the page steps through; longer animations have longer steps.
const MAX_FRAMES: f64 = 100_000.0;

/// A scene whose file stays open.
#[derive(Debug)]
pub(crate) struct Moving(Mutex<State>);

#[derive(Debug)]
struct State {
    file: AnimatedScene,
    /// The one that was used last is the last.
    known: VecDeque<Arc<LoadedScene>>,
}

impl Moving {
    /// Keeps a file open, if anything in it moves.
    pub(crate) fn new(file: AnimatedScene) -> Option<(Self, AnimationInfo)> {
        let animation = animation(file.timing())?;
        let state = State {
            file,
            known: VecDeque::new(),
        };
        Some((Self(Mutex::new(state)), animation))
    }

    /// Returns the scene at a time code; `base` is the scene at the time when it was opened.
    pub(crate) fn at(&self, base: &LoadedScene, time: f64) -> Result<Arc<LoadedScene>, Failure> {
        let mut state = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let is_known =
            |scene: &Arc<LoadedScene>| scene.time.is_some_and(|known| known.to_bits() == time.to_bits());
        if let Some(place) = state.known.iter().position(is_known)
            && let Some(scene) = state.known.remove(place)
        {
            state.known.push_back(Arc::clone(&scene));
            return Ok(scene);
        }
        let changed = state.file.at(Some(time));
        let (change, findings) = changed.map_err(|error| Failure::from(base.local(&error.to_string())))?;
        let oldest = match state.known.len() >= KEPT {
            true => state.known.pop_front(),
            false => None,
        };
        let scene = match change {
            SceneChange::Moved(instances, _) => {
                // A renderer that nobody else uses keeps what it has built of the meshes.
                let spare = oldest.and_then(Arc::into_inner).filter(|scene| scene.is_moved);
                let mut renderer = spare.map_or_else(
                    || Renderer::new(base.renderer.scene().clone()),
                    |scene| scene.renderer,
                );
                renderer.set_poses(instances);
                base.at_time(renderer, true, time, findings)
            }
            SceneChange::Rebuilt(mut file) => {
                base.at_time(Renderer::new(file.take_scene()), false, time, findings)
            }
        };
        let scene = Arc::new(scene);
        state.known.push_back(Arc::clone(&scene));
        Ok(scene)
    }
}

/// The frames of an animation, if anything moves during a time.
fn animation(timing: &StageTiming) -> Option<AnimationInfo> {
    let (first, last) = timing.range.filter(|_| timing.is_animated)?;
    let codes_per_second = timing.time_codes_per_second;
    let step = match FRAME_RATES.contains(&codes_per_second) {
        true => 1.0,
        false => codes_per_second / FRAME_RATE,
    };
    (last > first).then(|| AnimationInfo {
        first,
        last,
        codes_per_second,
        step: step.max((last - first) / MAX_FRAMES),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_have_the_rate_of_the_stage_if_it_is_one() {
        let timing = |time_codes_per_second: f64, last: f64| StageTiming {
            time_codes_per_second,
            range: Some((0.0, last)),
            is_animated: true,
            deforms: None,
        };
        let step = |rate, last| animation(&timing(rate, last)).map(|animation| animation.step);
        assert_eq!(step(24.0, 48.0), Some(1.0));
        assert_eq!(step(1.0, 2.0), Some(1.0 / 30.0));
        assert_eq!(step(1000.0, 100.0), Some(1000.0 / 30.0));
        assert_eq!(step(24.0, 1e7), Some(100.0));
        assert_eq!(step(24.0, 0.0), None);
        let still = StageTiming {
            is_animated: false,
            ..timing(24.0, 48.0)
        };
        assert_eq!(animation(&still), None);
    }
}
