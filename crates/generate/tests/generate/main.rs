//! The tests of this crate, in one program.

mod case;
mod generate;
mod imu;
mod recipes;
mod resume;
