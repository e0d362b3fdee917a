//! What a camera sees while it takes a frame, beside the moment of the frame.

use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_camera::Camera;
use oaktwin_image::annotation::Frame;
use oaktwin_render::{Backend, Renderer};

use super::RigError;
use crate::pair::{Light, PairCameras};
use crate::render::PlacedCamera;
use crate::render::shutter::{Colours, Earlier, Moments, Shutter, colours, earlier, velocities};

/// What differs from the moment of the frame.
#[derive(Default)]
pub(super) struct During {
    colours: Option<Colours>,
    /// What both cameras of the pair see.
    pub(super) lights: Option<[Light; 2]>,
    earlier: Option<Earlier>,
}

/// What is asked of a camera.
pub(super) struct Asked<'a> {
    pub(super) camera: &'a PlacedCamera,
    pub(super) index: usize,
    pub(super) has_colours: bool,
    pub(super) pair: Option<&'a PairCameras>,
    /// The ages of a time-of-flight camera's measurements, s.
    pub(super) ages_s: Option<[f64; 2]>,
    pub(super) backend: Backend,
}

impl During {
    pub(super) fn of(
        moments: &mut dyn Moments,
        shutter: Option<Shutter>,
        asked: &Asked<'_>,
    ) -> Result<Self, RigError> {
        let Some(shutter) = shutter else {
            return Ok(Self::default());
        };
        let Asked {
            camera,
            index,
            backend,
            ..
        } = *asked;
        let timing = shutter.timing(camera.readout_s);
        let mut during = Self::default();
        if asked.has_colours {
            during.colours = colours(moments, index, timing, backend, &|mount| camera.view(mount))?;
        }
        if let Some(pair) = asked.pair {
            during.lights = pair.expose(moments, index, &shutter)?;
        }
        if let Some(ages_s) = asked.ages_s {
            during.earlier = Some(earlier(moments, index, camera, ages_s, backend)?);
        }
        Ok(during)
    }

    /// Adds the colours and the velocities to the frame of the moment.
    pub(super) fn put(self, camera: &Camera, frame: &mut Frame, findings: &mut Vec<Finding>) {
        if let Some((light, more)) = self.colours {
            frame.rgb = Some(Renderer::developed(&light));
            frame.light = frame.light.is_some().then_some(light);
            add_new(findings, more);
        }
        let depth = frame.distance_to_image_plane.as_ref();
        frame.radial_velocities =
            (self.earlier.as_ref().zip(depth)).map(|(earlier, depth)| velocities(camera, depth, earlier));
    }
}
