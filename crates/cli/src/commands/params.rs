use std::fmt::Write;

use oaktwin::depth::parameters::{self, GROUPS, Listing, Platform};
use oaktwin::sensor::{EngineKind, SensorOptions, sensor};
use serde::Serialize;

use crate::args::ParamsArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

#[derive(Serialize)]
struct Group {
    name: &'static str,
    description: &'static str,
    parameters: Vec<Listing>,
}

pub(crate) fn run(context: &Context, args: &ParamsArgs) -> Result<Exit> {
    let groups: Vec<_> = match &args.group {
        Some(name) => vec![parameters::group(name)?],
        None => GROUPS.iter().collect(),
    };
    let groups: Vec<Group> = groups
        .into_iter()
        .map(|group| {
            Ok(Group {
                name: group.name,
                description: group.about,
                parameters: listings(context, args, group.name)?,
            })
        })
        .collect::<Result<_>>()?;
    let only = groups.first().filter(|_| args.group.is_some());
    match (only, args.json) {
        (Some(group), true) => output::print_json(group)?,
        (Some(group), false) => output::print(&text(group))?,
        (None, true) => output::print_json(&groups)?,
        (None, false) => output::print(&list(&groups))?,
    }
    Ok(Exit::Success)
}

/// The parameters of a group with their defaults on a platform or of a model.
fn listings(context: &Context, args: &ParamsArgs, name: &str) -> Result<Vec<Listing>> {
    let group = parameters::group(name)?;
    let Some(model) = &args.model else {
        return Ok(group.list_common_first(args.platform.unwrap_or_default()));
    };
    let twin = context.catalog.nominal(context.device(model)?);
    let platform = args.platform.or_else(|| twin.platform());
    let mut list = group.list_common_first(platform.unwrap_or_default());
    if let Ok(engine) = EngineKind::parse(name) {
        let options = SensorOptions {
            engine: Some(engine.into()),
            ..SensorOptions::default()
        };
        let sensors = twin.depth_sensors.iter().map(|own| sensor(&twin, own, &options));
        if let Some((sensor, _)) = sensors.flatten().next() {
            for (name, value) in sensor.engine().parameters() {
                let row = list.iter_mut().find(|row| row.about.name == name);
                row.into_iter().for_each(|row| row.default.clone_from(&value));
            }
        } else if args.group.is_some() {
            return Err(format!("{} has no depth sensor for {name}", twin.device.name).into());
        }
    }
    Ok(list)
}

fn list(groups: &[Group]) -> String {
    let mut out = String::new();
    for group in groups {
        let count = group.parameters.len();
        let _ = writeln!(out, "{:<16} {count:>3}  {}", group.name, group.description);
    }
    out
}

fn text(group: &Group) -> String {
    let mut out = format!("{}: {}\n", group.name, group.description);
    let mut table = group.name;
    for row in &group.parameters {
        if row.heading() != table {
            table = row.heading();
            let _ = write!(out, "\n{table}:\n");
        }
        let about = &row.about;
        let platform = about
            .platform
            .map(|platform: Platform| format!("; {} only", platform.title()));
        let _ = write!(
            out,
            "\n{} = {}\n    {}; {}{}\n    {}\n",
            about.name,
            row.default,
            about.values_text(),
            about.source,
            platform.unwrap_or_default(),
            about.doc
        );
    }
    out
}
