use std::net::Ipv4Addr;
use std::num::NonZeroU32;

use clap::Args;
use oaktwin::camera::frame_names;
use oaktwin::sense::InputKind;
use oaktwin_bridge::convert::Encoding;

use super::choice::parser;
use super::{SensorArgs, ThreadArgs, UnitArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    after_help = "The bridge subscribes to a simulator's exact depth (sensor_msgs/Image, 32FC1 in metres or 16UC1 in millimetres) and \
    publishes what the OAK would report, with the stamps and frame ids of the input, as sensor data (best-effort): \
    OUT/stereo/image_raw and OUT/stereo/camera_info (OUT/tof/… for a time-of-flight sensor), with --points OUT/points, with --compressed \
    OUT/stereo/image_raw/compressedDepth, with --rgb OUT/rgb/image_raw and OUT/rgb/camera_info, with --tf /tf_static. \
    The options of the depth sensor are parameters of the node: `ros2 param set /oaktwin_bridge preset robotics`, or lines on standard \
    input with --stdin.\n\n\
    Best-effort messages are sent to each subscriber alone. With --reliable, lost parts are sent again, but the bridge keeps the images of 6 s \
    in memory, one subscriber that hangs holds up all others until its lease ends, and subscribers that announce a multicast address are \
    sent to by multicast.\n\n\
    It reads ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY and ROS_AUTOMATIC_DISCOVERY_RANGE, and runs until Ctrl-C."
)]
pub(crate) struct BridgeArgs {
    /// The model
    #[arg(long)]
    pub(crate) model: String,

    /// The topic of the exact depth
    #[arg(long, value_name = "TOPIC")]
    pub(crate) depth: String,

    /// The topic of the depth images' camera info [default: --fx, --hfov or the model's field of view]
    #[arg(long, value_name = "TOPIC", conflicts_with_all = ["fx", "hfov"])]
    pub(crate) info: Option<String>,

    /// The topic of colour images with the same camera and stamps as the depth images
    #[arg(long, value_name = "TOPIC")]
    pub(crate) rgb: Option<String>,

    /// The namespace of the published topics
    #[arg(long, value_name = "NAMESPACE", default_value = "/oak")]
    pub(crate) out: String,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// The depth sensor: stereo, tof or a prim [default: time of flight if the model has it]
    #[arg(long, value_name = "KIND|PRIM")]
    pub(crate) sensor: Option<String>,

    /// The kind of depth: along the optical axis (z) or from the optical centre (range)
    #[arg(long, value_parser = parser::<InputKind>(), default_value_t, help_heading = "Images")]
    pub(crate) input_kind: InputKind,

    /// The focal length of the images, px
    #[arg(long, value_name = "F", conflicts_with = "hfov", help_heading = "Images")]
    pub(crate) fx: Option<f64>,

    /// The horizontal field of view of the images, degrees
    #[arg(long, value_name = "D", help_heading = "Images")]
    pub(crate) hfov: Option<f64>,

    /// Resample images of another size or field of view to the model's (nearest samples)
    #[arg(long, help_heading = "Images")]
    pub(crate) resample: bool,

    #[command(flatten, next_help_heading = "Depth sensor")]
    pub(crate) engine: SensorArgs,

    /// The encoding of the published depth
    #[arg(long, value_parser = parser::<Encoding>(), default_value_t, help_heading = "Outputs")]
    pub(crate) encoding: Encoding,

    /// Also publish point clouds, with colours if --rgb is given
    #[arg(long, help_heading = "Outputs")]
    pub(crate) points: bool,

    /// Make a point of every Nth pixel of every Nth row
    #[arg(
        long,
        value_name = "N",
        default_value = "1",
        requires = "points",
        help_heading = "Outputs"
    )]
    pub(crate) points_step: NonZeroU32,

    /// Also publish the depth as PNG, as the image transport of compressed depth reads it
    #[arg(long, help_heading = "Outputs")]
    pub(crate) compressed: bool,

    /// Publish later, by seconds, LOW,HIGH (drawn once), or the catalog's latency [default: at once]
    ///
    /// Delays count from the arrival of the exact depth, so the simulation has to run in real time. Stamps stay the times of exposure.
    /// What is drawn depends on --seed and the stamps alone.
    #[arg(long, value_name = "SECONDS|LOW,HIGH|catalog", help_heading = "Delivery")]
    pub(crate) latency: Option<String>,

    /// The largest additional delay of a single frame, in seconds [default: 0, or the catalog's]
    #[arg(long, value_name = "SECONDS", help_heading = "Delivery")]
    pub(crate) jitter: Option<f64>,

    /// The probability that a frame is lost
    #[arg(long, value_name = "P", default_value_t = 0.0, help_heading = "Delivery")]
    pub(crate) drop: f64,

    /// Offer reliable delivery, which reliable subscribers require [default: best-effort]
    #[arg(long, help_heading = "ROS 2")]
    pub(crate) reliable: bool,

    /// Publish the static transforms of the device's frames, whose names begin with NAME [default: oak]
    #[arg(long, value_name = "NAME", num_args = 0..=1, default_missing_value = frame_names::DEVICE, help_heading = "Outputs")]
    pub(crate) tf: Option<String>,

    /// Accept only publishers with reliable delivery [default: best-effort ones too]
    #[arg(long, help_heading = "ROS 2")]
    pub(crate) reliable_inputs: bool,

    /// The IPv4 address of the only network interface to use beside loopback [default: all]
    #[arg(long, value_name = "ADDRESS", help_heading = "ROS 2")]
    pub(crate) interface: Option<Ipv4Addr>,

    /// The name of the node
    #[arg(
        long,
        value_name = "NAME",
        default_value = "oaktwin_bridge",
        help_heading = "ROS 2"
    )]
    pub(crate) node: String,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

    /// Also read parameters from standard input, one NAME=VALUE per line, such as preset=robotics
    #[arg(long, help_heading = "ROS 2")]
    pub(crate) stdin: bool,

    /// Print events, and the state every 10 s, as JSON lines
    #[arg(long, help_heading = "Execution")]
    pub(crate) json: bool,
}
