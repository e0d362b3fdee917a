//! All that a tile shows.

use super::cluster::ClusteredMesh;
use super::cull::Visible;
use super::frame::{Frame, Projection};
use super::lanes::Lanes;
use super::large;
use super::small::{self, Drawn, Scratch};
use super::tile::{Id, Rectangle, Tile};

/// Draws what is listed, by its place in `visible` in the lower half of each entry, in the order of the list.
#[inline(always)]
pub(super) fn entries<L: Lanes, const IDS: bool>(
    lanes: L,
    frame: &Frame,
    meshes: &[ClusteredMesh],
    visible: &[Visible],
    entries: &[u64],
    tile: &mut Tile,
    scratch: &mut Scratch,
) {
    let mut last: Option<(u32, Projection)> = None;
    for entry in entries {
        #[expect(clippy::cast_possible_truncation, reason = "the lower half")]
        let Some(item) = visible.get(*entry as u32 as usize) else {
            continue;
        };
        let rectangle = on_tile(item, tile);
        if tile.hides(rectangle, item.inverse_z) {
            continue;
        }
        let onto_tile = match last {
            Some((instance, onto_tile)) if instance == item.instance => onto_tile,
            _ => {
                let Some(projection) = frame.projection(item.instance) else {
                    continue;
                };
                let onto_tile = projection.on_tile(frame.grid, tile.x, tile.y);
                last = Some((item.instance, onto_tile));
                onto_tile
            }
        };
        let Some(mesh) = (frame.scene.instances.get(item.instance as usize))
            .and_then(|instance| meshes.get(instance.mesh as usize))
        else {
            continue;
        };
        let Some(cluster) = mesh.clusters.get(item.cluster as usize) else {
            continue;
        };
        if let Some(triangle) = item.triangle {
            let triangle = triangle as usize;
            if let (Some(positions), Some(number)) =
                (mesh.positions(cluster, triangle), mesh.triangles.get(triangle))
            {
                let id = Id::from(item.instance) << 32 | Id::from(*number);
                large::draw::<L, IDS>(lanes, frame, tile, &onto_tile, positions, id);
            }
        } else {
            let drawn = Drawn {
                mesh,
                cluster,
                onto_tile: &onto_tile,
                instance: item.instance,
            };
            small::draw::<L, IDS>(lanes, frame, tile, scratch, &drawn);
        }
        tile.touch(rectangle);
    }
}

/// What of it lies on the tile, which it touches.
#[expect(clippy::cast_possible_wrap, reason = "a tile is small")]
#[inline(always)]
fn on_tile(item: &Visible, tile: &Tile) -> Rectangle {
    let clip = |[low, high]: [u32; 2], first: u32, size: i32| {
        let last = (size - 1).cast_unsigned();
        [
            low.saturating_sub(first).min(last) as i32,
            high.saturating_sub(first).min(last) as i32,
        ]
    };
    Rectangle {
        x: clip(item.x, tile.x, tile.width),
        y: clip(item.y, tile.y, tile.height),
    }
}
