//! Pictures of a motion.

use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, colormap};
use oaktwin_pipeline::render::{AnnotateOptions, Backend, Renderer, View};

use super::picture::{grey, own_view, sheet};
use super::{Candidate, Carrier, CoverageError, MountCoverage, Region, picture};

/// The shares of postures in the legend.
const LEGEND: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

impl Carrier<'_> {
    /// Draws the [picture] of the posture in which a mount measures most. The robot then stays in this posture.
    ///
    /// # Errors
    /// Returns an error if the region is invalid or has no surface.
    pub fn picture(
        &self,
        renderer: &mut Renderer,
        region: &Region,
        mount: &Candidate<'_>,
        measured: &MountCoverage,
    ) -> Result<Image<[u8; 3]>, CoverageError> {
        let best = measured.best();
        let candidate = self.carry(renderer, best, mount);
        let mut region = region.clone();
        region.without.push(self.robot.path().to_owned());
        let shares = measured.postures.get(best).map(|posture| &posture.shares);
        picture(
            renderer,
            &region,
            &candidate,
            shares.unwrap_or(&measured.together),
        )
    }

    /// Draws in which share of the postures each pixel of a mount's image shows the robot itself, over the image of the posture in which it
    /// measures most. The robot then stays in that posture.
    #[must_use]
    pub fn own_robot_picture(
        &self,
        renderer: &mut Renderer,
        mount: &Candidate<'_>,
        measured: &MountCoverage,
    ) -> Image<[u8; 3]> {
        let mut counts: Vec<u32> = Vec::new();
        for posture in 0..self.postures.len() {
            let candidate = self.carry(renderer, posture, mount);
            let hits = renderer.visibility(&own_view(&candidate), Backend::Auto).hits;
            counts.resize(hits.pixels().len(), 0);
            for (count, hit) in counts.iter_mut().zip(hits.pixels()) {
                *count += u32::from(!hit.is_miss() && self.robot.link_of(hit.instance as usize).is_some());
            }
        }
        let view: View = own_view(&self.carry(renderer, measured.best(), mount));
        let options = AnnotateOptions::default();
        let (frame, _) = renderer.annotate(&view, &[Annotator::Rgb], Backend::Auto, &options);
        let size = view.camera.intrinsics.size;
        let shown = frame.rgb.map(|rgb| rgb.map(|pixel| [grey(*pixel, 1.0); 3]));
        let mut panel = shown.unwrap_or_else(|| Image::filled(size.width, size.height, [0; 3]));
        let postures = self.postures.len().max(1) as f64;
        for (pixel, count) in panel.pixels_mut().iter_mut().zip(&counts) {
            if *count > 0 {
                let color = color(f64::from(*count) / postures);
                *pixel = std::array::from_fn(|i| pixel[i] / 3 + color[i] / 3 * 2);
            }
        }
        let heading = format!(
            "{}, {}: {:.1} % of the pixels show the robot itself, on average over {} postures",
            measured.model,
            measured.name,
            100.0 * measured.own_robot,
            self.postures.len()
        );
        let legend = LEGEND.map(|share| (format!("{:.0} %", 100.0 * share), color(share)));
        sheet(
            &heading,
            &[("The robot in its own way, by the share of the postures", panel)],
            &legend,
        )
    }
}

impl MountCoverage {
    /// The index of the posture that measures most.
    fn best(&self) -> usize {
        let measured = self.postures.iter().map(|posture| posture.shares.measured);
        let best = measured
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)));
        best.map_or(0, |(index, _)| index)
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share")]
fn color(share: f64) -> [u8; 3] {
    colormap::turbo()[(255.0 * share.clamp(0.0, 1.0)) as usize]
}
