//! Declares the filters' inner loops as kernels.

/// Declares functions that run a loop over pixels at a [`Level`](oaktwin_simd::Level).
macro_rules! kernels {
    ($($(#[$doc:meta])* fn $name:ident<$rows:lifetime> = $body:path => ($($argument:ident: $type:ty),*);)*) => {$(
        $(#[$doc])*
        fn $name<$rows, P: $crate::filter::Pixel>(level: oaktwin_simd::Level, $($argument: $type),*) {
            struct PixelLoop<$rows, P: $crate::filter::Pixel> {
                $($argument: $type),*
            }

            impl<$rows, P: $crate::filter::Pixel> oaktwin_simd::Kernel for PixelLoop<$rows, P> {
                type Output = ();

                #[inline(always)]
                fn run(self) {
                    $body($(self.$argument),*);
                }
            }

            oaktwin_simd::run_at(level, PixelLoop { $($argument),* });
        }
    )*};
}

pub(super) use kernels;
