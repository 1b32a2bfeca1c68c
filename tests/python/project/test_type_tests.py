"""Only the folders that define bodies and moduli test for their types; other code uses their properties."""

from __future__ import annotations

import ast
import typing
from pathlib import Path

import pytest
import viscoroll as vr
from viscoroll import bodies, materials

PACKAGE = Path(vr.__file__).parent

#: Folders that may test for the type of a body or a modulus.
DEFINING = ("bodies", "materials")


def _is_modulus(value: object) -> bool:
    return isinstance(value, type) and issubclass(value, vr.materials.ShearModulus)


#: Names of all types of bodies and moduli, of their base classes, and of the unions of them.
NAMES = {
    "LayeredBody",
    "RoundBody",
    "RollingBody",
    "Counterbody",
    "ShearModulus",
    *(kind.__name__ for kind in typing.get_args(bodies.Counterbody)),
    *(name for name in materials.__all__ if _is_modulus(getattr(materials, name))),
}

PATHS = sorted(
    path.relative_to(PACKAGE) for path in PACKAGE.rglob("*.py") if path.relative_to(PACKAGE).parts[0] not in DEFINING
)


def type_tests(source):
    """Return the types of bodies and moduli for which a source tests by isinstance or by a class pattern."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "isinstance":
            tested = node.args[1]
        elif isinstance(node, ast.MatchClass):
            tested = node.cls
        else:
            continue
        names = {part.id if isinstance(part, ast.Name) else getattr(part, "attr", "") for part in ast.walk(tested)}
        found += sorted(names & NAMES)
    return found


@pytest.mark.parametrize("path", PATHS, ids=str)
def test_no_type_of_body_or_modulus_is_tested(path):
    assert not type_tests((PACKAGE / path).read_text(encoding="utf-8"))


def test_a_type_test_is_found():
    assert type_tests("isinstance(body, CoatedWheel | None)") == ["CoatedWheel"]
    assert type_tests("match modulus:\n    case vr.Prony(weights=w): ...") == ["Prony"]
    assert not type_tests("isinstance(value, float)")
