//! Renders and measures what a rig sees.

use std::sync::Arc;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_dataset::{self as dataset, CameraParams, LayerData, Shot, ShotLayer};
use oaktwin_depth::Engine;
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{Image, png};
use oaktwin_render::{AnnotateOptions, Backend, Renderer, View};

use super::during::{Asked, During};
use super::findings::not_produced;
use super::{PairUse, Rig, RigError};
use crate::pair::Pair;
use crate::render::PlacedCamera;
use crate::render::depth_sensor::{scene_annotators, sense_frame};
use crate::render::shutter::{Later, Moments, Passing, Shutter, Twist};
use crate::render::sweep::SweptSensors;
use crate::sensor::{EngineInput, Sensor, sensor_view};

impl Rig {
    /// Renders a frame of this number with the body, or each camera of a stage, at a pose in metres, and measures its depth: a shot for
    /// each camera. Without a pose, the cameras are where [`Rig::at`] or the stage put them.
    ///
    /// Frames of different numbers differ in their noise, and equal frames are equal.
    ///
    /// # Errors
    /// Returns an error if a depth sensor cannot measure what was rendered.
    pub fn shoot(
        &mut self,
        renderer: &Renderer,
        world_from_body: Option<&RigidTransform>,
        number: u64,
    ) -> Result<(Vec<Shot>, Vec<Finding>), RigError> {
        let annotators = self.annotators.clone();
        let mut shots = Vec::new();
        let mut findings = Vec::new();
        for index in 0..self.cameras.len() {
            let (shot, more) = self.shoot_camera(renderer, index, world_from_body, number, &annotators)?;
            shots.push(shot);
            findings.extend(more);
        }
        Ok((shots, findings))
    }

    /// Renders and measures a frame as [`Rig::shoot`] does, of a scene and a rig in motion: with a [shutter](super::RigSpec::shutter), colours and
    /// the images of the pair take time.
    ///
    /// # Errors
    /// Returns an error if a depth sensor cannot measure what was rendered, or the scene cannot be read at a time.
    pub fn expose(
        &mut self,
        moments: &mut dyn Moments,
        number: u64,
    ) -> Result<(Vec<Shot>, Vec<Finding>), RigError> {
        let annotators = self.annotators.clone();
        let mut shots = Vec::new();
        let mut findings = Vec::new();
        for index in 0..self.cameras.len() {
            let (shot, more) = self.expose_camera(moments, index, number, &annotators)?;
            shots.push(shot);
            findings.extend(more);
        }
        Ok((shots, findings))
    }

    /// Renders and measures a frame of one camera, with other annotators than the rig's.
    ///
    /// # Errors
    /// Returns an error if the depth sensor cannot measure what was rendered.
    pub fn shoot_camera(
        &mut self,
        renderer: &Renderer,
        index: usize,
        world_from_body: Option<&RigidTransform>,
        number: u64,
        annotators: &[Annotator],
    ) -> Result<(Shot, Vec<Finding>), RigError> {
        let mut still = Passing {
            renderer,
            world_from_body: *world_from_body.unwrap_or(&self.cameras[index].world_from_mount),
            twist: Twist::default(),
        };
        self.take(&mut still, index, number, annotators, None)
    }

    /// Renders and measures a frame of one camera in motion, as [`Rig::expose`] does.
    ///
    /// # Errors
    /// Returns the errors of [`Rig::expose`].
    pub fn expose_camera(
        &mut self,
        moments: &mut dyn Moments,
        index: usize,
        number: u64,
        annotators: &[Annotator],
    ) -> Result<(Shot, Vec<Finding>), RigError> {
        let mut moments = Later {
            moments,
            offset_s: self.offset_s(index),
        };
        self.take(&mut moments, index, number, annotators, self.shutter)
    }

    /// Renders annotators of a view, with all that the engine of a camera's depth sensor and its image sensor see: the inputs of
    /// [`Rig::record_colors`] and of [`sensor_input`](crate::render::sensor_input).
    #[must_use]
    pub fn annotate(
        &self,
        renderer: &Renderer,
        index: usize,
        view: &View,
        annotators: &[Annotator],
    ) -> (Frame, Vec<Finding>) {
        let options = AnnotateOptions {
            keeps_light: index < self.imagers.len(),
            ..self.annotate_options()
        };
        let (mut frame, findings) = renderer.annotate(view, annotators, self.backend, &options);
        let sensor = self.sensors.get(index).and_then(Option::as_ref);
        add_inputs(
            &engines(sensor, None, index),
            renderer,
            view,
            self.backend,
            &mut frame,
        );
        (frame, findings)
    }

    /// Replaces the colours of a frame by those that the image sensor of a camera records of them, if colours are recorded.
    pub fn record_colors(&self, index: usize, number: u64, frame: &mut Frame) {
        if let (Some(imager), Some(camera)) = (self.imagers.get(index), self.cameras.get(index)) {
            imager.record(&camera.camera, number, frame);
        }
    }

    fn annotate_options(&self) -> AnnotateOptions {
        AnnotateOptions {
            transparent: self.transparent,
            ..AnnotateOptions::default()
        }
    }

    fn take(
        &mut self,
        moments: &mut dyn Moments,
        index: usize,
        number: u64,
        annotators: &[Annotator],
        shutter: Option<Shutter>,
    ) -> Result<(Shot, Vec<Finding>), RigError> {
        let camera = &self.cameras[index];
        let options = self.annotate_options();
        let is_requested = annotators.iter().any(|one| one.is_depth_sensor());
        let sensor = self.sensors[index].as_mut().filter(|_| is_requested);
        let swept = self.swept.as_mut().filter(|swept| swept.has(index));
        let engines = engines(sensor.as_deref(), swept.as_deref(), index);
        let is_matched = (engines.iter()).any(|engine| engine.kind().input == EngineInput::Pair);
        let is_described = self.pair_use == PairUse::Described;
        let pair = self.pair.as_ref().filter(|_| is_matched || is_described);
        let imager = (self.imagers.get(index)).filter(|_| annotators.contains(&Annotator::Rgb));
        let needed = scene_annotators(annotators, sensor.is_some() || swept.is_some());
        let options = AnnotateOptions {
            keeps_light: imager.is_some(),
            ..options
        };
        let asked = Asked {
            camera,
            index,
            has_colours: needed.contains(&Annotator::Rgb),
            pair: pair.map(|pair| &**pair),
            ages_s: sensor.as_ref().and_then(|sensor| sensor.engine().ages_s()),
            backend: self.backend,
        };
        let mut during = During::of(moments, shutter, &asked)?;
        // The time of the frame, last.
        let (renderer, mount) = moments.at(0.0, index)?;
        let view = camera.view(&mount);
        let lights = during.lights.take();
        let pair = pair.map(|pair| match lights {
            Some(lights) => pair.record(&pair.with_truth(lights, renderer, &mount), number),
            None => pair.capture(renderer, &mount, number),
        });
        let (mut frame, mut findings) = renderer.annotate(&view, &needed, self.backend, &options);
        during.put(&camera.camera, &mut frame, &mut findings);
        add_inputs(&engines, renderer, &view, self.backend, &mut frame);
        let sheet = match swept {
            Some(swept) => swept.sheet(index, &frame, number, pair.as_ref())?,
            None => None,
        };
        let described = described(camera, &view, renderer.scene().meters_per_unit.0);
        let mut sensor_view_of = None;
        if let Some(sensor) = sensor {
            let (seen, missing) = sensed(
                sensor,
                camera,
                &described,
                number,
                pair.as_ref(),
                annotators,
                &mut frame,
            )?;
            findings.extend(missing.filter(|_| !self.are_outputs_optional));
            sensor_view_of = Some(seen);
        }
        if let Some(imager) = imager {
            imager.record(&view.camera, number, &mut frame);
        }
        keep_annotations(annotators, &mut frame);
        findings.extend(pair.iter().flat_map(|pair| pair.findings.clone()));
        let stereo = (pair.as_ref().filter(|_| is_described)).map(|pair| pair.images(renderer, &view));
        let written = pair.filter(|_| self.pair_use == PairUse::Written);
        let wants_params = annotators.contains(&Annotator::CameraParams);
        let shot = Shot {
            layers: layers(sheet, written),
            camera_params: wants_params.then(|| CameraParams {
                transparent: Some(self.transparent.name()),
                ..CameraParams::new(&described)
            }),
            sensor_params: sensor_view_of
                .as_ref()
                .filter(|_| wants_params)
                .map(CameraParams::new),
            view: Some(described),
            stereo,
            sensor_view: sensor_view_of,
            camera: index,
            world_from_mount: mount,
            render_product: (self.cameras.len() > 1).then(|| camera.folder.clone()),
            ..Shot::new(frame, number)
        };
        Ok((shot, findings))
    }
}

/// Adds the outputs of a sensor to a frame. Returns the view of its output, and a finding about what its engine cannot make.
fn sensed(
    sensor: &mut Sensor,
    camera: &PlacedCamera,
    described: &dataset::FrameCamera,
    number: u64,
    pair: Option<&Pair>,
    annotators: &[Annotator],
    frame: &mut Frame,
) -> Result<(dataset::FrameCamera, Option<Finding>), RigError> {
    let missing = sense_frame(sensor, &described.camera, number, pair, annotators, frame)?;
    let view = sensor_view(&sensor.output_camera(&described.camera), described);
    Ok((view, not_produced(&camera.path, sensor, &missing)))
}

fn layers(sheet: Option<Image<[u8; 3]>>, pair: Option<Pair>) -> Vec<ShotLayer> {
    let sheet = sheet.into_iter().map(sheet_layer);
    sheet.chain(pair.into_iter().flat_map(pair_layers)).collect()
}

/// Returns the engines that measure with a camera.
fn engines(sensor: Option<&Sensor>, swept: Option<&SweptSensors>, camera: usize) -> Vec<Arc<dyn Engine>> {
    let own = sensor.map(|sensor| Arc::clone(sensor.engine()));
    let swept = swept.into_iter().flat_map(|swept| swept.engines(camera));
    own.into_iter().chain(swept).collect()
}

/// Adds what engines see beside depth and colours.
fn add_inputs(
    engines: &[Arc<dyn Engine>],
    renderer: &Renderer,
    view: &View,
    backend: Backend,
    frame: &mut Frame,
) {
    if engines.iter().any(|engine| engine.ages_s().is_some()) {
        frame.returns = renderer.returns(view, backend);
    }
    if engines.iter().any(|engine| engine.kind().models.is_some()) {
        frame.infrared = renderer.infrared(view, backend);
    }
}

/// Removes what only sensors needed.
fn keep_annotations(annotators: &[Annotator], frame: &mut Frame) {
    frame.apparent_depth = None;
    frame.returns = None;
    frame.infrared = None;
    frame.radial_velocities = None;
    for input in [Annotator::Rgb, Annotator::DistanceToImagePlane] {
        if !annotators.contains(&input) {
            frame.take(input);
        }
    }
}

fn sheet_layer(sheet: Image<[u8; 3]>) -> ShotLayer {
    ShotLayer {
        folder: "sweep",
        name: "sweep".to_owned(),
        data: LayerData::Png(Box::new(move || png::encode(&sheet))),
    }
}

fn pair_layers(pair: Pair) -> impl Iterator<Item = ShotLayer> {
    let images = [
        ("left", pair.left),
        ("right", pair.right),
        ("rectified_left", pair.rectified_left),
        ("rectified_right", pair.rectified_right),
    ];
    images.into_iter().map(|(name, image)| ShotLayer {
        folder: "pair",
        name: name.to_owned(),
        data: LayerData::Png(Box::new(move || image.to_png())),
    })
}

fn described(camera: &PlacedCamera, view: &View, meters_per_unit: f64) -> dataset::FrameCamera {
    let (attributes, clip) = (&camera.attributes, &camera.clip);
    dataset::FrameCamera {
        optics: attributes.optics,
        camera: view.camera,
        world_from_camera: view.world_from_camera,
        clipping_range: [clip.near_m, clip.far_m].map(|metres| metres / meters_per_unit),
        meters_per_unit,
        focus_distance: attributes.focus_distance,
        f_stop: attributes.f_stop,
    }
}
