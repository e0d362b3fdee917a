"""Adds the address of a repository to the metadata of the Python package.

    python .github/links.py https://github.com/OWNER/NAME
"""

import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1] / "crates/python/pyproject.toml"


def main(address: str) -> None:
    if not re.fullmatch(r"https://[\w.-]+/[\w.-]+/[\w.-]+", address):
        raise SystemExit(f"{address}: not the address of a repository")
    links = {"Repository": address, "Changelog": f"{address}/blob/main/CHANGELOG.md", "Issues": f"{address}/issues"}
    text = PROJECT.read_text(encoding="utf-8")
    head = "[project.urls]\n"
    if text.count(head) != 1:
        raise SystemExit(f"{PROJECT}: expected one table [project.urls]")
    lines = "".join(f'{name} = "{link}"\n' for name, link in links.items())
    PROJECT.write_text(text.replace(head, head + lines), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1])
