//! Negative numbers on the command line, which look like options.

use std::ffi::OsString;

use clap::{ArgAction, Command};

/// Lets every option of a command and its subcommands take negative numbers.
pub(crate) fn accept_negative(command: Command) -> Command {
    let command = command.mut_args(|arg| {
        let takes_values = matches!(arg.get_action(), ArgAction::Set | ArgAction::Append);
        // Lists of numbers take any value.
        if takes_values && !arg.is_allow_hyphen_values_set() {
            arg.allow_negative_numbers(true)
        } else {
            arg
        }
    });
    command.mut_subcommands(accept_negative)
}

/// Writes a negative number without an exponent, as the parser of arguments recognizes it: Python prints
/// `-1.2246467991473532e-16`. Other arguments are returned unchanged.
pub(crate) fn plain(argument: OsString) -> OsString {
    let number = argument.to_str().and_then(|text| {
        let digits = text.strip_prefix('-')?;
        if !digits.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return None;
        }
        text.parse().ok().filter(|number: &f64| number.is_finite())
    });
    match number {
        // The digits that give the same number again.
        Some(number) => format!("{number}").into(),
        None => argument,
    }
}

#[cfg(test)]
mod tests {
    use clap::{CommandFactory, FromArgMatches};

    use super::super::Cli;
    use super::*;

    #[test]
    fn numbers_lose_their_exponents_and_nothing_else() {
        for (argument, expected) in [
            ("-1.2246467991473532e-16", "-0.00000000000000012246467991473532"),
            ("-1e3", "-1000"),
            ("-.5", "-0.5"),
            ("-1.", "-1"),
            ("-0.0", "-0"),
            ("-1e400", "-1e400"),
            ("-1:2:0.5", "-1:2:0.5"),
            ("-o", "-o"),
            ("-inf", "-inf"),
            ("1e-5", "1e-5"),
            ("--pose=-1e-5", "--pose=-1e-5"),
            ("-", "-"),
        ] {
            assert_eq!(plain(argument.into()), expected, "{argument}");
        }
    }

    /// Gives each option that takes values a negative number for each: none may be taken for an unknown option.
    fn check(command: &Command, path: &[&str], wrong: &mut Vec<String>) {
        for arg in command.get_arguments() {
            let Some(long) = arg.get_long().filter(|_| arg.get_action().takes_values()) else {
                continue;
            };
            if arg.is_require_equals_set() {
                continue;
            }
            let count = arg.get_num_args().map_or(1, |count| count.min_values().max(1));
            let mut line: Vec<OsString> = path.iter().map(OsString::from).collect();
            line.push(format!("--{long}").into());
            line.extend(std::iter::repeat_n(plain("-1.2e-16".into()), count));
            let parser = accept_negative(Cli::command());
            let found = parser
                .try_get_matches_from(line)
                .and_then(|matches| Cli::from_arg_matches(&matches));
            if let Err(error) = found
                && error.kind() == clap::error::ErrorKind::UnknownArgument
            {
                wrong.push(format!("{} --{long}: {error}", path.join(" ")));
            }
        }
        for subcommand in command.get_subcommands() {
            check(subcommand, &[path, &[subcommand.get_name()]].concat(), wrong);
        }
    }

    #[test]
    fn every_option_takes_what_python_prints() {
        let mut wrong = Vec::new();
        check(&accept_negative(Cli::command()), &["oaktwin"], &mut wrong);
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}
