/// An attribute value.
pub(super) trait Value: Copy + PartialEq {
    const ZERO: Self;
    fn is_finite(&self) -> bool;
}

macro_rules! values {
    ($($float:ty),*) => {$(
        impl<const N: usize> Value for [$float; N] {
            const ZERO: Self = [0.0; N];

            fn is_finite(&self) -> bool {
                self.iter().all(|x| x.is_finite())
            }
        }
    )*};
}

values!(f32, f64);
