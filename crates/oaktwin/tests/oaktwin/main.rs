//! The tests of this crate, in one program.

mod custom_engine;
mod depth_sensor_scene;
mod glass;
mod plates;
mod rgb_imager;
mod shutter;
mod stereo_every_unit;
mod stereo_pipeline;
mod stereo_population;
