import subprocess
import sys
from importlib import metadata

import oaktwin


def run(*arguments):
    return subprocess.run([sys.executable, "-m", "oaktwin", *arguments], capture_output=True, text=True, encoding="utf-8")


def test_the_module_is_the_program(program):
    assert run("models").stdout == program("models")
    assert run("--help").stdout == program("--help")
    assert run("--version").stdout == f"oaktwin {oaktwin.__version__}\n"
    wrong = run("show", "OAK4-E")
    assert wrong.returncode == 2 and wrong.stderr == program("show", "OAK4-E", code=2)
    assert run("nonsense").returncode == 2


def test_metadata():
    assert metadata.version("oaktwin") == oaktwin.__version__
    assert metadata.metadata("oaktwin")["Requires-Python"] == ">=3.10"
    assert [point.value for point in metadata.entry_points(group="console_scripts", name="oaktwin")] == [
        "oaktwin.__main__:main"
    ]
    files = {str(file) for file in metadata.files("oaktwin")}
    assert {"oaktwin/py.typed", "oaktwin/_oaktwin.pyi", "oaktwin/_sensors.pyi"} <= files


def test_everything_public_is_documented():
    for name in oaktwin.__all__:
        item = getattr(oaktwin, name)
        assert name == "__version__" or item.__doc__, name
        if isinstance(item, type) and item.__module__ == "oaktwin":
            for member, value in vars(item).items():
                if not member.startswith("_") and name not in ["Error", "FindingWarning", "Finding"]:
                    assert value.__doc__, f"{name}.{member}"
