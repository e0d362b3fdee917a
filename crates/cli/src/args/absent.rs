use std::ffi::OsString;

use clap::Args;

/// The arguments of a command that this build does not include: anything, so that the error is about the build.
#[derive(Args, Debug)]
#[command(disable_help_flag = true)]
pub(crate) struct AbsentArgs {
    #[arg(hide = true, allow_hyphen_values = true, trailing_var_arg = true)]
    _ignored: Vec<OsString>,
}
