//! The pinned Python environments of the tests, recreated only when a pin changes.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::workspace::{self, MODULE, output};

/// A Python minor version, (3, 11).
type Version = (u32, u32);

/// A Python interpreter on this machine.
#[derive(Clone, Debug)]
pub(crate) struct Interpreter {
    path: PathBuf,
    version: Version,
}

/// A set of pinned packages.
pub(crate) struct Environment {
    /// The name of its folder below `target/oracles` and of its requirements file.
    pub(crate) name: &'static str,
    /// The first and the last Python version for which all its packages have wheels, if there is a known last one.
    versions: (Version, Option<Version>),
    /// The files or folders of the tests that run in it.
    pub(crate) tests: &'static [&'static str],
}

/// Whether tests can run in an environment.
pub(crate) enum Readiness {
    /// The path of its Python.
    Ready(PathBuf),
    Failed(String),
    /// This machine lacks what it is made of.
    Skipped(String),
}

/// The tests that compare with other libraries.
const ORACLES: &[&str] = &["tests/oracles"];

/// The newest OpenUSD and the other oracles.
pub(crate) const CURRENT: Environment = Environment {
    name: "current",
    versions: ((3, 11), None),
    tests: ORACLES,
};

/// The readers of robot descriptions, and MuJoCo.
pub(crate) const ROBOT: Environment = Environment {
    name: "robot",
    versions: ((3, 11), Some((3, 13))),
    tests: &[
        "tests/oracles/test_collada.py",
        "tests/oracles/test_heaps.py",
        "tests/oracles/test_robot.py",
        "tests/oracles/test_robot_reading.py",
        "tests/oracles/test_robot_usd.py",
    ],
};

/// The newest OpenUSD, the generation of Isaac Sim 5.1, and the readers of data sets and of robot descriptions.
pub(crate) const ENVIRONMENTS: [Environment; 4] = [
    CURRENT,
    Environment {
        name: "datasets",
        versions: ((3, 11), None),
        tests: &[
            "tests/oracles/test_generate.py",
            "tests/oracles/test_generate_annotations.py",
            "tests/oracles/test_generate_files.py",
            "tests/oracles/test_generate_stereo.py",
            "tests/oracles/test_imu.py",
        ],
    },
    ROBOT,
    Environment {
        name: "usd-24.5",
        versions: ((3, 10), Some((3, 11))),
        tests: ORACLES,
    },
];

/// The environment in which the Python package is tested and the manual is built.
pub(crate) const PACKAGE: Environment = Environment {
    name: "python",
    versions: ((3, 11), None),
    tests: &["crates/python/tests"],
};

/// [`PACKAGE`] with the large peers, which it replaces.
pub(crate) const PEERS: Environment = Environment {
    name: "peers",
    versions: ((3, 11), None),
    tests: &["crates/python/tests"],
};

/// `PyTorch`, which takes several gigabytes, for the tests with tensors.
pub(crate) const TORCH: Environment = Environment {
    name: "torch",
    versions: ((3, 11), None),
    tests: &[
        "crates/python/tests/test_torch.py",
        "crates/python/tests/test_example_training.py",
        "crates/python/tests/test_isaaclab.py",
        "crates/python/tests/test_stream.py",
        "crates/python/tests/test_warp.py",
    ],
};

/// The oldest versions of the package's own dependencies, without anything else such as pytest.
pub(crate) const BARE: Environment = Environment {
    name: "bare",
    versions: ((3, 10), Some((3, 11))),
    tests: &["crates/python/tests/bare.py"],
};

/// Blender, which takes a gigabyte.
pub(crate) const BLENDER: Environment = Environment {
    name: "blender",
    versions: ((3, 11), Some((3, 11))),
    tests: &["tests/oracles/test_blender.py"],
};

/// Open3D and the other peers of the renderer, created only on request because they are large.
pub(crate) const RENDER: Environment = Environment {
    name: "render",
    versions: ((3, 11), None),
    tests: &["tests/oracles/test_mitsuba.py", "tests/oracles/test_render.py"],
};

impl Interpreter {
    /// Finds interpreters under their usual names, the default one first. `OAKTWIN_PYTHON` takes precedence.
    pub(crate) fn find_all() -> Vec<Self> {
        let own = std::env::var_os("OAKTWIN_PYTHON").map(PathBuf::from);
        let names = [
            "python3",
            "python",
            "python3.11",
            "python3.12",
            "python3.13",
            "python3.10",
        ];
        own.into_iter()
            .chain(names.map(PathBuf::from))
            .filter_map(Self::ask)
            .collect()
    }

    fn ask(path: PathBuf) -> Option<Self> {
        let version = "import sys; print('%d.%d' % sys.version_info[:2])";
        let answer = output(Command::new(&path).args(["-c", version])).ok()?;
        let (major, minor) = answer.trim().split_once('.')?;
        let version = (major.parse().ok()?, minor.parse().ok()?);
        (version.0 == 3).then_some(Self { path, version })
    }
}

impl Environment {
    /// Whether the Python package is installed in it.
    pub(crate) fn has_package(&self) -> bool {
        self.tests.iter().all(|tests| tests.starts_with("crates/python/"))
    }

    /// Returns the first suitable interpreter, or the reason why there is none.
    pub(crate) fn choose<'a>(&self, interpreters: &'a [Interpreter]) -> Result<&'a Interpreter, String> {
        let (first, last) = self.versions;
        let fits = |version| version >= first && last.is_none_or(|last| version <= last);
        if let Some(interpreter) = interpreters.iter().find(|interpreter| fits(interpreter.version)) {
            return Ok(interpreter);
        }
        let wanted = match last {
            Some(last) => format!("Python {} to {}", dotted(first), dotted(last)),
            None => format!("Python {} or newer", dotted(first)),
        };
        let mut found: Vec<_> = interpreters
            .iter()
            .map(|interpreter| dotted(interpreter.version))
            .collect();
        found.dedup();
        let found = if found.is_empty() {
            "no Python 3".to_owned()
        } else {
            format!("only {}", found.join(", "))
        };
        Err(format!(
            "its packages want {wanted}, and {found} is here; OAKTWIN_PYTHON can name another"
        ))
    }

    /// The folder of the environment.
    pub(crate) fn folder(&self) -> PathBuf {
        workspace::target().join("oracles").join(self.name)
    }

    /// Prepares the environment with the first suitable interpreter, and returns the path of its Python.
    pub(crate) fn ready(&self) -> Result<PathBuf, String> {
        self.prepare(self.choose(&Interpreter::find_all())?)
    }

    /// Prepares the environment for tests, which are skipped without a suitable interpreter or the package index.
    pub(crate) fn readiness(&self, interpreters: &[Interpreter]) -> Readiness {
        match self.choose(interpreters) {
            Err(reason) => Readiness::Skipped(reason),
            Ok(interpreter) => match self.prepare(interpreter) {
                Ok(python) => Readiness::Ready(python),
                Err(message) if is_offline(&message) => Readiness::Skipped(OFFLINE.to_owned()),
                Err(message) => Readiness::Failed(message),
            },
        }
    }

    /// Creates the environment unless it matches its requirements file, and returns the path of its Python.
    pub(crate) fn prepare(&self, interpreter: &Interpreter) -> Result<PathBuf, String> {
        let pins = workspace::root().join(format!("tests/oracles/requirements-{}.txt", self.name));
        let text = pinned(&pins)?;
        let stamp = format!("Python {}\n{text}", dotted(interpreter.version));
        let folder = workspace::target().join("oracles");
        prepare_in(&folder, self.name, interpreter, &pins, &stamp)
    }
}

/// Returns a command for a Python that ignores the user's own packages.
pub(crate) fn isolated(python: &Path) -> Command {
    let mut command = Command::new(python);
    command.env_remove("PYTHONPATH").env_remove("PYTHONHOME");
    command
}

/// Returns the text of a requirements file and of the files that it includes.
fn pinned(file: &Path) -> Result<String, String> {
    let mut text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let included: Vec<_> = text.lines().filter_map(|line| line.strip_prefix("-r ")).collect();
    let included: Vec<_> = included
        .iter()
        .map(|name| file.with_file_name(name.trim()))
        .collect();
    for file in included {
        text += &fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    }
    Ok(text)
}

/// Builds the native module of the Python package with one of cargo's profiles, packs it into a wheel, and returns its path.
pub(crate) fn build_wheel(python: &Path, profile: &str) -> Result<PathBuf, String> {
    let mut built = workspace::build(&["--workspace", "--lib", "--profile", profile])?;
    let module = built.remove(MODULE).ok_or("cargo built no native module")?;
    pack_wheel(python, &module)
}

/// Packs the Python package with a native module into a wheel, and returns its path.
pub(crate) fn pack_wheel(python: &Path, module: &Path) -> Result<PathBuf, String> {
    let folder = workspace::target().join("oracles/wheels");
    let failed = |error: &std::io::Error| format!("{}: {error}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| failed(&error))?;
    }
    let mut pack = Command::new(python);
    pack.current_dir(workspace::root());
    pack.args(["xtask/wheel.py", "crates/python"])
        .arg(module)
        .arg(&folder);
    let printed = output(&mut pack)?;
    Ok(PathBuf::from(printed.trim()))
}

/// Installs the wheel of the Python package in an environment.
pub(crate) fn install_wheel(python: &Path, wheel: &Path) -> Result<(), String> {
    let mut install = Command::new(python);
    install.args([
        "-m",
        "pip",
        "install",
        "--disable-pip-version-check",
        "--no-input",
    ]);
    install.args(["--no-deps", "--force-reinstall"]).arg(wheel);
    output(&mut install)?;
    // Its only dependency, NumPy, is installed.
    output(Command::new(python).args(["-m", "pip", "check", "--disable-pip-version-check"]))?;
    Ok(())
}

fn prepare_in(
    folder: &Path,
    name: &str,
    interpreter: &Interpreter,
    pins: &Path,
    stamp: &str,
) -> Result<PathBuf, String> {
    let place = folder.join(name);
    let python = place.join(if cfg!(windows) {
        "Scripts/python.exe"
    } else {
        "bin/python"
    });
    let stamp_file = place.join("made-from.txt");
    let failed = |what: &Path, error: &std::io::Error| format!("{}: {error}", what.display());
    fs::create_dir_all(folder).map_err(|error| failed(folder, &error))?;

    // Held until the return: a second run waits instead of using a half-made environment.
    let lock_file = folder.join(format!("{name}.lock"));
    let lock = File::create(&lock_file).map_err(|error| failed(&lock_file, &error))?;
    lock.lock().map_err(|error| failed(&lock_file, &error))?;

    // The interpreter it was made with may be gone, so it is also asked.
    if is_as(&stamp_file, stamp) && output(Command::new(&python).arg("--version")).is_ok() {
        return Ok(python);
    }
    if place.exists() {
        fs::remove_dir_all(&place).map_err(|error| failed(&place, &error))?;
    }
    output(Command::new(&interpreter.path).args(["-m", "venv"]).arg(&place)).map_err(|error| {
        format!("{error}\nThis Python cannot make environments; install its venv and ensurepip (Debian: python3-venv)")
    })?;
    // The file pins every package; the check below reports missing ones.
    let mut install = Command::new(&python);
    install.args([
        "-m",
        "pip",
        "install",
        "--disable-pip-version-check",
        "--no-input",
        "--no-deps",
    ]);
    install
        .args(["--only-binary", ":all:", "--retries", "5", "--requirement"])
        .arg(pins);
    output(&mut install).map_err(|error| match is_offline(&error) {
        true => format!("{error}\n{OFFLINE}"),
        false => error,
    })?;
    output(Command::new(&python).args(["-m", "pip", "check", "--disable-pip-version-check"]))?;
    // Last, so that an interrupted installation is repeated.
    fs::write(&stamp_file, stamp).map_err(|error| failed(&stamp_file, &error))?;
    Ok(python)
}

/// Why an environment is not made without a network.
const OFFLINE: &str = "the package index cannot be reached; run again with a network";

/// Whether pip failed because it could not reach the package index: it says how many attempts remain, and names the last.
fn is_offline(message: &str) -> bool {
    message.contains("Retry(total=0,") || message.contains("Max retries exceeded")
}

fn is_as(file: &Path, text: &str) -> bool {
    fs::read_to_string(file).is_ok_and(|found| found == text)
}

fn dotted((major, minor): Version) -> String {
    format!("{major}.{minor}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn interpreter(version: Version) -> Interpreter {
        Interpreter {
            path: "python3".into(),
            version,
        }
    }

    #[test]
    fn chooses_the_first_suitable_interpreter() {
        let found = [interpreter((3, 13)), interpreter((3, 10)), interpreter((3, 11))];
        let [current, _, _, old] = &ENVIRONMENTS;
        assert_eq!(current.choose(&found).unwrap().version, (3, 13));
        assert_eq!(old.choose(&found).unwrap().version, (3, 10));
        let reason = old.choose(&found[..1]).unwrap_err();
        assert!(
            reason.contains("3.10 to 3.11") && reason.contains("only 3.13"),
            "{reason}"
        );
        assert!(current.choose(&[]).unwrap_err().contains("no Python 3"));
    }

    #[test]
    fn recreates_incomplete_environments_and_keeps_complete_ones() {
        let Some(found) = Interpreter::ask("python3".into()) else {
            println!("skipped: no python3");
            return;
        };
        let folder = tempfile::tempdir().unwrap();
        let pins = folder.path().join("requirements.txt");
        fs::write(&pins, "").unwrap();
        let rubbish = folder.path().join("small/half-made");
        fs::create_dir_all(rubbish.parent().unwrap()).unwrap();
        fs::write(&rubbish, "").unwrap();
        let make = |stamp| prepare_in(folder.path(), "small", &found, &pins, stamp);
        let python = match make("one") {
            Err(error) if error.contains("ensurepip") => return println!("skipped: {error}"),
            other => other.unwrap(),
        };
        assert!(python.exists() && !rubbish.exists());

        fs::write(&rubbish, "kept").unwrap();
        make("one").unwrap();
        assert!(rubbish.exists(), "an environment with the right stamp is kept");
        make("two").unwrap();
        assert!(!rubbish.exists(), "a changed pin makes it again");
    }

    #[test]
    fn reads_included_requirements() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str| folder.path().join(name);
        fs::write(file("light.txt"), "numpy==1\n").unwrap();
        fs::write(file("large.txt"), "-r light.txt\nray==2\n").unwrap();
        let first = pinned(&file("large.txt")).unwrap();
        assert!(first.contains("numpy==1") && first.contains("ray==2"));
        fs::write(file("light.txt"), "numpy==2\n").unwrap();
        assert_ne!(pinned(&file("large.txt")).unwrap(), first);
        fs::remove_file(file("light.txt")).unwrap();
        assert!(pinned(&file("large.txt")).unwrap_err().contains("light.txt"));
    }

    #[test]
    fn tells_a_missing_network_from_a_wrong_pin() {
        let retry = |left| {
            format!(
                "WARNING: Retrying (Retry(total={left}, connect=None)) after connection broken by 'NewConnectionError'\n"
            )
        };
        let none =
            "ERROR: Could not find a version that satisfies the requirement numpy==0 (from versions: none)";
        let others =
            "ERROR: Could not find a version that satisfies the requirement numpy==0 (from versions: 1, 2)";
        assert!(is_offline(&[retry(1), retry(0), none.to_owned()].concat()));
        assert!(!is_offline(others));
        assert!(!is_offline(&(retry(4) + others)), "the network came back");
    }

    #[test]
    fn reports_a_python_without_venv() {
        let folder = tempfile::tempdir().unwrap();
        let nobody = Interpreter {
            path: "no-such-python".into(),
            version: (3, 11),
        };
        let error = prepare_in(folder.path(), "small", &nobody, Path::new("none"), "").unwrap_err();
        assert!(error.contains("python3-venv"), "{error}");
    }
}
