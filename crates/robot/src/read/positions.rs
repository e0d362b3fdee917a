//! Lists of joint positions.

use std::path::Path;

use oaktwin_base::diagnostic::suggest;
use oaktwin_files as files;

use super::RobotFileError;
use super::document::XmlError;
use super::robot::{JointKind, Robot};
use super::size::LARGEST;

/// The maximum size of a file in bytes: some million positions.
const MAX_BYTES: u64 = 256 << 20;

/// The column with times.
const TIME: &str = "time";

/// The end of the name of a column in degrees.
const DEGREES: &str = "_deg";

/// Positions of a robot's joints: a posture after the other.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct JointPositions {
    /// The time of each posture in seconds, if the file has it.
    pub times_s: Vec<Option<f64>>,
    /// The position of every joint of the robot in each posture, radians or metres.
    pub positions: Vec<Vec<f64>>,
    /// The names of the joints that the file leaves at their rest.
    pub at_rest: Vec<String>,
}

impl JointPositions {
    /// Reads a table in CSV: the first line has the names of joints, each further line a posture, in radians and metres. A column `NAME_deg` is in
    /// degrees, a column `time` in seconds. Joints without a column are at [`Robot::rest`].
    ///
    /// # Errors
    /// Returns an error if a column is no joint of the robot, or a position is not a number within the limits of its joint; with the line and
    /// the column.
    pub fn read(path: &Path, robot: &Robot) -> Result<Self, RobotFileError> {
        Self::parse(path, &files::read(path, MAX_BYTES, "joint positions")?, robot)
    }

    /// Reads the content of a table; `path` is its name in errors.
    ///
    /// # Errors
    /// Returns the errors of [`read`](Self::read).
    pub fn parse(path: &Path, bytes: &[u8], robot: &Robot) -> Result<Self, RobotFileError> {
        let wrong = |line: u64, message: String, remedy: String| {
            let (file, place) = (path.to_owned(), format!("line {line}"));
            RobotFileError::At(XmlError {
                file,
                place,
                message,
                remedy,
            })
        };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .flexible(true)
            .from_reader(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes));
        let mut columns: Option<Vec<(String, Column)>> = None;
        let mut read = Self::default();
        for record in reader.records() {
            let record = record.map_err(|error| {
                let line = error.position().map_or(1, csv::Position::line);
                wrong(line, "is not text".to_owned(), "give a table in CSV".to_owned())
            })?;
            let line = record.position().map_or(1, csv::Position::line);
            let Some(columns) = &columns else {
                columns =
                    Some(header(&record, robot).map_err(|(message, remedy)| wrong(line, message, remedy))?);
                continue;
            };
            if record.len() != columns.len() {
                let message = format!("{} values, but {} columns", record.len(), columns.len());
                let remedy = "give one value for each name of the first line".to_owned();
                return Err(wrong(line, message, remedy));
            }
            let mut positions = robot.rest();
            let mut time_s = None;
            for ((name, column), text) in columns.iter().zip(&record) {
                let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
                let value = value.ok_or_else(|| {
                    wrong(
                        line,
                        format!("{name}: '{text}' is not a finite number"),
                        "give radians or metres".to_owned(),
                    )
                })?;
                match *column {
                    Column::Time => time_s = Some(value),
                    Column::Joint { joint, factor } => {
                        let position = value * factor;
                        robot
                            .check(joint, position)
                            .map_err(|(message, remedy)| wrong(line, message, remedy))?;
                        positions[joint] = position;
                    }
                }
            }
            read.positions.push(robot.followed(positions));
            read.times_s.push(time_s);
        }
        let columns = columns.unwrap_or_default();
        if read.positions.is_empty() {
            let remedy = "give a first line with the names of joints, and a line for each posture";
            return Err(wrong(1, "there are no positions".to_owned(), remedy.to_owned()));
        }
        let has_column = |index: usize| {
            columns
                .iter()
                .any(|(_, column)| matches!(column, Column::Joint { joint, .. } if *joint == index))
        };
        read.at_rest = (robot.free_joints())
            .filter(|&index| !has_column(index))
            .map(|index| robot.joints[index].name.clone())
            .collect();
        Ok(read)
    }

    /// Returns the positions of a robot in one posture, at which no joint is moved.
    #[must_use]
    pub fn rest(robot: &Robot) -> Self {
        Self {
            times_s: vec![None],
            positions: vec![robot.rest()],
            at_rest: Vec::new(),
        }
    }
}

/// What a column has.
#[derive(Clone, Copy)]
enum Column {
    Time,
    Joint { joint: usize, factor: f64 },
}

type PositionProblem = (String, String);

fn header(record: &csv::StringRecord, robot: &Robot) -> Result<Vec<(String, Column)>, PositionProblem> {
    let mut columns: Vec<(String, Column)> = Vec::new();
    for name in record {
        let column = column(name, robot)?;
        let is_same = |other: &Column| match (*other, column) {
            (Column::Time, Column::Time) => true,
            (Column::Joint { joint: a, .. }, Column::Joint { joint: b, .. }) => a == b,
            _ => false,
        };
        if columns.iter().any(|(_, other)| is_same(other)) {
            return Err((
                format!("'{name}' is there twice"),
                "remove one of the columns".to_owned(),
            ));
        }
        columns.push((name.to_owned(), column));
    }
    Ok(columns)
}

fn column(name: &str, robot: &Robot) -> Result<Column, PositionProblem> {
    let find = |name: &str| robot.joints.iter().position(|joint| joint.name == name);
    let in_degrees = || {
        let joint = find(name.strip_suffix(DEGREES)?)?;
        (robot.joints[joint].kind == JointKind::Revolute).then_some((joint, 1f64.to_radians()))
    };
    let found = find(name).map(|joint| (joint, 1.0)).or_else(in_degrees);
    let Some((joint, factor)) = found else {
        if name == TIME {
            return Ok(Column::Time);
        }
        let known = robot.free_joints().map(|joint| robot.joints[joint].name.as_str());
        return Err((format!("no joint '{name}' moves"), suggest(name, known)));
    };
    match robot.joints[joint].mimic {
        Some(mimic) => {
            let other = &robot.joints[mimic.joint].name;
            Err((
                format!("the joint '{name}' follows '{other}'"),
                "remove the column".to_owned(),
            ))
        }
        None => Ok(Column::Joint { joint, factor }),
    }
}

impl Robot {
    /// Checks a position of a joint. Returns what is wrong and what to do.
    ///
    /// # Errors
    /// Returns an error if the position is outside the limits, with some room for rounding, or too large for poses to be computed.
    pub fn check(&self, joint: usize, position: f64) -> Result<(), (String, String)> {
        const ROUNDING: f64 = 1e-6;
        let joint = &self.joints[joint];
        match joint.limits {
            Some([low, high]) if !(low - ROUNDING..=high + ROUNDING).contains(&position) => {
                let unit = joint.unit();
                Err((
                    format!("{} is {position} {unit}, outside its limits", joint.name),
                    format!("give {low} to {high} {unit}"),
                ))
            }
            None if position.abs() > LARGEST => Err((
                format!("{} is {position:e} {}", joint.name, joint.unit()),
                format!("give up to {LARGEST:e}"),
            )),
            _ => Ok(()),
        }
    }
}
