use oaktwin_image::annotation::Annotator;
use oaktwin_image::contact_sheet::{Column, contact_sheet};
use oaktwin_image::{Image, ZDepth, preview};
use oaktwin_pipeline::progress::{Progress, Watch};

use super::Generator;
use crate::GenerateError;
use crate::frame::FrameMaker;

/// The number of frames in a row.
const ROW: usize = 4;

impl Generator {
    /// Draws a contact sheet of the first frames: colour, depth and measured depth of the first camera. If `watch` interrupts the
    /// task, it has fewer frames.
    ///
    /// # Errors
    /// Returns an error if a frame cannot be made.
    pub fn preview(&self, frames: u64, watch: &Watch<'_>) -> Result<Image<[u8; 3]>, GenerateError> {
        let mut maker = FrameMaker::new(&self.context);
        let mut columns = Vec::new();
        let total = self.context.file.recipe.frames;
        let total = frames.clamp(1, total);
        for frame in 0..total {
            if watch(Progress { done: frame, total }).is_break() {
                break;
            }
            let made = maker.make_with(
                frame,
                &[
                    Annotator::Rgb,
                    Annotator::DistanceToImagePlane,
                    Annotator::DepthSensorDistance,
                ],
            )?;
            let Some(shot) = made.shots.into_iter().next() else {
                continue;
            };
            let (Some(rgb), Some(depth)) = (shot.frame.rgb, shot.frame.distance_to_image_plane) else {
                continue;
            };
            let nothing = || ZDepth(Image::filled(depth.0.width(), depth.0.height(), 0.0));
            columns.push(Column {
                title: format!("frame {frame}"),
                measured: shot.frame.depth_sensor_distance.unwrap_or_else(nothing),
                rgb,
                depth,
            });
        }
        let ranges = columns
            .iter()
            .filter_map(|column| preview::range(&column.depth.0));
        let range = ranges
            .reduce(|(a, b), (c, d)| (a.min(c), b.max(d)))
            .unwrap_or((0.0, 1.0));
        let rows: Vec<Image<[u8; 3]>> = columns.chunks(ROW).map(|row| contact_sheet(row, range)).collect();
        Ok(stacked(&rows))
    }
}

/// Puts images below each other.
fn stacked(rows: &[Image<[u8; 3]>]) -> Image<[u8; 3]> {
    let width = rows.iter().map(Image::width).max().unwrap_or(0);
    let height = rows.iter().map(Image::height).sum();
    let mut sheet = Image::filled(width, height, oaktwin_image::contact_sheet::PAPER);
    let mut top = 0;
    for row in rows {
        for (line, pixels) in row.pixels().chunks(row.width().max(1) as usize).enumerate() {
            let start = (top + line) * width as usize;
            sheet.pixels_mut()[start..start + pixels.len()].copy_from_slice(pixels);
        }
        top += row.height() as usize;
    }
    sheet
}
