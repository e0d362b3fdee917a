//! Interpolation from receivers to pixels.

use oaktwin_simd::Kernel;

use super::ReceiverPosition;
use super::between;
use crate::time_of_flight::light::{CHANNELS, Lamp, LightRow, phasor, plane};

/// The dissimilarity at which a receiver's weight is a quarter.
const LIKE: f32 = 0.01;

/// Dissimilarity is 1 minus the cosine between the normals, plus the square of this times the pixel's distance from the
/// receiver's plane as a fraction of its depth: 2 cm at 1 m count as 33° between normals.
const OFF_PLANE: f32 = 20.0;

/// The minimum weight by position: the only similar receiver may be far away.
const LEAST_SHARE: f32 = 0.02;

/// The sum of weights below which there is less light.
const LEAST_SUM: f32 = 1e-3;

/// The surfaces of a row's pixels, and the receivers' light there.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surfaces {
    /// Points, metres in the camera's frame.
    pub(super) point: [Vec<f32>; 3],
    /// Unit normals towards the camera; 0 without a surface.
    pub(super) normal: [Vec<f32>; 3],
    /// The distance from the camera, m.
    pub(super) range: Vec<f32>,
    light: [Vec<f32>; CHANNELS],
}

impl Surfaces {
    pub(crate) fn reset(&mut self, width: usize) {
        let rows = self.point.iter_mut().chain(&mut self.normal);
        for row in rows.chain(&mut self.light).chain([&mut self.range]) {
            row.clear();
            row.resize(width, 0.0);
        }
    }
}

/// Computes the points and normals of a row.
pub(crate) struct Normals<'a> {
    /// The inverse depth of the row above, this row and the row below, one pixel longer at both ends.
    pub(crate) inverse: [&'a [f32]; 3],
    pub(crate) depth: &'a [f32],
    pub(crate) focal_length_px: f32,
    pub(crate) u: &'a [f32],
    pub(crate) v: f32,
    pub(crate) out: &'a mut Surfaces,
}

impl<'a> Kernel for Normals<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let n = self.depth.len();
        let padded = |row: &'a [f32]| row.get(..n + 2);
        let [Some(above), Some(here), Some(below)] = self.inverse.map(padded) else {
            return;
        };
        let out = self.out;
        let [Some(px), Some(py), Some(pz)] = out.point.each_mut().map(|row| row.get_mut(..n)) else {
            return;
        };
        let [Some(nx), Some(ny), Some(nz)] = out.normal.each_mut().map(|row| row.get_mut(..n)) else {
            return;
        };
        let (Some(range), Some(u)) = (out.range.get_mut(..n), self.u.get(..n)) else {
            return;
        };
        let (v, depth) = (self.v, self.depth);
        for x in 0..n {
            let w = here[x + 1];
            let beside = [here[x], here[x + 2], above[x + 1], below[x + 1]];
            let [gx, gy, gz] = plane(w, beside, [u[x], v], self.focal_length_px);
            let size = (gx * gx + gy * gy + gz * gz).sqrt();
            let surface = (w > 0.0) & (size > 0.0);
            let z = if surface { depth[x] } else { 0.0 };
            let per = if surface { -1.0 / size } else { 0.0 };
            (px[x], py[x], pz[x]) = (z * u[x], z * v, z);
            (nx[x], ny[x], nz[x]) = (per * gx, per * gy, per * gz);
            range[x] = z * (1.0 + u[x] * u[x] + v * v).sqrt();
        }
    }
}

/// A receiver and its light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Receiver {
    normal: [f32; 3],
    /// The dot product of the normal and the point.
    plane: f32,
    /// The weight, 0 without a surface.
    counts: f32,
    light: [f32; CHANNELS],
}

impl Receiver {
    pub(super) fn new(found: &ReceiverPosition, light: [f32; CHANNELS]) -> Self {
        let (n, p) = (found.normal, found.point);
        let is_surface = n != [0.0; 3];
        Self {
            normal: n,
            plane: n[0] * p[0] + n[1] * p[1] + n[2] * p[2],
            counts: if is_surface { 1.0 } else { 0.0 },
            light,
        }
    }
}

/// Computes the receivers' light at a row's pixels.
pub(super) struct Spread<'a> {
    /// The receivers' columns.
    pub(super) columns: &'a [usize],
    /// The receivers above and below, which may be the same row.
    pub(super) rows: [&'a [Receiver]; 2],
    /// The weight of the row below.
    pub(super) lower: f32,
    pub(super) surfaces: &'a mut Surfaces,
}

impl Kernel for Spread<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let n = self.surfaces.range.len();
        let count = self.columns.len();
        // From one receiver or border to the next.
        for right in 0..=count {
            let left = right.saturating_sub(1);
            let start = if right == 0 { 0 } else { self.columns[left] };
            let (right, end) = if right == count {
                (left, n)
            } else {
                (right, self.columns[right])
            };
            let [above, below] = self.rows;
            let corners = [above[left], above[right], below[left], below[right]];
            between_receivers(
                &corners,
                [self.columns[left], self.columns[right]],
                self.lower,
                start..end,
                self.surfaces,
            );
        }
    }
}

#[inline(always)]
fn between_receivers(
    corners: &[Receiver; 4],
    columns: [usize; 2],
    lower: f32,
    span: std::ops::Range<usize>,
    surfaces: &mut Surfaces,
) {
    let inside = |row: &'_ [f32]| row.len() >= span.end;
    if !surfaces
        .point
        .iter()
        .chain(&surfaces.normal)
        .all(|row| inside(row))
    {
        return;
    }
    let n = span.len();
    let [px, py, pz] = surfaces.point.each_ref().map(|row| &row[span.clone()][..n]);
    let [nx, ny, nz] = surfaces.normal.each_ref().map(|row| &row[span.clone()][..n]);
    let [re0, im0, re1, im1, total] = surfaces.light.each_mut().map(|row| &mut row[span.clone()][..n]);
    let (first, per) = (columns[0] as f32, between(columns, columns[0] + 1));
    for x in 0..n {
        let across = ((span.start + x) as f32 - first) * per;
        let shares = [
            (1.0 - across) * (1.0 - lower),
            across * (1.0 - lower),
            (1.0 - across) * lower,
            across * lower,
        ];
        let (p, normal) = ([px[x], py[x], pz[x]], [nx[x], ny[x], nz[x]]);
        let (mut sums, mut counted) = ([0.0f32; CHANNELS], 0.0f32);
        for k in 0..4 {
            let corner = &corners[k];
            let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let off = OFF_PLANE * (dot(corner.normal, p) - corner.plane) / p[2];
            let unlike = (1.0 - dot(corner.normal, normal)).abs() + off * off;
            let like = LIKE / (LIKE + unlike);
            let counts = (shares[k] + LEAST_SHARE) * corner.counts * like * like;
            counted += counts;
            for (sum, &light) in sums.iter_mut().zip(&corner.light) {
                *sum += counts * light;
            }
        }
        let counted = if counted > LEAST_SUM { counted } else { LEAST_SUM };
        let per = if p[2] > 0.0 { 1.0 / counted } else { 0.0 };
        // Without a surface the sums are NaN.
        let light = sums.map(|sum| if p[2] > 0.0 { sum * per } else { 0.0 });
        [re0[x], im0[x], re1[x], im1[x], total[x]] = light;
    }
}

/// Adds the receivers' light at a row's pixels to the direct light.
pub(crate) struct Add<'a> {
    pub(crate) lamp: &'a Lamp,
    /// Electrons of a white surface per unit of the receivers' light.
    pub(crate) signal: f32,
    pub(crate) surfaces: &'a Surfaces,
    pub(crate) albedo: &'a [f32],
    /// The error of the distance, m.
    pub(crate) shift: &'a [f32],
    /// The radial velocity since each frequency's measurement, m/s.
    pub(crate) velocity: [&'a [f32]; 2],
    pub(crate) out: &'a mut LightRow,
}

impl<'a> Kernel for Add<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let n = self.albedo.len();
        let inside = |row: &'a [f32]| row.get(..n);
        let [slow, fast] = self.velocity;
        let rows = [self.albedo, self.shift, slow, fast, &self.surfaces.range].map(inside);
        let [Some(albedo), Some(shift), Some(slow), Some(fast), Some(range)] = rows else {
            return;
        };
        let lit = self.surfaces.light.each_ref().map(|row| inside(row));
        let [Some(re0), Some(im0), Some(re1), Some(im1), Some(all)] = lit else {
            return;
        };
        let outs = self.out.channels.each_mut().map(|row| row.get_mut(1..=n));
        let [Some(out0), Some(out1), Some(out2), Some(out3), Some(total)] = outs else {
            return;
        };
        let lamp = *self.lamp;
        for x in 0..n {
            let reflected = self.signal * albedo[x];
            let amplitude = lamp.contrast * reflected;
            let way = 0.5 * range[x] + shift[x];
            let seen = [way - slow[x] * lamp.age_s[0], way - fast[x] * lamp.age_s[1]];
            let turns = [0, 1].map(|f| seen[f] * lamp.turns_per_m[f]);
            let (c, s) = phasor(amplitude, turns[0]);
            out0[x] += c * re0[x] - s * im0[x];
            out1[x] += c * im0[x] + s * re0[x];
            let (c, s) = phasor(amplitude, turns[1]);
            out2[x] += c * re1[x] - s * im1[x];
            out3[x] += c * im1[x] + s * re1[x];
            total[x] += reflected * all[x];
        }
    }
}
