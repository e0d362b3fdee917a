//! The commands, one per module.

/// Defines the module of a command that is left out of this build.
#[cfg(not(all(feature = "bridge", feature = "generate", feature = "studio")))]
macro_rules! absent {
    ($command:ident) => {
        pub(crate) mod $command {
            use crate::args::AbsentArgs;
            use crate::context::{Context, Exit, Result};

            pub(crate) fn run(_: &Context, _: &AbsentArgs) -> Result<Exit> {
                Err(super::not_built_in(stringify!($command)).into())
            }
        }
    };
}

pub(crate) mod accuracy;
pub(crate) mod asset;
#[cfg(feature = "bridge")]
pub(crate) mod bridge;
pub(crate) mod calibration;
pub(crate) mod check;
pub(crate) mod compare;
pub(crate) mod coverage;
pub(crate) mod demo;
pub(crate) mod export;
pub(crate) mod fit;
#[cfg(feature = "generate")]
pub(crate) mod generate;
pub(crate) mod manual;
pub(crate) mod models;
pub(crate) mod params;
pub(crate) mod population;
pub(crate) mod render;
pub(crate) mod sense;
pub(crate) mod show;
pub(crate) mod stereo;
#[cfg(feature = "studio")]
pub(crate) mod studio;

#[cfg(not(feature = "bridge"))]
absent!(bridge);
#[cfg(not(feature = "generate"))]
absent!(generate);
#[cfg(not(feature = "studio"))]
absent!(studio);

/// Returns the error for a command that needs the feature of its name.
#[cfg(not(all(feature = "bridge", feature = "generate", feature = "studio")))]
fn not_built_in(command: &str) -> String {
    format!(
        "this build does not include `oaktwin {command}`; run `cargo install --locked oaktwin-cli --features {command}`, or in a \
         checkout `cargo run --release --features {command} -- {command} …`"
    )
}
