"""Check that a project which takes the sources in compiles the library, nothing else of ours, by the same commands.

What it would link is then what is compiled already. Usage: same_commands.py BUILD BUILD_OF_THE_OTHER_PROJECT
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def commands(build: Path, inside: str = "") -> dict[str, str]:
    """Return the command of each file of the project, free of where `build` has it `inside`."""
    text = (build / "compile_commands.json").read_text().replace(str(build / inside), "BUILD")
    return {entry["file"].removeprefix(f"{ROOT}/"): entry["command"] for entry in json.loads(text)}


def main() -> None:
    """Compare both, and look for rules that would install the library into the other project's prefix."""
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
