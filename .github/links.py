"""Adds the address of the repository to the metadata of the Python package and of the published crates, or replaces it.

    python .github/links.py https://github.com/OWNER/NAME
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PYTHON = ROOT / "crates/python/pyproject.toml"
WORKSPACE = ROOT / "Cargo.toml"
INHERITED = "repository.workspace = true\n"


def insert(path: Path, head: str, lines: dict[str, str]) -> None:
    """Writes lines below the head of a table, in place of those with the same keys."""
    text = path.read_text(encoding="utf-8")
    for key in lines:
        text = re.sub(rf'^{re.escape(key)} = ".*"\n', "", text, flags=re.MULTILINE)
    if text.count(head) != 1:
        raise SystemExit(f"{path}: expected one table {head.strip()}")
    added = "".join(f'{key} = "{value}"\n' for key, value in lines.items())
    path.write_text(text.replace(head, head + added), encoding="utf-8", newline="\n")


def main(address: str) -> None:
    if not re.fullmatch(r"https://[\w.-]+/[\w.-]+/[\w.-]+", address):
        raise SystemExit(f"{address}: not the address of a repository")
    changes = f"{address}/blob/main/CHANGELOG.md"
    insert(PYTHON, "[project.urls]\n", {"Repository": address, "Changelog": changes, "Issues": f"{address}/issues"})
    insert(WORKSPACE, "[workspace.package]\n", {"repository": address})
    for manifest in sorted((ROOT / "crates").glob("*/Cargo.toml")):
        text = manifest.read_text(encoding="utf-8")
        # The published crates are those that inherit their keywords.
        line = "keywords.workspace = true\n"
        if line in text and INHERITED not in text:
            manifest.write_text(text.replace(line, line + INHERITED), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main(sys.argv[1])
