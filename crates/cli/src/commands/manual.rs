//! Shell completions and manual pages, generated from the arguments.

use clap::CommandFactory;
use oaktwin::diagnostic::nearest;

use crate::args::{Cli, CompletionsArgs, ManArgs};
use crate::context::{Exit, Result};
use crate::output;

pub(crate) fn completions(args: &CompletionsArgs) -> Result<Exit> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "oaktwin", &mut script);
    output::print(&String::from_utf8(script)?)?;
    Ok(Exit::Success)
}

pub(crate) fn man(args: &ManArgs) -> Result<Exit> {
    let mut command = Cli::command();
    command.build();
    for name in &args.command {
        let Some(sub) = command.find_subcommand(name) else {
            let near = nearest(name, command.get_subcommands().map(clap::Command::get_name));
            let hint = near
                .first()
                .map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            return Err(format!("unknown command `{name}`{hint}").into());
        };
        command = sub.clone();
    }
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page)?;
    output::print(&String::from_utf8(page)?)?;
    Ok(Exit::Success)
}
