//! Tiles of 64 rays with a common origin and similar directions.
//!
//! In the tile frame each ray is a point `(u, v)` of the plane `z = 1`. A triangle is set up once and tested against the packets
//! of eight rays that its bounding box in that plane touches; boxes of the hierarchy are tested against the whole tile.

mod rays;
mod solve;
mod state;
mod table;
mod trace;
mod transform;
mod triangles;

pub(crate) use rays::{PACKETS, PerRay, SIDE, TileRays, place};
pub(crate) use solve::Solve;
pub(crate) use state::TileState;
pub(crate) use table::{RayTable, RayTables, ray_through};
pub(crate) use trace::{Origin, Trace};
