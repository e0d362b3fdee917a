//! The annotators of Replicator: distances, normals, ids, bounding boxes, point clouds and colours.

mod boxes;
mod coverage;
mod normals;
mod pointcloud;
mod range;
mod segmentation;
mod semantics;
mod stencil;
mod surface;
#[cfg(test)]
mod tests;

use oaktwin_base::diagnostic::Finding;
use oaktwin_image::annotation::{Annotator, Frame};
use oaktwin_image::{Image, ZDepth};
use rayon::prelude::*;

use self::coverage::Coverage;
use self::stencil::Stencil;
use crate::shade::{Band, Shaded};
use crate::{Backend, Renderer, Transparent, View, Visibility};

pub(crate) use semantics::Semantics;
pub(crate) use surface::{Surface, SurfaceFinder};

/// Options of the annotators.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AnnotateOptions {
    /// Whether the point cloud includes points without a semantic label. The default is true; Replicator's
    /// `includeUnlabelled` defaults to false.
    pub unlabelled_points: bool,
    /// Whether outlines are antialiased in the colour image; otherwise each pixel has the colour at its centre.
    pub smooth_edges: bool,
    /// Whether the frame keeps the light of the colour image, for an image sensor.
    pub keeps_light: bool,
    /// What the ground truth of transparent surfaces is. Colours do not depend on it.
    pub transparent: Transparent,
}

impl Default for AnnotateOptions {
    fn default() -> Self {
        Self {
            unlabelled_points: true,
            smooth_edges: true,
            keeps_light: false,
            transparent: Transparent::Surface,
        }
    }
}

impl Renderer {
    /// Renders the requested annotators of a view; the findings are textures that cannot be shown.
    ///
    /// [`Annotator::CameraParams`] and the outputs of depth sensors are not produced here.
    #[must_use]
    pub fn annotate(
        &self,
        view: &View,
        annotators: &[Annotator],
        backend: Backend,
        options: &AnnotateOptions,
    ) -> (Frame, Vec<Finding>) {
        let wants = |annotator| annotators.contains(&annotator);
        let mut frame = Frame::default();
        let depth_is_enough = annotators.iter().all(|annotator| match annotator {
            Annotator::DistanceToImagePlane | Annotator::CameraParams => true,
            Annotator::DistanceToCamera => view.clips_along_axis(),
            other => other.is_depth_sensor(),
        });
        let is_through = options.transparent == Transparent::Through && self.cutouts().is_some();
        if depth_is_enough {
            if wants(Annotator::DistanceToImagePlane) || wants(Annotator::DistanceToCamera) {
                let z = match is_through {
                    true => self.past_clear(view, self.visibility(view, backend)).z,
                    false => self.depth(view, backend),
                };
                if wants(Annotator::DistanceToCamera) {
                    frame.distance_to_camera = Some(range::from_depth(&self.rays(view), &z));
                }
                frame.distance_to_image_plane = wants(Annotator::DistanceToImagePlane).then_some(z);
            }
            return (frame, self.unread_masks());
        }
        let mut seen = self.visibility(view, backend);
        let mut findings = Vec::new();
        if wants(Annotator::Rgb) {
            let (shaded, missing) = self.shade_seen(view, &seen, backend, *options);
            frame.apparent_depth = shaded.stretch.map(|stretch| stretched(&seen.z, &stretch));
            frame.rgb = Some(shaded.rgb);
            frame.light = shaded.light;
            findings = missing;
        }
        if is_through {
            seen = self.past_clear(view, seen);
        }
        self.annotate_seen(view, &seen, &wants, *options, &mut frame);
        findings.extend(self.unread_masks());
        let spare = self.spare_visibility(view, backend);
        let Visibility { z, hits } = seen;
        if wants(Annotator::DistanceToImagePlane) {
            spare.keep(None, hits);
            frame.distance_to_image_plane = Some(z);
        } else {
            spare.keep(Some(z), hits);
        }
        (frame, findings)
    }

    /// Returns the pixels that each group of instances covers regardless of occlusion, row by row: the amodal masks of objects.
    #[must_use]
    pub fn silhouettes(&self, view: &View, groups: &[Vec<u32>]) -> Vec<Vec<[u32; 2]>> {
        let rays = self.rays(view);
        let coverage = Coverage::new(view, &rays, self.cutouts());
        let size = view.camera.intrinsics.size;
        groups
            .par_iter()
            .map_init(
                || Stencil::new(size.width, size.height),
                |stencil, group| {
                    stencil.clear();
                    for instance in group {
                        coverage.add_instance(self.scene(), *instance, stencil);
                    }
                    stencil.places().collect()
                },
            )
            .collect()
    }

    fn shade_seen(
        &self,
        view: &View,
        seen: &Visibility,
        backend: Backend,
        options: AnnotateOptions,
    ) -> (Shaded, Vec<Finding>) {
        let corners = (options.smooth_edges).then(|| self.corners(view, backend));
        let rays = self.rays(view);
        let input = self.shading(view, &rays, seen);
        self.shader()
            .shade(input, corners.as_ref(), options.keeps_light, Band::Visible)
    }

    fn annotate_seen(
        &self,
        view: &View,
        seen: &Visibility,
        wants: &impl Fn(Annotator) -> bool,
        options: AnnotateOptions,
        frame: &mut Frame,
    ) {
        let scene = self.scene();
        let rays = &self.rays(view);
        if wants(Annotator::DistanceToCamera) {
            frame.distance_to_camera = Some(range::from_visibility(scene, view, rays, seen));
        }
        if wants(Annotator::Normals) {
            frame.normals = Some(normals::normals(scene, view, rays, seen));
        }
        if wants(Annotator::InstanceIdSegmentation) {
            frame.instance_id_segmentation = Some(segmentation::instances(scene, &seen.hits));
        }
        if wants(Annotator::SemanticSegmentation) {
            frame.semantic_segmentation = Some(segmentation::semantics(self.semantics(), &seen.hits));
        }
        let (tight, loose) = (
            wants(Annotator::BoundingBox2dTight),
            wants(Annotator::BoundingBox2dLoose),
        );
        if tight || loose {
            let coverage = Coverage::new(view, rays, self.cutouts());
            let boxes = boxes::boxes(scene, self.semantics(), &coverage, &seen.hits);
            frame.bounding_box_2d_tight = tight.then_some(boxes.tight);
            frame.bounding_box_2d_loose = loose.then_some(boxes.loose);
        }
        if wants(Annotator::Pointcloud) {
            let rgb = frame.rgb.as_ref();
            frame.pointcloud = Some(pointcloud::pointcloud(
                scene,
                self.semantics(),
                view,
                rays,
                seen,
                rgb,
                options.unlabelled_points,
            ));
        }
    }
}

/// Returns z-depths with a factor for each pixel.
fn stretched(z: &ZDepth, stretch: &Image<f32>) -> ZDepth {
    let mut apparent = z.0.clone();
    for (z, stretch) in apparent.pixels_mut().iter_mut().zip(stretch.pixels()) {
        *z *= stretch;
    }
    ZDepth(apparent)
}
