"""Packs the Python package with a native module that cargo built into a wheel: `python wheel.py PACKAGE MODULE OUTPUT`.

Maturin builds the wheels of releases. It would compile the module again, because it chooses its features without the rest of the
workspace; here it writes only the metadata.
"""

import base64
import hashlib
import subprocess
import sys
import zipfile
from pathlib import Path

TAG = "cp310-abi3"


def main(package, module, output):
    output.mkdir(parents=True, exist_ok=True)
    metadata = output / "metadata"
    maturin = [sys.executable, "-m", "maturin", "pep517", "write-dist-info", "--metadata-directory", metadata]
    subprocess.run([*maturin, "--interpreter", sys.executable], cwd=package, check=True, stdout=subprocess.DEVNULL)
    [info] = metadata.glob("*.dist-info")
    sources = package / "python"
    files = {path.relative_to(sources).as_posix(): path for path in sorted(sources.rglob("*")) if is_source(path)}
    files[f"oaktwin/_oaktwin{'.pyd' if sys.platform == 'win32' else '.abi3.so'}"] = module
    files |= {path.relative_to(metadata).as_posix(): path for path in sorted(info.rglob("*")) if path.is_file()}
    for licence in package.glob("*LICENSE*"):
        files.setdefault(f"{info.name}/licenses/{licence.name}", licence)
    files.pop(f"{info.name}/RECORD", None)
    [platform] = [line.split("-")[-1] for line in (info / "WHEEL").read_text().splitlines() if line.startswith("Tag: ")]
    wheel = output / f"{info.name.removesuffix('.dist-info')}-{TAG}-{platform}.whl"
    record = []
    # Stored: a compressed module of a development build takes longer to write than to read.
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_STORED) as archive:
        for name, path in files.items():
            content = path.read_bytes()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(content)}\n")
            archive.writestr(name, content)
        archive.writestr(f"{info.name}/RECORD", "".join(record) + f"{info.name}/RECORD,,\n")
    print(wheel)


def is_source(path):
    return path.is_file() and path.suffix in {".py", ".pyi", ".typed", ""} and "__pycache__" not in path.parts


if __name__ == "__main__":
    main(*map(Path.resolve, map(Path, sys.argv[1:])))
