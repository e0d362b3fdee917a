//! The pattern of a dot projector: its luminance in each direction, independent of any scene.

use crate::random::{NoiseStage, RandomPlane, Stream};

/// The number of grid cells across a dot: more cells leave more of them without dots, which are known to be dark.
const CELLS: f64 = 2.0;

/// The radius at which a dot's profile (1 − s²/r²)⁴ is one half, in units of r.
const HALF_AT: f64 = 0.398_9;

/// The minimum distance between dots, in units of the side of the square that each dot has on average.
const APART: f64 = 0.7;

/// A dot projector, as its manufacturer specifies it.
#[derive(Clone, Debug, PartialEq)]
pub struct DotProjector {
    /// The model; all projectors of a model have the same pattern.
    pub model: String,
    /// The number of dots.
    pub dots: u32,
    /// The horizontal and the vertical field of illumination, radians; at its border the luminance is half of that on
    /// the axis.
    pub field_rad: [f64; 2],
    /// The angular full width of a dot at half its maximum, radians.
    pub dot_width_rad: f64,
    /// The luminance of the centre of a dot on a white surface that faces the projector at a distance of 1 m.
    pub brightness: f64,
}

/// The dots of a projector.
///
/// The vendor's pattern is not published. This one is an estimate: it has the specified number of dots over the field
/// of illumination, at random positions with a minimum distance, the same for all units of a model. A dot is round with
/// the profile (1 − s²/r²)⁴, where s is the sine of the angle from its centre. Its brightness is 1/(1 + (x/X)⁴ +
/// (y/Y)⁴) at the point (x, y) on the plane z = 1, with (X, Y) the border of the field: half at the middles of its
/// sides.
#[derive(Clone, Debug, PartialEq)]
pub struct Dots {
    dots: Vec<Dot>,
    /// The reciprocal of the squared sine of a dot's radius.
    inverse_radius2: f32,
    brightness: f32,
    grid: Grid,
    /// The start of each cell: the dots of cell `i` are `of_cells[starts[i]..starts[i + 1]]`.
    starts: Vec<u32>,
    of_cells: Vec<u32>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Dot {
    at: [f32; 2],
    /// 1/(1 + x² + y²).
    inverse_length2: f32,
    strength: f32,
}

/// A grid of square cells, centred on the plane z = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Grid {
    per_unit: f32,
    /// The distance from the centre to a border, in cells.
    half: [f32; 2],
    size: [usize; 2],
}

impl Grid {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a few hundred cells"
    )]
    fn new(half: [f64; 2], cell: f64) -> Self {
        let cells = half.map(|half| (half / cell).ceil().clamp(1.0, 4096.0));
        Self {
            per_unit: (1.0 / cell) as f32,
            half: cells.map(|cells| cells as f32),
            size: cells.map(|cells| 2 * cells as usize),
        }
    }

    /// Returns the column or the row of a coordinate, if it is inside the grid.
    #[inline]
    fn cell(&self, at: f32, axis: usize) -> Option<usize> {
        let place = at * self.per_unit + self.half[axis];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
        (place >= 0.0 && place < 2.0 * self.half[axis]).then_some(place as usize)
    }

    /// Returns the columns or the rows within a radius of a coordinate.
    #[inline]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    fn cells(&self, at: f32, radius: f32, axis: usize) -> std::ops::Range<usize> {
        let end = 2.0 * self.half[axis];
        let place = |at: f32| (at * self.per_unit + self.half[axis]).clamp(0.0, end);
        place(at - radius) as usize..(place(at + radius) as usize + 1).min(self.size[axis])
    }
}

impl Grid {
    /// Returns the cells that a circle touches.
    fn cells_within(&self, at: [f32; 2], radius: f32) -> impl Iterator<Item = usize> {
        let grid = *self;
        let side = 1.0 / grid.per_unit;
        grid.cells(at[1], radius, 1).flat_map(move |row| {
            grid.cells(at[0], radius, 0).filter_map(move |column| {
                #[expect(clippy::cast_precision_loss, reason = "a few thousand cells")]
                let off = [(column, 0), (row, 1)].map(|(cell, axis): (usize, usize)| {
                    let low = (cell as f32 - grid.half[axis]) * side;
                    (low - at[axis]).max(at[axis] - low - side).max(0.0)
                });
                let touches = off[0] * off[0] + off[1] * off[1] <= radius * radius;
                touches.then_some(row * grid.size[0] + column)
            })
        })
    }
}

impl Dots {
    /// Creates the pattern of a projector.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    pub fn new(projector: &DotProjector) -> Self {
        let border = [0, 1].map(|axis: usize| (projector.field_rad[axis] / 2.0).tan());
        let radius = projector.dot_width_rad / 2.0 / HALF_AT;
        let places = places(projector, border);
        let dots: Vec<Dot> = places
            .iter()
            .map(|&[x, y]| {
                let [a, b] = [x / border[0], y / border[1]];
                Dot {
                    at: [x as f32, y as f32],
                    inverse_length2: (1.0 / (1.0 + x * x + y * y)) as f32,
                    strength: (1.0 / (1.0 + a * a * a * a + b * b * b * b)) as f32,
                }
            })
            .collect();
        let farthest = 1.0 + border[0] * border[0] + border[1] * border[1];
        let border_of_cells = border.map(|border| border + 1.1 * radius * farthest);
        let grid = Grid::new(border_of_cells, 2.0 * radius / CELLS);
        let touched: Vec<Vec<usize>> = dots
            .iter()
            .map(|dot| {
                // The projection of a dot is widest along the radius, by 1/cos².
                let reach = 1.02 * radius as f32 / dot.inverse_length2;
                grid.cells_within(dot.at, reach).collect()
            })
            .collect();
        // Counting sort of the dots by cell.
        let mut starts = vec![0u32; grid.size[0] * grid.size[1] + 1];
        for &cell in touched.iter().flatten() {
            starts[cell + 1] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut ends = starts.clone();
        let mut of_cells = vec![0; sum as usize];
        for (cells, index) in touched.iter().zip(0u32..) {
            for &cell in cells {
                of_cells[ends[cell] as usize] = index;
                ends[cell] += 1;
            }
        }
        Self {
            dots,
            inverse_radius2: (1.0 / (radius * radius)) as f32,
            brightness: projector.brightness as f32,
            grid,
            starts,
            of_cells,
        }
    }

    /// The number of dots.
    #[must_use]
    pub fn len(&self) -> usize {
        self.dots.len()
    }

    /// Whether there are no dots.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.dots.is_empty()
    }

    /// The centres of the dots as points (x/z, y/z) on the plane z = 1 of the projector's frame (x right, y down).
    pub fn places(&self) -> impl Iterator<Item = [f32; 2]> {
        self.dots.iter().map(|dot| dot.at)
    }

    /// Returns the luminance of a white surface that faces the projector at a distance of 1 m, in the direction (x/z,
    /// y/z).
    #[must_use]
    pub fn luminance(&self, at: [f32; 2]) -> f32 {
        let (Some(column), Some(row)) = (self.grid.cell(at[0], 0), self.grid.cell(at[1], 1)) else {
            return 0.0;
        };
        let cell = row * self.grid.size[0] + column;
        let [x, y] = at;
        let scale = self.inverse_radius2 / (1.0 + x * x + y * y);
        let mut sum = 0.0;
        for &index in self.of_cell(cell) {
            let Some(dot) = self.dots.get(index as usize) else {
                continue;
            };
            // The squared sine of the angle between two directions follows from their cross product.
            let [dx, dy] = [x - dot.at[0], y - dot.at[1]];
            let twist = x * dot.at[1] - y * dot.at[0];
            let s2 = (dx * dx + dy * dy + twist * twist) * dot.inverse_length2 * scale;
            let rest = (1.0 - s2).max(0.0);
            let square = rest * rest;
            sum += square * square * dot.strength;
        }
        sum * self.brightness
    }

    /// Whether there is no light within a radius of a point. It may return false for a dark area, but never true for a
    /// lit one.
    #[must_use]
    pub fn is_dark_around(&self, at: [f32; 2], radius: f32) -> bool {
        let columns = self.grid.cells(at[0], radius, 0);
        self.grid.cells(at[1], radius, 1).all(|row| {
            columns
                .clone()
                .all(|column| self.of_cell(row * self.grid.size[0] + column).is_empty())
        })
    }

    #[inline]
    fn of_cell(&self, cell: usize) -> &[u32] {
        let range = (self.starts.get(cell), self.starts.get(cell + 1));
        let (Some(&start), Some(&end)) = range else {
            return &[];
        };
        self.of_cells
            .get(start as usize..end as usize)
            .unwrap_or_default()
    }
}

/// Returns random points in the field with a minimum distance between them, which shrinks if there is no room left.
fn places(projector: &DotProjector, border: [f64; 2]) -> Vec<[f64; 2]> {
    let wanted = projector.dots as usize;
    let random = Stream::new(0, &projector.model).plane(NoiseStage::Dots, 0, 0);
    let own_square = (4.0 * border[0] * border[1] / f64::from(projector.dots.max(1))).sqrt();
    let mut apart = APART * own_square;
    // The cell size limits the number of dots in a cell and in its neighbours to a few.
    let grid = Grid::new(border, own_square.max(border[0].max(border[1]) / 2000.0));
    let mut cells: Vec<Vec<[f64; 2]>> = vec![Vec::new(); grid.size[0] * grid.size[1]];
    let mut found: Vec<[f64; 2]> = Vec::with_capacity(wanted);
    let mut tries = 0u32;
    while found.len() < wanted {
        let place = place(&random, tries, border);
        tries = tries.wrapping_add(1);
        if tries.is_multiple_of(64 * projector.dots.max(1)) {
            apart *= 0.8;
        }
        #[expect(clippy::cast_possible_truncation, reason = "to find a cell")]
        let [x, y] = place.map(|value| value as f32);
        #[expect(clippy::cast_possible_truncation, reason = "to find cells")]
        let reach = apart as f32 * 1.01;
        let columns = grid.cells(x, reach, 0);
        let is_free = grid.cells(y, reach, 1).all(|row| {
            columns.clone().all(|column| {
                let cell = cells.get(row * grid.size[0] + column);
                cell.is_none_or(|cell| {
                    cell.iter()
                        .all(|other| (other[0] - place[0]).hypot(other[1] - place[1]) >= apart)
                })
            })
        });
        if is_free && let (Some(column), Some(row)) = (grid.cell(x, 0), grid.cell(y, 1)) {
            if let Some(cell) = cells.get_mut(row * grid.size[0] + column) {
                cell.push(place);
            }
            found.push(place);
        }
    }
    found
}

fn place(random: &RandomPlane, index: u32, border: [f64; 2]) -> [f64; 2] {
    let [a, b, ..] = random.words(index, 0);
    let uniform = |word: u32| (f64::from(word) + 0.5) / 2_147_483_648.0 - 1.0;
    [uniform(a) * border[0], uniform(b) * border[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn belago() -> DotProjector {
        DotProjector {
            model: "ams Belago 1.1".to_owned(),
            dots: 4700,
            field_rad: [78f64, 61.0].map(f64::to_radians),
            dot_width_rad: 3e-3,
            brightness: 3.0,
        }
    }

    #[test]
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    fn dots_have_the_specified_number_spacing_and_field() {
        let spec = belago();
        let dots = Dots::new(&spec);
        let places: Vec<[f32; 2]> = dots.places().collect();
        assert_eq!((dots.len(), places.len()), (4700, 4700));
        let border = spec.field_rad.map(|field| (field / 2.0).tan() as f32);
        assert!(
            places
                .iter()
                .all(|at| at[0].abs() < border[0] && at[1].abs() < border[1])
        );
        let mut nearest = f32::INFINITY;
        for (i, a) in places.iter().enumerate() {
            for b in &places[..i] {
                nearest = nearest.min((a[0] - b[0]).hypot(a[1] - b[1]));
            }
        }
        let own = (4.0 * border[0] * border[1] / 4700.0).sqrt();
        assert!(nearest > 0.65 * own, "{nearest} {own}");
        // The dots cover the whole field.
        let full = |x: f32, y: f32| {
            places
                .iter()
                .any(|at| (at[0] - x).abs() < 0.07 && (at[1] - y).abs() < 0.07)
        };
        for i in -10..=10i8 {
            for j in -10..=10i8 {
                assert!(full(
                    f32::from(i) / 10.0 * border[0],
                    f32::from(j) / 10.0 * border[1]
                ));
            }
        }
        assert_eq!(dots, Dots::new(&spec));
    }

    #[test]
    fn dots_have_the_specified_width_and_dark_gaps() {
        let spec = belago();
        let dots = Dots::new(&spec);
        let mut near_axis = 0;
        for [x, y] in dots.places() {
            let peak = dots.luminance([x, y]);
            assert!(!dots.is_dark_around([x, y], 0.0));
            if x.hypot(y) < 0.1 {
                near_axis += 1;
                assert!((peak / 3.0 - 1.0).abs() < 2e-3, "{peak}");
                let half = dots.luminance([x + 1.5e-3, y]);
                assert!((half / peak - 0.5).abs() < 0.02, "{half} {peak}");
            }
        }
        assert!(near_axis > 20);
        let (mut dark, mut total) = (0, 0);
        for i in -400..400i16 {
            for j in -300..300i16 {
                let at = [f32::from(i) * 2.2e-3, f32::from(j) * 2.2e-3];
                total += 1;
                if dots.is_dark_around(at, 1e-3) {
                    dark += 1;
                    assert!(dots.luminance(at) == 0.0 && dots.luminance([at[0] + 7e-4, at[1] - 7e-4]) == 0.0);
                }
            }
        }
        assert!(dark * 2 > total, "{dark} of {total}");
        assert!(dots.is_dark_around([f32::NAN, 0.0], 1.0) || dots.luminance([f32::NAN, 0.0]) == 0.0);
        assert_eq!(dots.luminance([9.0, -9.0]), 0.0);
    }
}
