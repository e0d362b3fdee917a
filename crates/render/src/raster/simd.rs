//! The same source, compiled for what the processor has. Nothing is contracted or reordered, so that all of it gives
//! the same bits.

#![allow(unsafe_code)]

use super::cluster::ClusteredMesh;
use super::cull::Visible;
use super::frame::Frame;
use super::tile::Tile;
use super::{Scratch, draw};

/// Instructions to use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Level {
    /// What every processor of the target has.
    Baseline,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Level {
    /// The best that this processor has.
    pub(super) fn detect() -> Self {
        Self::available().last().copied().unwrap_or(Self::Baseline)
    }

    /// All that this processor has.
    pub(super) fn available() -> Vec<Self> {
        let mut levels = vec![Self::Baseline];
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx2") {
                levels.push(Self::Avx2);
                if std::arch::is_x86_feature_detected!("avx512f")
                    && std::arch::is_x86_feature_detected!("avx512bw")
                    && std::arch::is_x86_feature_detected!("avx512dq")
                    && std::arch::is_x86_feature_detected!("avx512vl")
                {
                    levels.push(Self::Avx512);
                }
            }
        }
        levels
    }
}

/// [`draw::entries`] with the given instructions.
pub(super) fn draw_entries<const IDS: bool>(
    level: Level,
    frame: &Frame,
    meshes: &[ClusteredMesh],
    visible: &[Visible],
    entries: &[u64],
    tile: &mut Tile,
    scratch: &mut Scratch,
) {
    match level {
        Level::Baseline => draw::entries::<IDS>(frame, meshes, visible, entries, tile, scratch),
        // SAFETY: this level exists only where `available` found the processor to have its features.
        #[cfg(target_arch = "x86_64")]
        Level::Avx2 => unsafe { avx2::<IDS>(frame, meshes, visible, entries, tile, scratch) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Level::Avx512 => unsafe { avx512::<IDS>(frame, meshes, visible, entries, tile, scratch) },
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2<const IDS: bool>(
    frame: &Frame,
    meshes: &[ClusteredMesh],
    visible: &[Visible],
    entries: &[u64],
    tile: &mut Tile,
    scratch: &mut Scratch,
) {
    draw::entries::<IDS>(frame, meshes, visible, entries, tile, scratch);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,avx512f,avx512bw,avx512dq,avx512vl")]
fn avx512<const IDS: bool>(
    frame: &Frame,
    meshes: &[ClusteredMesh],
    visible: &[Visible],
    entries: &[u64],
    tile: &mut Tile,
    scratch: &mut Scratch,
) {
    draw::entries::<IDS>(frame, meshes, visible, entries, tile, scratch);
}
