//! Sixty-four rays of one origin and about one direction at a time.
//!
//! In the tile's own frame each ray is a point `(u, v)` of the plane `z = 1`. A triangle that is set up once is then
//! tested against those packets of eight rays that its box in that plane touches, and boxes of the hierarchy are
//! tested against the whole tile.

mod frame;
mod rays;
mod solve;
mod state;
mod table;
mod trace;
mod triangles;

pub(crate) use rays::{PACKETS, PerRay, SIDE, TileRays, place};
pub(crate) use solve::Solve;
pub(crate) use state::State;
pub(crate) use table::{RayTable, RayTables};
pub(crate) use trace::{Origin, Trace};
