/// A box as `[min x, min y, min z, _, -max x, -max y, -max z, _]`, so that joining is a minimum in all lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds(pub(super) [f32; 8]);

impl Bounds {
    /// The empty box.
    pub(crate) const EMPTY: Self = Self([f32::INFINITY; 8]);

    pub(crate) fn new(min: [f32; 3], max: [f32; 3]) -> Self {
        Self([min[0], min[1], min[2], 0.0, -max[0], -max[1], -max[2], 0.0])
    }

    pub(crate) fn of_points(points: &[[f32; 3]]) -> Self {
        points
            .iter()
            .fold(Self::EMPTY, |bounds, p| bounds.join(Self::new(*p, *p)))
    }

    /// Returns the box of all children of a node; NaN if there are none.
    pub(crate) fn of_nodes(node: &super::Node) -> Self {
        let fold = |values: [f32; 8], f: fn(f32, f32) -> f32| values.into_iter().fold(f32::NAN, f);
        let [a, b, c, d, e, f] = node.bounds;
        Self::new(
            [a, b, c].map(|v| fold(v, f32::min)),
            [d, e, f].map(|v| fold(v, f32::max)),
        )
    }

    pub(crate) fn min(&self) -> [f32; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    pub(crate) fn max(&self) -> [f32; 3] {
        [-self.0[4], -self.0[5], -self.0[6]]
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.min().iter().chain(&self.max()).all(|x| x.is_finite())
    }

    #[inline]
    pub(super) fn join(&self, other: Self) -> Self {
        let (a, b) = (self.0, other.0);
        Self(std::array::from_fn(|i| if b[i] < a[i] { b[i] } else { a[i] }))
    }

    /// Returns half the surface area.
    #[inline]
    pub(super) fn half_area(&self) -> f32 {
        let [x, y, z] = [0, 1, 2].map(|i| -(self.0[i] + self.0[i + 4]));
        x * y + y * z + z * x
    }

    /// Returns twice the centre, in lanes 0 to 2.
    #[inline]
    pub(super) fn center(&self) -> [f32; 4] {
        let b = self.0;
        std::array::from_fn(|i| b[i] - b[i + 4])
    }
}

/// A box and the index of its item.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Item(Bounds);

impl Item {
    pub(crate) fn new(bounds: Bounds, index: u32) -> Self {
        let mut bounds = bounds;
        // The lane that no box uses.
        bounds.0[3] = f32::from_bits(index);
        Self(bounds)
    }

    pub(crate) fn index(&self) -> u32 {
        self.0.0[3].to_bits()
    }

    /// Returns the box, with the index in lane 3.
    #[inline]
    pub(super) fn bounds(&self) -> Bounds {
        self.0
    }
}
