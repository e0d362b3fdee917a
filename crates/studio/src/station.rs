//! One OAK of a page: what was rendered and measured for it, so that a change repeats no more than it must.

use std::sync::Arc;

use oaktwin::camera::{Camera, ImageSize, RigidTransform};
use oaktwin::depth::{Capture, Engine};
use oaktwin::diagnostic::{Finding, add_new};
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::image::{Image, ImageView, ZDepth};
use oaktwin::pair::Pair;
use oaktwin::render::{
    AnnotateOptions, Backend, DepthSensorSource, Renderer, Transparent, View, sensor_input,
};
use oaktwin::sensor::{Input, Technology};

use crate::oak::Oak;
use crate::protocol::{Failure, FrameRequest, ImageName, OakState, RequestKind};
use crate::scene::LoadedScene;
use crate::size::{TRUTH, image_size};
use crate::studio::Studio;

/// The number of sizes that are kept: the coarse one of movements, and that at rest.
const KEPT: usize = 2;
/// The maximum side of the squares of pixels that share a colour.
const MAX_COLOR_STEP: u32 = 8;

/// Returns an error if nobody waits any more. The images that were made last may then be incomplete.
type Check<'a> = &'a dyn Fn() -> Result<(), Failure>;

/// An OAK of a page.
#[derive(Debug, Default)]
pub(crate) struct Station {
    /// The newest last.
    views: Vec<Seen>,
    measurement: Option<Measurement>,
    sent: Sent,
}

/// The rendered images that the page has.
#[derive(Debug, Default)]
struct Sent {
    frame: Option<Arc<Frame>>,
    pair: Option<Arc<Pair>>,
    names: Vec<ImageName>,
}

/// The scene and the view of rendered images.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    scene: String,
    view: View,
    color_step: u32,
    transparent: String,
    /// Whether the light of the colours is kept, because they are recorded.
    is_recorded: bool,
    /// Whether the engine measures at two times, and whether it models a technology: what it sees beside depth and colours.
    engine: [bool; 2],
}

/// The rendered images of a view.
#[derive(Debug)]
struct Seen {
    key: Key,
    frame: Arc<Frame>,
    /// The findings of the renderer.
    findings: Vec<Finding>,
    /// The pair, with the state that it was rendered for.
    pair: Option<(PairKey, Arc<Pair>)>,
    /// The images with recorded colours, with the state that they are recorded for.
    recorded: Option<(OakState, Arc<Frame>)>,
    /// Ground truth of the sensor's output camera, where it differs.
    reference: Option<(View, Arc<ZDepth>)>,
}

/// The state and the size of the images of a pair.
#[derive(Clone, Debug, PartialEq)]
struct PairKey(OakState, Option<[u32; 2]>);

/// A measurement with everything that explains it.
#[derive(Clone, Debug)]
pub(crate) struct Measurement {
    pub(crate) scene: Arc<LoadedScene>,
    pub(crate) engine: Arc<dyn Engine>,
    pub(crate) view: View,
    /// The camera that the measured image is of.
    pub(crate) output: View,
    /// The colour image and ground truth of the sensor's input.
    pub(crate) frame: Arc<Frame>,
    /// Ground truth of the output camera, if that differs from the input's.
    pub(crate) reference: Option<Arc<ZDepth>>,
    pub(crate) capture: Arc<Capture>,
    pub(crate) pair: Option<Arc<Pair>>,
    pub(crate) filters: Vec<String>,
    pub(crate) findings: Vec<Finding>,
    /// The transform from the other camera of the pair to the world, if there is one.
    pub(crate) other: Option<RigidTransform>,
}

impl Measurement {
    /// The ground truth that errors refer to.
    pub(crate) fn truth(&self) -> Option<ImageView<'_, f32>> {
        let own = self.frame.distance_to_image_plane.as_ref();
        let truth = self.reference.as_deref().or(own)?;
        Some((&truth.0).into())
    }

    /// The confidence from 0 to 255, if the engine has one.
    pub(crate) fn confidence(&self) -> Option<Image<u8>> {
        let levels = self
            .capture
            .extra::<Image<u16>>(Annotator::DepthSensorConfidence)?;
        Some(levels.map(|level| u8::try_from(*level).unwrap_or(u8::MAX)))
    }
}

impl Station {
    /// Renders and measures what a request asks for, until nobody waits any more.
    pub(crate) fn measure(
        &mut self,
        studio: &Studio,
        request: &FrameRequest,
        check: Check<'_>,
    ) -> Result<&Measurement, Failure> {
        let scene = studio.scenes.get(&request.scene)?;
        let size = image_size(request.size)?;
        let needs_pair = request.images.iter().any(|name| name.is_of_pair());
        let mut oak = Oak::new(studio, &request.state, size, needs_pair)?;
        let world_from_body = request.state.pose.transform()?;
        let number = request.state.frame;
        let view = oak.camera.view(&world_from_body);
        let color_step = request.color_step.unwrap_or(1).clamp(1, MAX_COLOR_STEP);
        let seen = self.see(&scene, &oak, &request.state, view, color_step, check)?;
        if let Some(cameras) = &oak.pair {
            let key = PairKey(light_of(&request.state), request.size);
            if seen.pair.as_ref().is_none_or(|(known, _)| *known != key) {
                let pair = cameras.capture(&scene.renderer, &world_from_body, number);
                // What was interrupted is arbitrary.
                check()?;
                seen.pair = Some((key, Arc::new(pair)));
            }
        }
        let pair = seen
            .pair
            .as_ref()
            .filter(|_| oak.pair.is_some())
            .map(|(_, pair)| Arc::clone(pair));
        let input = sensor_input(&oak.sensor, &seen.frame, number, pair.as_deref());
        let mut input = input.map_err(|error| Failure::of("engine", &error))?;
        if let Input::Depth(shot) = &mut input {
            shot.color_step = color_step;
        }
        let offered = oak.sensor.engine().outputs();
        let extras: Vec<Annotator> = [Annotator::DepthSensorConfidence, Annotator::DepthSensorReason]
            .into_iter()
            .filter(|one| offered.contains(one))
            .collect();
        let mut findings = oak.sensor.engine().inspect(&input);
        check()?;
        let captured = oak.sensor.capture(input, &extras);
        let capture = captured.map_err(|error| Failure::of(&error.name, &error))?;
        check()?;
        let output = oak.sensor.output_camera(&view.camera);
        let output_view = View {
            camera: output.camera,
            world_from_camera: view.world_from_camera * output.input_from_output(),
            ..view
        };
        let reference = match output_view == view {
            true => None,
            false => {
                Some(seen.reference(&scene.renderer, output_view, request.state.transparent()?, check)?)
            }
        };
        findings.append(&mut oak.findings);
        findings.extend(seen.findings.iter().cloned());
        findings.extend(pair.iter().flat_map(|pair| pair.findings.clone()));
        let mut unique: Vec<Finding> = Vec::new();
        add_new(&mut unique, findings);
        let filters = oak.sensor.filters().filters().iter();
        let measurement = Measurement {
            engine: Arc::clone(oak.sensor.engine()),
            view,
            output: output_view,
            frame: seen.recorded(&oak, &request.state),
            reference,
            capture: Arc::new(capture),
            pair,
            filters: filters.map(ToString::to_string).collect(),
            findings: unique,
            other: other_camera(&oak, &world_from_body),
            scene,
        };
        Ok(self.measurement.insert(measurement))
    }

    /// Records that an image of the last measurement is sent, and returns whether the page has it already.
    pub(crate) fn send(&mut self, name: ImageName) -> bool {
        let Some(measurement) = &self.measurement else {
            return false;
        };
        let is_same = match name {
            ImageName::Color | ImageName::Depth => keep(&mut self.sent.frame, Some(&measurement.frame)),
            ImageName::Left | ImageName::Right => keep(&mut self.sent.pair, measurement.pair.as_ref()),
            ImageName::Reference | ImageName::Sensor | ImageName::Confidence | ImageName::Reason => {
                return false;
            }
        };
        if !is_same {
            self.sent
                .names
                .retain(|known| known.is_of_pair() != name.is_of_pair());
        }
        let is_known = self.sent.names.contains(&name);
        if !is_known {
            self.sent.names.push(name);
        }
        is_known
    }

    /// The last measurement.
    pub(crate) fn last(&self) -> Option<&Measurement> {
        self.measurement.as_ref()
    }

    /// Returns what a view sees, rendered once.
    fn see(
        &mut self,
        scene: &LoadedScene,
        oak: &Oak,
        state: &OakState,
        view: View,
        color_step: u32,
        check: Check<'_>,
    ) -> Result<&mut Seen, Failure> {
        let engine = oak.sensor.engine();
        let key = Key {
            scene: scene.info.id.clone(),
            view,
            color_step,
            transparent: state.transparent.clone(),
            is_recorded: state.color_imager.is_some(),
            engine: [engine.ages_s().is_some(), engine.kind().models.is_some()],
        };
        let known = self.views.iter().position(|seen| seen.key == key);
        let seen = match known {
            Some(index) => self.views.remove(index),
            None => {
                let (frame, findings) = match color_step {
                    1 => oak.rig.annotate(&scene.renderer, 0, &view, &TRUTH),
                    step => with_coarse_color(&scene.renderer, oak, &view, step),
                };
                check()?;
                Seen {
                    key,
                    frame: Arc::new(frame),
                    findings,
                    pair: None,
                    recorded: None,
                    reference: None,
                }
            }
        };
        if self.views.len() >= KEPT {
            self.views.remove(0);
        }
        self.views.push(seen);
        let last = self.views.len() - 1;
        Ok(&mut self.views[last])
    }
}

/// Measures a state once, for something that is taken away.
pub(crate) fn measured(
    studio: &Studio,
    scene: &str,
    state: &OakState,
    size: Option<[u32; 2]>,
    images: Vec<ImageName>,
) -> Result<Measurement, Failure> {
    let request = FrameRequest {
        _kind: RequestKind::Frame,
        id: 0,
        oak: String::new(),
        scene: scene.to_owned(),
        state: state.clone(),
        size,
        images,
        region: [0.0, 0.0, 1.0, 1.0],
        color_step: None,
        is_preview: false,
    };
    Station::default().measure(studio, &request, &|| Ok(())).cloned()
}

/// Renders ground truth, with colours that are interpolated between those of every `step` pixels: shading takes most of the time.
/// Copies would have no texture between neighbours.
fn with_coarse_color(renderer: &Renderer, oak: &Oak, view: &View, step: u32) -> (Frame, Vec<Finding>) {
    let truth = [Annotator::DistanceToImagePlane];
    let (mut frame, mut findings) = oak.rig.annotate(renderer, 0, view, &truth);
    let ImageSize { width, height } = view.camera.intrinsics.size;
    let size = ImageSize::new(width.div_ceil(step), height.div_ceil(step));
    let coarse = View {
        camera: Camera::new(
            view.camera.intrinsics.resized_about_centre(size, false),
            view.camera.lens,
        ),
        ..*view
    };
    let options = AnnotateOptions::default();
    let (colors, more) = renderer.annotate(&coarse, &[Annotator::Rgb], Backend::Auto, &options);
    findings.extend(more);
    frame.rgb = colors.rgb.map(|colors| enlarged(&colors, width, height));
    (frame, findings)
}

/// Enlarges an image by bilinear interpolation.
fn enlarged(small: &Image<[u8; 4]>, width: u32, height: u32) -> Image<[u8; 4]> {
    /// The steps of a weight.
    const STEPS: u32 = 256;
    // The two pixels around each pixel of an axis, and the weight of the second.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive and inside the image"
    )]
    let places = |length: u32, from: u32| -> Vec<(u32, u32, u32)> {
        let place = |i: u32| {
            let at = (f64::from(i) + 0.5) * f64::from(from) / f64::from(length) - 0.5;
            let at = at.clamp(0.0, f64::from(from.saturating_sub(1)));
            let first = at as u32;
            let weight = ((at - f64::from(first)) * f64::from(STEPS)) as u32;
            (first, (first + 1).min(from.saturating_sub(1)), weight)
        };
        (0..length).map(place).collect()
    };
    let (columns, rows) = (places(width, small.width()), places(height, small.height()));
    let pixel = |x: u32, y: u32| small.get(x, y).copied().unwrap_or_default();
    let mut pixels = Vec::with_capacity(columns.len() * rows.len());
    for &(top, bottom, down) in &rows {
        for &(left, right, across) in &columns {
            let [a, b, c, d] = [
                pixel(left, top),
                pixel(right, top),
                pixel(left, bottom),
                pixel(right, bottom),
            ];
            pixels.push(std::array::from_fn(|i| {
                let [a, b, c, d] = [a, b, c, d].map(|pixel| u32::from(pixel[i]));
                let upper = a * (STEPS - across) + b * across;
                let lower = c * (STEPS - across) + d * across;
                let sum = upper * (STEPS - down) + lower * down;
                u8::try_from((sum + STEPS * STEPS / 2) / (STEPS * STEPS)).unwrap_or(u8::MAX)
            }));
        }
    }
    Image::new(width, height, pixels).unwrap_or_else(|| Image::filled(width, height, [0; 4]))
}

impl Seen {
    /// Returns the images with the colours that the camera records. Those of movements are exact.
    fn recorded(&mut self, oak: &Oak, state: &OakState) -> Arc<Frame> {
        if self.frame.light.is_none() {
            return Arc::clone(&self.frame);
        }
        // What the engine does with colours leaves them as they are.
        let state = light_of(state);
        match &self.recorded {
            Some((known, frame)) if *known == state => Arc::clone(frame),
            _ => {
                let mut frame = (*self.frame).clone();
                oak.rig.record_colors(0, state.frame, &mut frame);
                let frame = Arc::new(frame);
                self.recorded = Some((state, Arc::clone(&frame)));
                frame
            }
        }
    }

    fn reference(
        &mut self,
        renderer: &Renderer,
        view: View,
        transparent: Transparent,
        check: Check<'_>,
    ) -> Result<Arc<ZDepth>, Failure> {
        Ok(match &self.reference {
            Some((known, depth)) if *known == view => Arc::clone(depth),
            _ => {
                let options = AnnotateOptions {
                    transparent,
                    ..AnnotateOptions::default()
                };
                let truth = [Annotator::DistanceToImagePlane];
                let (frame, _) = renderer.annotate(&view, &truth, Backend::Auto, &options);
                check()?;
                let depth = frame.distance_to_image_plane;
                let depth = Arc::new(depth.unwrap_or_else(|| renderer.depth(&view, Backend::Auto)));
                self.reference = Some((view, Arc::clone(&depth)));
                depth
            }
        })
    }
}

/// Replaces a shared image, and returns whether it was the same.
fn keep<T>(known: &mut Option<Arc<T>>, new: Option<&Arc<T>>) -> bool {
    let is_same = match (known.as_ref(), new) {
        (Some(known), Some(new)) => Arc::ptr_eq(known, new),
        _ => false,
    };
    *known = new.cloned();
    is_same
}

/// The part of a state that determines the images of the pair.
fn light_of(state: &OakState) -> OakState {
    let bias = state.parameters.get_key_value("bias");
    OakState {
        engine: String::new(),
        preset: None,
        filters: None,
        parameters: bias
            .map(|(name, value)| (name.clone(), value.clone()))
            .into_iter()
            .collect(),
        extended_disparity: false,
        ..state.clone()
    }
}

/// The pose of the right camera, from which the left one's view may be occluded.
fn other_camera(oak: &Oak, world_from_body: &RigidTransform) -> Option<RigidTransform> {
    let is_stereo = oak.sensor.engine().kind().models == Some(Technology::Stereo);
    let own = |prim: &str| {
        oak.twin
            .depth_sensors
            .iter()
            .find(|sensor| sensor.spec.prim == prim)
    };
    let pair = match &oak.camera.depth_sensor {
        Some(DepthSensorSource::Twin(prim)) => own(prim)?.spec.pair()?,
        _ => return None,
    };
    let right = oak.twin.camera(pair.1).filter(|_| is_stereo)?;
    Some(*world_from_body * right.body_from_camera)
}
