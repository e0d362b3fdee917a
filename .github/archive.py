"""Packs a built program with its completions, man pages and licences into the archive of a release.

    python .github/archive.py TARGET FOLDER_OF_THE_PROGRAM FOLDER_OF_THE_ARCHIVE

The names are those that `cargo binstall` looks for: the table [package.metadata.binstall] of crates/cli/Cargo.toml.
"""

import io
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TEXTS = ["README.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT", "crates/python/THIRD-PARTY-LICENSES.txt"]
# The names of their files are those that the shells look for.
COMPLETIONS = {"bash": "oaktwin.bash", "elvish": "oaktwin.elv", "fish": "oaktwin.fish", "powershell": "_oaktwin.ps1", "zsh": "_oaktwin"}


def output(program: Path, *arguments: str) -> str:
    return subprocess.run([program, *arguments], capture_output=True, text=True, encoding="utf-8", check=True).stdout


def man_pages(program: Path, *command: str) -> dict[str, str]:
    """Returns the page of a command and the pages of its subcommands, which the command lists."""
    page = output(program, "man", *command)
    name = "-".join(["oaktwin", *command])
    pages = {f"{name}.1": page}
    for listed in re.findall(r"^(oaktwin\S+)\(1\)$", page, flags=re.MULTILINE):
        words = listed.replace("\\-", "-").removeprefix(f"{name}-")
        if words != "help":
            pages |= man_pages(program, *command, words)
    return pages


def contents(program: Path) -> dict[str, bytes]:
    files = {f"completions/{file}": output(program, "completions", shell) for shell, file in COMPLETIONS.items()}
    files |= {f"man/{name}": page for name, page in man_pages(program).items()}
    packed = {name: text.encode() for name, text in files.items()}
    return packed | {Path(name).name: (ROOT / name).read_bytes() for name in TEXTS}


def names(target: str) -> tuple[str, str, str]:
    """Returns the names of the archive and of the program in it, and the version."""
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    manifest = tomllib.loads((ROOT / "crates/cli/Cargo.toml").read_text(encoding="utf-8"))
    binstall = manifest["package"]["metadata"]["binstall"]
    kind = binstall.get("overrides", {}).get(target, binstall)["pkg-fmt"]
    values = {
        "repo": "", "version": version, "target": target, "bin": "oaktwin",
        "binary-ext": ".exe" if "windows" in target else "", "archive-suffix": f".{kind}",
    }

    def filled(template: str) -> str:
        return re.sub(r"\{ *([\w-]+) *\}", lambda found: values[found[1]], template)

    return filled(binstall["pkg-url"]).rsplit("/", 1)[-1], filled(binstall["bin-dir"]), version


def pack(archive: Path, files: dict[str, bytes], program: str) -> None:
    modes = {name: 0o755 if name == program else 0o644 for name in files}
    if archive.suffix == ".zip":
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as packed:
            for name, data in files.items():
                entry = zipfile.ZipInfo(name)
                entry.external_attr = modes[name] << 16
                packed.writestr(entry, data, zipfile.ZIP_DEFLATED)
        return
    with tarfile.open(archive, "w:gz") as packed:
        for name, data in files.items():
            entry = tarfile.TarInfo(name)
            entry.size, entry.mode = len(data), modes[name]
            packed.addfile(entry, io.BytesIO(data))


def main(target: str, built: Path, folder: Path) -> None:
    archive, inside, version = names(target)
    program = built / Path(inside).name
    shown = output(program, "--version")
    if version not in shown:
        raise SystemExit(f"{program}: is {shown.strip()}, not version {version}")
    top = Path(inside).parent.as_posix()
    files = {f"{top}/{name}": data for name, data in sorted(contents(program).items())}
    files[inside] = program.read_bytes()
    folder.mkdir(parents=True, exist_ok=True)
    pack(folder / archive, files, inside)
    print(f"{folder / archive}: {len(files)} files, {(folder / archive).stat().st_size} bytes")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3]))
