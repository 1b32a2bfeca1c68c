"""Check that a project which includes the sources compiles the library, and nothing else, with the same commands.

Then the installed library is what such a project would link. Usage: same_commands.py BUILD BUILD_OF_THE_OTHER_PROJECT
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def commands(build: Path, inside: str = "") -> dict[str, str]:
    """Return the compile command of each file of the project, without the path of `build` and `inside`."""
    text = (build / "compile_commands.json").read_text().replace(str(build / inside), "BUILD")
    return {entry["file"].removeprefix(f"{ROOT}/"): entry["command"] for entry in json.loads(text)}


def main() -> None:
    """Compare both, and check that no rule installs the library with the other project."""
    own, other = (Path(argument).resolve() for argument in sys.argv[1:])
    library = {file: command for file, command in commands(own).items() if "/viscoroll.dir/" in command}
    taken_in = commands(other, "viscoroll")
    del taken_in["tests/package/main.cpp"]
    for file in sorted(library.keys() | taken_in.keys()):
        if library.get(file) != taken_in.get(file):
            sys.exit(f"{file} is compiled differently:\n  {library.get(file)}\n  {taken_in.get(file)}")
    if "file(INSTALL" in (other / "viscoroll" / "cpp" / "cmake_install.cmake").read_text():
        sys.exit("the library is installed with the project that takes it in")


if __name__ == "__main__":
    main()
