//! The tests of this crate, in one program.

mod case;
mod generate;
mod heaps;
mod imu;
mod recipes;
mod resume;
mod sizes;
