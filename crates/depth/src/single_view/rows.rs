use super::output::SingleViewOutput;
use super::plan::SingleViewPlan;

/// Rows of the outputs.
#[derive(Debug)]
pub(super) struct Rows<'a> {
    pub(super) first: usize,
    pub(super) distance: &'a mut [f32],
    pub(super) positions: Option<&'a mut [[f32; 4]]>,
    pub(super) colors: Option<&'a mut [[u8; 4]]>,
    pub(super) imager: Option<&'a mut [f32]>,
    pub(super) view: Option<&'a mut [[u8; 4]]>,
    pub(super) reasons: Option<&'a mut [u8]>,
    pub(super) confidence: Option<&'a mut [u16]>,
}

impl<'a> Rows<'a> {
    /// Splits an image into parts of `rows` rows.
    pub(super) fn of(output: &'a mut SingleViewOutput, plan: &SingleViewPlan, rows: usize) -> Vec<Self> {
        let length = rows * plan.width;
        let mut positions = output
            .positions
            .as_mut()
            .map(|image| image.pixels_mut().chunks_mut(length));
        let mut colors = output
            .colors
            .as_mut()
            .map(|image| image.pixels_mut().chunks_mut(length));
        let mut imager = output
            .imager
            .as_mut()
            .map(|image| image.pixels_mut().chunks_mut(length));
        let mut view = output
            .view
            .as_mut()
            .map(|image| image.pixels_mut().chunks_mut(length));
        let mut reasons = output
            .reasons
            .as_mut()
            .map(|codes| codes.0.pixels_mut().chunks_mut(length));
        let mut confidence = output
            .confidence
            .as_mut()
            .map(|levels| levels.pixels_mut().chunks_mut(length));
        let parts = output.distance.0.pixels_mut().chunks_mut(length);
        parts
            .enumerate()
            .map(|(i, distance)| Self {
                first: i * rows,
                distance,
                positions: positions.as_mut().and_then(Iterator::next),
                colors: colors.as_mut().and_then(Iterator::next),
                imager: imager.as_mut().and_then(Iterator::next),
                view: view.as_mut().and_then(Iterator::next),
                reasons: reasons.as_mut().and_then(Iterator::next),
                confidence: confidence.as_mut().and_then(Iterator::next),
            })
            .collect()
    }
}
