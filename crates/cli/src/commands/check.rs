use crate::args::CheckArgs;
use crate::context::{Context, Exit, Result};

pub(crate) fn run(_context: &Context, _args: &CheckArgs) -> Result<Exit> {
    Err("check is not wired".into())
}
