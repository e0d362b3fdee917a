//! The light of the latest stereo pairs, which the next frames have too if nothing moved.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use oaktwin::camera::RigidTransform;
use oaktwin::catalog::Twin;
use oaktwin::pair::{PairCameras, PairError, PairLight, PairOptions};
use oaktwin::render::Renderer;

/// The number of pairs that are kept: a device may record several sizes.
const KEPT: usize = 3;

/// The cameras and the light of the latest pairs of a stage, the most recent first.
#[derive(Default)]
pub(super) struct Lit(Mutex<Vec<Latest>>);

struct Latest {
    twin: Arc<Twin>,
    options: PairOptions,
    cameras: Arc<PairCameras>,
    world_from_body: RigidTransform,
    light: Arc<PairLight>,
}

impl Lit {
    /// Returns the cameras of a twin and the light that arrives at them, which is rendered only if no recent pair had the same.
    pub(super) fn pair(
        &self,
        renderer: &Renderer,
        twin: &Arc<Twin>,
        options: &PairOptions,
        world_from_body: &RigidTransform,
    ) -> Result<(Arc<PairCameras>, Arc<PairLight>), PairError> {
        let known = {
            let mut kept = self.lock();
            let place = kept
                .iter()
                .position(|one| one.is_lit_like(twin, options, world_from_body));
            place.map(|place| kept.remove(place))
        };
        // Other threads render other pairs at the same time.
        let (cameras, light) = match known {
            Some(known) if known.options == *options => (known.cameras, Some(known.light)),
            known => {
                let cameras = Arc::new(PairCameras::new(twin, options)?);
                (cameras, known.map(|known| known.light))
            }
        };
        let light = light.unwrap_or_else(|| Arc::new(cameras.light(renderer, world_from_body)));
        let latest = Latest {
            twin: Arc::clone(twin),
            options: *options,
            cameras: Arc::clone(&cameras),
            world_from_body: *world_from_body,
            light: Arc::clone(&light),
        };
        let mut kept = self.lock();
        kept.truncate(KEPT - 1);
        kept.insert(0, latest);
        Ok((cameras, light))
    }

    /// Forgets the light, because the scene changed.
    pub(super) fn clear(&mut self) {
        self.lock().clear();
    }

    fn lock(&self) -> MutexGuard<'_, Vec<Latest>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Latest {
    /// Whether a pair has the same light. Noise and exposure may differ.
    fn is_lit_like(&self, twin: &Arc<Twin>, options: &PairOptions, world_from_body: &RigidTransform) -> bool {
        Arc::ptr_eq(&self.twin, twin)
            && self.world_from_body == *world_from_body
            && without_noise(&self.options) == without_noise(options)
    }
}

/// The options that determine the light: without what happens in the image sensors.
fn without_noise(options: &PairOptions) -> PairOptions {
    let PairOptions { imager, seed, .. } = PairOptions::default();
    PairOptions {
        imager,
        seed,
        ..*options
    }
}
