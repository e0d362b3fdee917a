//! The program as its users meet it: whole outputs as snapshots, bad inputs, exit codes, files left behind.

#![expect(clippy::unwrap_used, reason = "a test")]

mod accuracy;
mod assets;
mod bad_input;
mod bridge;
mod coverage;
mod exhaustive_models;
mod export;
mod finite;
mod fit;
mod generate;
mod import;
mod memory;
mod named_files;
mod optics;
mod output;
mod params;
mod population;
mod program;
mod render;
mod render_bad_input;
mod render_frames;
mod render_imu;
mod render_interrupted;
mod render_outputs;
mod render_pair;
mod render_record;
mod render_sensor;
mod render_sensor_frames;
mod render_shutter;
mod robot;
mod scene_limit;
mod sense;
mod sense_bad_input;
mod sense_folders;
mod signals;
mod stereo;
mod studio;
mod whole_files;
