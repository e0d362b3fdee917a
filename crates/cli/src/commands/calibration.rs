mod export;
mod import;
mod show;
mod text;

use crate::args::{CalibrationArgs, CalibrationCommand};
use crate::context::{Context, Exit, Result};

pub(crate) fn run(context: &Context, args: &CalibrationArgs) -> Result<Exit> {
    match &args.command {
        CalibrationCommand::Show(args) => show::run(context, args),
        CalibrationCommand::Export(args) => export::run(context, args),
        CalibrationCommand::Import(args) => import::run(context, args),
    }
}
