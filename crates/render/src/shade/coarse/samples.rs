//! The surfaces that the samples of light lie on.

use glam::Vec3;
use oaktwin_image::Image;
use oaktwin_simd::Lanes;

use crate::ray::Vector;
use crate::shade::occlusion::ShadingPoint;
use crate::spare::Spare;

/// The point relative to the eye, the normal and the flat normal of a [`ShadingPoint`]; then its distance from the eye, the inverse of
/// the distance from its plane within which another sample belongs to the same surface, and 0. All are 0 for a miss.
pub(super) type Rows = [[f32; 3]; 4];

/// The samples at a quarter of a view's pixels.
#[derive(Debug)]
pub(super) struct Samples(Image<Rows>);

impl Samples {
    pub(super) fn misses(width: u32, height: u32, memory: &Spare<Rows>) -> Self {
        Self(memory.image(width, height, Rows::default()))
    }

    pub(super) fn keep(self, memory: &Spare<Rows>) {
        memory.keep(self.0);
    }

    pub(super) fn width(&self) -> u32 {
        self.0.width()
    }

    pub(super) fn height(&self) -> u32 {
        self.0.height()
    }

    pub(super) fn pixels(&self) -> &[Rows] {
        self.0.pixels()
    }

    pub(super) fn pixels_mut(&mut self) -> &mut [Rows] {
        self.0.pixels_mut()
    }

    /// Returns a sample, unless it is outside the image.
    #[inline]
    pub(super) fn get(&self, x: u32, y: u32) -> Option<Sample<'_>> {
        self.0.get(x, y).map(Sample)
    }
}

/// One of the samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<'a>(pub(super) &'a Rows);

/// Returns the rows of a surface.
pub(super) fn rows(place: &ShadingPoint) -> Rows {
    [
        place.from_eye.to_array(),
        place.normal.to_array(),
        place.flat_normal.to_array(),
        [place.range, per_tolerance(place.range), 0.0],
    ]
}

/// The inverse of the distance from a sample's plane within which another sample belongs to the same surface.
fn per_tolerance(range: f32) -> f32 {
    300.0 / range.max(f32::MIN_POSITIVE)
}

impl Sample<'_> {
    pub(super) fn is_miss(self) -> bool {
        self.0[3][1] == 0.0
    }

    pub(super) fn place(self) -> ShadingPoint {
        let [point, normal, flat_normal, [range, ..]] = *self.0;
        ShadingPoint {
            from_eye: point.into(),
            range,
            normal: normal.into(),
            flat_normal: flat_normal.into(),
        }
    }

    /// Returns the weight of another sample, 0 to 1: from the angle between the normals and its distance from this sample's
    /// plane.
    #[inline]
    pub(super) fn similarity(self, other: Self) -> f32 {
        let [point, normal, _, [_, per_tolerance, _]] = *self.0;
        let (point, normal) = (Vec3::from(point), Vec3::from(normal));
        let parallel = (normal.dot(other.0[1].into()) - 0.75) * 4.0;
        let off = normal.dot(Vec3::from(other.0[0]) - point).abs() * per_tolerance;
        parallel.max(0.0) * (1.0 - off).max(0.0)
    }
}

/// Eight surfaces.
pub(super) struct Surfaces<L: Lanes> {
    pub(super) point: Vector<L>,
    pub(super) normal: Vector<L>,
    pub(super) per_tolerance: L,
}

impl<L: Lanes> Surfaces<L> {
    #[inline(always)]
    pub(super) fn new(point: Vector<L>, normal: Vector<L>, range: L) -> Self {
        let per_tolerance = L::splat(300.0) / range.max(L::splat(f32::MIN_POSITIVE));
        Self {
            point,
            normal,
            per_tolerance,
        }
    }

    /// [`Sample::similarity`] to the samples with the given indices.
    #[inline(always)]
    pub(super) fn similarity(&self, samples: &[Rows], at: [u32; 8]) -> L {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let normal = row::<L, _>(samples, at, 1);
        let parallel = (self.normal.dot(normal) - L::splat(0.75)) * L::splat(4.0);
        let height = self.normal.dot(row::<L, _>(samples, at, 0) - self.point);
        let off = height.max(zero - height) * self.per_tolerance;
        parallel.max(zero) * (one - off).max(zero)
    }
}

/// Loads the same row of eight samples.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "a few rows")]
pub(super) fn row<L: Lanes, const ROWS: usize>(
    samples: &[[[f32; 3]; ROWS]],
    at: [u32; 8],
    row: u32,
) -> Vector<L> {
    let mut index = at;
    for index in &mut index {
        *index = *index * ROWS as u32 + row;
    }
    let [x, y, z] = L::gather(samples.as_flattened(), index);
    Vector { x, y, z }
}
