//! The filters' inner loops as [`Kernel`]s.

use oaktwin_simd::{Kernel, Level, run_at};

use super::{DecimationMode, Pixel, decimation, median, spatial, speckle, temporal};

macro_rules! kernels {
    ($($(#[$doc:meta])* fn $name:ident<$rows:lifetime> = $body:path => ($($argument:ident: $type:ty),*);)*) => {$(
        $(#[$doc])*
        pub(super) fn $name<$rows, P: Pixel>(level: Level, $($argument: $type),*) {
            struct Work<$rows, P: Pixel> {
                $($argument: $type),*
            }

            impl<$rows, P: Pixel> Kernel for Work<$rows, P> {
                type Output = ();

                #[inline(always)]
                fn run(self) {
                    $body($(self.$argument),*);
                }
            }

            run_at(level, Work { $($argument),* });
        }
    )*};
}

kernels! {
    /// [`decimation::row`]
    fn decimation<'a> = decimation::row => (factor: usize, mode: DecimationMode, rows: &'a [&'a [P]], out: &'a mut [P]);
    /// [`median::row3`]
    fn median3<'a> = median::row3 => (rows: [&'a [P]; 3], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
    /// [`median::row5`]
    fn median5<'a> = median::row5 => (rows: [&'a [P]; 5], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
    /// [`median::row7`]
    fn median7<'a> = median::row7 => (rows: [&'a [P]; 7], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
    /// [`spatial::along`]
    fn spatial_along<'a> = spatial::along => (settings: &'a spatial::Settings<P>, rows: &'a mut [P], tile: &'a mut [P]);
    /// [`spatial::down`]
    fn spatial_down<'a> = spatial::down => (settings: &'a spatial::Settings<P>, above: &'a [P], row: &'a mut [P]);
    /// [`spatial::up`]
    fn spatial_up<'a> = spatial::up => (settings: &'a spatial::Settings<P>, below: &'a [P], row: &'a mut [P]);
    /// [`temporal::update`]
    fn temporal<'a> = temporal::update => (settings: temporal::Settings<P>, pixels: &'a mut [P], last: &'a mut [P], history: &'a mut [u8]);
    /// [`speckle::links`]
    fn speckle_links<'a> = speckle::links => (threshold: P, rows: [&'a [P]; 2], links: &'a mut speckle::Links<'a>);
    /// [`speckle::lone`]
    fn speckle_lone<'a> = speckle::lone => (threshold: P, around: [&'a [P]; 2], left: &'a mut [u8], row: &'a mut [P]);
}
