//! From scenes and depth images to captures on disk.
//!
//! * [`render`] opens a scene, places cameras in it and writes what they see;
//! * [`sense`] runs a depth sensor on existing depth images;
//! * [`stereo`] matches existing pairs of images, and [`pair`] renders such pairs;
//! * [`imu`] simulates the inertial sensor of a twin along a trajectory;
//! * [`align`] aligns depth to another camera of the device;
//! * [`sensor`] configures the depth sensor of a twin;
//! * [`mod@unit`] opens one unit's calibration as a twin, and [`report`] describes a twin;
//! * [`input`] reads depth images from files and folders;
//! * [`recording`] opens recordings for ROS 2, Foxglove and Rerun;
//! * [`progress`] reports the progress of all of them, and interrupts them.

pub mod align;
mod geometry;
pub mod imu;
pub mod input;
mod limits;
pub mod pair;
pub mod progress;
pub mod recording;
pub mod render;
pub mod report;
pub mod sense;
pub mod sensor;
pub mod stereo;
pub mod unit;
mod write;
