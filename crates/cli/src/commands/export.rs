use crate::args::CalibrationExportArgs;
use crate::context::{Context, Exit, Result};

pub(crate) fn run(_context: &Context, _args: &CalibrationExportArgs) -> Result<Exit> {
    Ok(Exit::Good)
}
