use oaktwin_render::{Backend, Beam, BeamPattern, Clip, Renderer, View};

use super::{Pair, PairError, PairOptions};
use crate::limits::check_size;
use crate::render::{Moments, RigError, Shutter, exposed};
use crate::sensor::Illumination;
use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, Camera, Intrinsics, LensModel, OpenCv, PixelPoint, RigidTransform};
use oaktwin_catalog::{self as catalog, DepthKind, Role, Twin};
use oaktwin_depth::ParameterError;
use oaktwin_depth::dots::{DotProjector, Dots};
use oaktwin_depth::imager::{Imager, Recorded};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::random::{NoiseStage, Stream};
use oaktwin_depth::rectify::{Rectify, RectifyOptions, StereoRectify};
use oaktwin_image::{Image, ImageView, ZDepth};

/// The scene's light moves with its surfaces; dots do not.
const MOVES: [bool; 2] = [true, false];

/// The maximum bias, far above any calibration error, px.
const MAX_BIAS_PX: f64 = 10.0;

/// What a camera sees, and the findings about it.
pub(crate) type Light = (Image<f32>, Vec<Finding>);

/// The cameras of a twin's stereo pair.
#[derive(Clone, Debug)]
pub struct PairCameras {
    left: StereoCamera,
    right: StereoCamera,
    imager: Imager,
    rectify: StereoRectify,
    projector: Option<ActiveProjector>,
    ambient: f32,
}

/// The light of a pair in a still scene, before exposure and noise.
#[derive(Clone, Debug)]
pub struct PairLight {
    /// The luminance in the raw left image; 1 is a white diffuse surface in typical light.
    left: Image<f32>,
    right: Image<f32>,
    z: ZDepth,
    findings: Vec<Finding>,
}

/// One camera of the pair.
#[derive(Clone, Debug)]
struct StereoCamera {
    camera: Camera,
    body_from_camera: RigidTransform,
    clip: Clip,
    readout_s: f64,
    random: Stream,
}

impl StereoCamera {
    fn view(&self, world_from_body: &RigidTransform) -> View {
        View {
            camera: self.camera,
            world_from_camera: *world_from_body * self.body_from_camera,
            clip: self.clip,
        }
    }
}

/// An active dot projector.
#[derive(Clone, Debug)]
struct ActiveProjector {
    body_from_projector: RigidTransform,
    dots: Dots,
    power: f32,
}

impl BeamPattern for ActiveProjector {
    fn luminance(&self, at: [f32; 2]) -> f32 {
        self.dots.luminance(at) * self.power
    }

    fn is_dark_around(&self, at: [f32; 2], radius: f32) -> bool {
        self.dots.is_dark_around(at, radius)
    }
}

impl PairCameras {
    /// Creates the pair of a twin.
    ///
    /// # Errors
    /// Returns an error if an option is out of range, the device has no stereo pair or no projector, the images are too large, or the
    /// cameras cannot be rectified.
    pub fn new(twin: &Twin, options: &PairOptions) -> Result<Self, PairError> {
        let [mut left, mut right] = [
            eye(twin, options.cameras.0, options)?,
            eye(twin, options.cameras.1, options)?,
        ];
        let rectify = options.rectify.unwrap_or_else(|| device_rectification(twin));
        let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
        let rectify = StereoRectify::new(&left.camera, &right.camera, &right_from_left, &rectify);
        let rectify = rectify.map_err(|error| PairError::Rectify {
            device: twin.device.name.clone(),
            error,
        })?;
        // From here on, the cameras are the actual ones.
        let drift = &options.drift;
        if !drift.is_none() {
            let geometry = rectify.geometry();
            right.body_from_camera = drift.right_camera(
                &right.body_from_camera,
                geometry.rectified_from_right,
                geometry.axis,
            );
            for eye in [&mut left, &mut right] {
                eye.camera.intrinsics = drift.intrinsics(&eye.camera.intrinsics);
            }
        }
        right.camera.intrinsics = shifted(right.camera.intrinsics, -bias_px(twin, options)?);
        Ok(Self {
            imager: Imager::new(options.imager)?.scaled(scale(twin, options)),
            rectify,
            projector: projector(twin, options)?,
            ambient: within("ambient", options.ambient, 1e6)?,
            left,
            right,
        })
    }

    /// The left and right camera with their actual intrinsics and lenses.
    #[must_use]
    pub fn cameras(&self) -> [&Camera; 2] {
        [&self.left.camera, &self.right.camera]
    }

    /// The rectification.
    #[must_use]
    pub fn rectify(&self) -> &StereoRectify {
        &self.rectify
    }

    /// The pose of the rectified left camera in the body, metres.
    #[must_use]
    pub fn body_from_rectified_left(&self) -> RigidTransform {
        let left_from_rectified = self.rectify.geometry().rectified_from_left.transpose();
        self.left.body_from_camera * RigidTransform::new(left_from_rectified, DVec3::ZERO)
    }

    /// Renders a pair with the body at a pose in metres; the noise depends on the frame number.
    #[must_use]
    pub fn capture(&self, renderer: &Renderer, world_from_body: &RigidTransform, frame: u64) -> Pair {
        self.record(&self.light(renderer, world_from_body), frame)
    }

    /// Renders the light that arrives at the cameras with the body at a pose in metres, from which [`record`](Self::record) makes any
    /// number of frames.
    #[must_use]
    pub fn light(&self, renderer: &Renderer, world_from_body: &RigidTransform) -> PairLight {
        let lights = self.eyes().map(|eye| {
            let view = eye.view(world_from_body);
            self.light_of(&view, renderer, world_from_body)
        });
        self.with_truth(lights, renderer, world_from_body)
    }

    /// Returns what both cameras see while they take a frame; `None` if nothing moves.
    pub(crate) fn expose(
        &self,
        moments: &mut dyn Moments,
        camera: usize,
        shutter: &Shutter,
    ) -> Result<Option<[Light; 2]>, RigError> {
        let mut lights = Vec::new();
        for eye in self.eyes() {
            let render = |renderer: &Renderer, body: &RigidTransform, view: &View| {
                let (light, dots, findings) = self.parts(view, renderer, body);
                let mut both = light.map(|light| [*light, 0.0]);
                for (pixel, dots) in both
                    .pixels_mut()
                    .iter_mut()
                    .zip(dots.iter().flat_map(Image::pixels))
                {
                    pixel[1] = *dots;
                }
                (both, findings)
            };
            let timing = shutter.timing(Some(eye.readout_s));
            let Some((light, findings)) =
                exposed(moments, camera, timing, &|body| eye.view(body), MOVES, render)?
            else {
                // What one camera does not see moving, the other may.
                let (renderer, body) = moments.at(0.0, camera)?;
                lights.push((self.light_of(&eye.view(&body), renderer, &body), false));
                continue;
            };
            lights.push(((light.map(|[light, dots]| light + dots), findings), true));
        }
        let is_moving = lights.iter().any(|(_, is_moving)| *is_moving);
        let lights: Vec<_> = lights.into_iter().map(|(light, _)| light).collect();
        Ok(lights.try_into().ok().filter(|_| is_moving))
    }

    fn eyes(&self) -> [&StereoCamera; 2] {
        [&self.left, &self.right]
    }

    /// Adds the ground truth of the body at a pose in metres to what both cameras see.
    pub(crate) fn with_truth(
        &self,
        [(left, mut findings), (right, more)]: [Light; 2],
        renderer: &Renderer,
        world_from_body: &RigidTransform,
    ) -> PairLight {
        add_new(&mut findings, more);
        let truth = View {
            camera: Camera::new(self.rectify.geometry().left, LensModel::Pinhole),
            world_from_camera: *world_from_body * self.body_from_rectified_left(),
            clip: self.left.clip,
        };
        PairLight {
            left,
            right,
            z: renderer.depth(&truth, Backend::Auto),
            findings,
        }
    }

    /// Exposes and records a pair; the noise depends on the frame number.
    #[must_use]
    pub fn record(&self, light: &PairLight, frame: u64) -> Pair {
        let PairLight {
            left,
            right,
            z,
            findings,
        } = light;
        let [left_intrinsics, right_intrinsics] = [&self.left, &self.right].map(|eye| &eye.camera.intrinsics);
        let exposure = self.imager.expose(&[
            (ImageView::from(left), left_intrinsics),
            (ImageView::from(right), right_intrinsics),
        ]);
        let record = |eye: &StereoCamera, light: &Image<f32>| {
            let random = eye.random.plane(NoiseStage::Exposure, frame, 0);
            (self.imager).record(light.into(), &eye.camera.intrinsics, exposure, &random)
        };
        let (left, right) = (record(&self.left, left), record(&self.right, right));
        Pair {
            rectified_left: rectified(self.rectify.left(), &left),
            rectified_right: rectified(self.rectify.right(), &right),
            left,
            right,
            z: z.clone(),
            exposure,
            geometry: *self.rectify.geometry(),
            findings: findings.clone(),
        }
    }
}

impl PairCameras {
    /// The light that a camera sees.
    fn light_of(
        &self,
        view: &View,
        renderer: &Renderer,
        world_from_body: &RigidTransform,
    ) -> (Image<f32>, Vec<Finding>) {
        let (mut light, dots, findings) = self.parts(view, renderer, world_from_body);
        let dots = dots.iter().flat_map(Image::pixels);
        for (light, dots) in light.pixels_mut().iter_mut().zip(dots) {
            *light += dots;
        }
        (light, findings)
    }

    /// The scene's light and the projector's, if it is on.
    fn parts(
        &self,
        view: &View,
        renderer: &Renderer,
        world_from_body: &RigidTransform,
    ) -> (Image<f32>, Option<Image<f32>>, Vec<Finding>) {
        let beam = self.projector.as_ref().map(|lamp| Beam {
            world_from_beam: *world_from_body * lamp.body_from_projector,
            pattern: lamp as &dyn BeamPattern,
        });
        let (mut seen, findings) = renderer.luminance(view, Backend::Auto, beam.as_ref());
        for light in seen.scene.pixels_mut() {
            *light *= self.ambient;
        }
        (seen.scene, seen.beam, findings)
    }
}

/// Rectifies an image of the camera's size; others are unchanged.
fn rectified(rectify: &Rectify, raw: &Recorded) -> Recorded {
    let found = match raw {
        Recorded::Eight(image) => rectify.rectify(image.into()).map(Recorded::Eight),
        Recorded::Ten(image) => rectify.rectify(image.into()).map(Recorded::Ten),
    };
    found.unwrap_or_else(|| raw.clone())
}

fn eye(twin: &Twin, role: Role, options: &PairOptions) -> Result<StereoCamera, PairError> {
    let device = || twin.device.name.clone();
    let Some(camera) = twin.camera(role) else {
        return Err(PairError::NoCamera {
            device: device(),
            role: role.as_str(),
            others: twin.device.models_with_depth(Some(DepthKind::Stereo)),
        });
    };
    let mut optics = twin.optics(camera, options.lens);
    if let Some(size) = options.size {
        check_size(size).map_err(|error| PairError::Size {
            device: device(),
            error,
        })?;
        optics.intrinsics = optics.intrinsics.resized(size, true);
    }
    let (near_m, far_m) = camera.spec.clipping_range_m;
    Ok(StereoCamera {
        camera: optics,
        body_from_camera: camera.body_from_camera,
        clip: Clip { near_m, far_m },
        readout_s: camera.readout_s,
        random: Stream::new(options.seed, &camera.spec.prim),
    })
}

/// The calibration error in pixels of the images.
fn bias_px(twin: &Twin, options: &PairOptions) -> Result<f64, ParameterError> {
    let bias = options.bias_px;
    if bias.is_nan() || bias.abs() > MAX_BIAS_PX {
        return Err(ParameterError {
            name: "bias".to_owned(),
            what: format!("{bias} is out of range"),
            remedy: format!("give -{MAX_BIAS_PX} to {MAX_BIAS_PX} px"),
        });
    }
    Ok(bias * scale(twin, options))
}

/// The size of a pixel of the cameras' own resolution, px of the images.
fn scale(twin: &Twin, options: &PairOptions) -> f64 {
    let own = twin
        .camera(options.cameras.1)
        .map(|camera| camera.intrinsics.size.width);
    match (own, options.size) {
        (Some(own), Some(size)) => f64::from(size.width) / f64::from(own),
        _ => 1.0,
    }
}

/// Returns the intrinsics with the principal point moved to the right by `by_px` pixels.
#[must_use]
pub fn shifted(intrinsics: Intrinsics, by_px: f64) -> Intrinsics {
    let centre = intrinsics.principal_point::<OpenCv>();
    let moved = PixelPoint::<OpenCv>::new(centre.x + by_px, centre.y);
    Intrinsics::new(intrinsics.size, intrinsics.fx, intrinsics.fy, moved)
}

/// The rectification of the device's processor; for an unknown one, as by `DepthAI` on a host.
fn device_rectification(twin: &Twin) -> RectifyOptions {
    RectifyOptions::of(twin.platform().unwrap_or(Platform::Rvc4))
}

fn projector(twin: &Twin, options: &PairOptions) -> Result<Option<ActiveProjector>, PairError> {
    let power = within("projector", options.projector, 1.0)?;
    let Some(spec) = active(twin, options.projector)? else {
        return Ok(None);
    };
    let Some(place) = twin.device.body.projector_mm else {
        return Err(no_projector(twin));
    };
    Ok(Some(ActiveProjector {
        body_from_projector: RigidTransform::new(
            Axes::Ros.rotation_from(Axes::OpenCv),
            DVec3::from(place) * 1e-3,
        ),
        dots: dots(spec),
        power,
    }))
}

/// Returns the projector of a device at this intensity; `None` if it is off.
fn active(twin: &Twin, power: f64) -> Result<Option<&catalog::Projector>, PairError> {
    within("projector", power, 1.0)?;
    if power <= 0.0 {
        return Ok(None);
    }
    twin.device
        .projector
        .as_ref()
        .ok_or_else(|| no_projector(twin))
        .map(Some)
}

fn no_projector(twin: &Twin) -> PairError {
    PairError::NoProjector {
        device: twin.device.name.clone(),
    }
}

/// Returns the light of the dot projector of a device at an intensity from 0 (off) to 1, in a room with `ambient` times the light of
/// a bright one.
///
/// # Errors
/// Returns an error if the intensity or the ambient light is out of range, or the device has no projector.
pub fn illumination(twin: &Twin, projector: f64, ambient: f64) -> Result<Illumination, PairError> {
    within("ambient", ambient, 1e6)?;
    let spec = active(twin, projector)?;
    Ok(Illumination {
        dot_contrast: spec.map_or(0.0, |spec| spec.brightness * projector),
        ambient,
    })
}

/// Returns the intensity at which data sets and coverage use the dot projector of a device by default: full, 1, or 0 without one.
#[must_use]
pub fn default_projector(twin: &Twin) -> f64 {
    if twin.device.projector.is_some() { 1.0 } else { 0.0 }
}

/// The dot pattern of a projector.
pub(super) fn dots(projector: &catalog::Projector) -> Dots {
    Dots::new(&DotProjector {
        model: projector.model.clone(),
        dots: projector.dots,
        field_rad: [projector.hfoi_deg, projector.vfoi_deg].map(f64::to_radians),
        dot_width_rad: projector.dot_width_mrad * 1e-3,
        brightness: projector.brightness,
    })
}

/// Checks that an option is from 0 to `max`.
#[expect(clippy::cast_possible_truncation, reason = "light is float32")]
fn within(name: &str, value: f64, max: f64) -> Result<f32, ParameterError> {
    if (0.0..=max).contains(&value) {
        return Ok(value as f32);
    }
    Err(ParameterError {
        name: name.to_owned(),
        what: format!("{value} is out of range"),
        remedy: format!("give 0 to {max}"),
    })
}
