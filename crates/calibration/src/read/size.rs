//! The image size of a camera.

use oaktwin_camera::ImageSize;

use crate::reader::{Field, Reader};

/// The image sizes of published calibrations.
const USUAL: [ImageSize; 6] = [
    ImageSize::new(640, 480),
    ImageSize::new(1280, 800),
    ImageSize::new(1440, 1080),
    ImageSize::new(1920, 1080),
    ImageSize::new(1920, 1200),
    ImageSize::new(3840, 2160),
];
/// The largest distance of a principal point from the centre of its image, as a fraction of the side. It is below 0.04 in published
/// calibrations of intact units.
const OFF_CENTRE: f64 = 0.05;

/// Reads the image size. Files that `DepthAI` converted from its first calibration format have zeros: the size is then the usual one whose
/// centre is next to the principal point.
pub(super) fn size(
    reader: &mut Reader,
    info: &Field<'_>,
    matrix: Option<[[f64; 3]; 3]>,
) -> Option<ImageSize> {
    let is_unknown = ["width", "height"].iter().all(|key| {
        let field = info.get(key);
        field.is_some_and(|field| Reader::default().number(&field) == Some(0.0))
    });
    if is_unknown {
        let [[_, _, cx], [_, _, cy], _] = matrix?;
        return usual(reader, info, [cx, cy]);
    }
    let mut side = |key| {
        let field = reader.require(info, key)?;
        let pixels = reader.integer(&field, 1, u16::MAX.into())?;
        u32::try_from(pixels).ok()
    };
    let (width, height) = (side("width"), side("height"));
    Some(ImageSize::new(width?, height?))
}

fn usual(reader: &mut Reader, info: &Field<'_>, [cx, cy]: [f64; 2]) -> Option<ImageSize> {
    let off = |size: ImageSize| {
        let side = |c: f64, side: u32| (c / f64::from(side) - 0.5).abs();
        side(cx, size.width).max(side(cy, size.height))
    };
    let nearest = USUAL.into_iter().min_by(|a, b| off(*a).total_cmp(&off(*b)));
    let place = info.key_path("width");
    match nearest.filter(|size| off(*size) <= OFF_CENTRE) {
        Some(size) => {
            let message = format!(
                "width and height are 0; {size} is assumed, because its centre is next to the principal point"
            );
            reader.warn(
                "size-assumed",
                place,
                message,
                "set them to the size at which the camera was calibrated",
            );
            Some(size)
        }
        None => {
            let message = format!(
                "line {}: width and height are 0, and the principal point ({cx:.1}, {cy:.1}) is next to the centre of no usual size",
                info.node.at.line
            );
            reader.error(
                "no-size",
                place,
                message,
                "set them to the size at which the camera was calibrated",
            );
            None
        }
    }
}
