//! The tests of this crate, in one program.

mod case;
mod generate;
mod heaps;
mod imu;
mod motion;
mod recipes;
mod resume;
mod sizes;
