//! Images that are too large, told before they are made.

use oaktwin_camera::ImageSize;
use oaktwin_image::annotation::Annotator;

/// The most pixels of an image.
pub const MAX_PIXELS: u64 = 1 << 31;

/// An image that cannot be rendered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SizeError {
    /// It has no pixel.
    #[error("{}; {}", self.what(), self.remedy())]
    Empty(ImageSize),
    /// It has more than [`MAX_PIXELS`].
    #[error("{}; {}", self.what(), self.remedy())]
    TooLarge(ImageSize),
}

impl SizeError {
    /// What is wrong.
    #[must_use]
    pub fn what(&self) -> String {
        match self {
            Self::Empty(size) => format!("an image of {size} has no pixel"),
            Self::TooLarge(size) => format!("an image of {size} has more than 2^31 pixels"),
        }
    }

    /// What to do.
    #[must_use]
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Empty(_) => "give it at least one",
            Self::TooLarge(_) => "choose a smaller resolution",
        }
    }
}

/// Refuses images without pixels and those with more than [`MAX_PIXELS`].
///
/// # Errors
/// It is one of them.
pub fn check_size(size: ImageSize) -> Result<(), SizeError> {
    match u64::from(size.width) * u64::from(size.height) {
        0 => Err(SizeError::Empty(size)),
        pixels if pixels > MAX_PIXELS => Err(SizeError::TooLarge(size)),
        _ => Ok(()),
    }
}

/// How much memory a frame takes on its way to a file, bytes: what is seen, its annotations, and their files, while
/// the frame before it is still written.
#[must_use]
pub fn frame_bytes(size: ImageSize, annotators: &[Annotator]) -> u64 {
    let pixels = u64::from(size.width) * u64::from(size.height);
    12 * pixels + 4 * annotation_bytes(size, annotators)
}

/// How much memory a recording takes for a frame, bytes: its rays, its largest message, and what that is compressed to.
#[must_use]
pub fn record_bytes(size: ImageSize) -> u64 {
    40 * u64::from(size.width) * u64::from(size.height)
}

/// How much memory what these annotators say of a frame takes, bytes.
#[must_use]
pub fn annotation_bytes(size: ImageSize, annotators: &[Annotator]) -> u64 {
    let pixels = u64::from(size.width) * u64::from(size.height);
    pixels
        * annotators
            .iter()
            .map(|annotator| pixel_bytes(*annotator))
            .sum::<u64>()
}

fn pixel_bytes(annotator: Annotator) -> u64 {
    match annotator {
        Annotator::Rgb
        | Annotator::DistanceToImagePlane
        | Annotator::DistanceToCamera
        | Annotator::InstanceIdSegmentation
        | Annotator::SemanticSegmentation => 4,
        Annotator::DepthSensorDistance
        | Annotator::DepthSensorPointCloudColor
        | Annotator::DepthSensorImager
        | Annotator::DepthSensorOutputVisualization => 4,
        Annotator::Normals => 12,
        Annotator::DepthSensorPointCloudPosition => 16,
        Annotator::Pointcloud => 36,
        Annotator::BoundingBox2dTight | Annotator::BoundingBox2dLoose | Annotator::CameraParams => 0,
    }
}

/// The memory that this machine could give now, bytes; `None` where it does not say.
#[must_use]
pub fn available_bytes() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kib.checked_mul(1024)
}

/// `1.5 GiB`
#[must_use]
pub fn gib(bytes: u64) -> String {
    let tenths = bytes.saturating_mul(10).div_ceil(1 << 30);
    format!("{}.{} GiB", tenths / 10, tenths % 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert!(check_size(ImageSize::new(1 << 16, 1 << 15)).is_ok());
        assert!(check_size(ImageSize::new((1 << 16) + 1, 1 << 15)).is_err());
        assert!(check_size(ImageSize::new(u32::MAX, u32::MAX)).is_err());
        assert!(check_size(ImageSize::new(0, 5)).is_err());
        let bytes = frame_bytes(ImageSize::new(1 << 16, 1 << 15), &Annotator::ALL);
        assert_eq!(gib(bytes), "824.0 GiB");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn linux_says_its_memory() {
        assert!(available_bytes().unwrap() > 1 << 20);
    }
}
