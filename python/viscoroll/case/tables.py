"""Tables of TOML files, read as objects of this package (the extra `viscoroll[cli]`).

The keys of a table are the parameters of a class: pydantic finds those that are unknown or missing, and the place in
the file; the class itself checks values and has the defaults.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from enum import Enum
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias, TypeVar

from .._support.extras import extra
from .._support.keywords import meant as meant_by
from .._support.text import one_line, shown
from .._support.toml import read_toml

with extra("cli"):
    from pydantic import (
        BaseModel,
        BeforeValidator,
        ConfigDict,
        Field,
        GetCoreSchemaHandler,
        ValidationError,
        ValidationInfo,
        create_model,
        model_validator,
    )
    from pydantic_core import CoreSchema, ErrorDetails, core_schema

__all__ = [
    "ByName",
    "FileName",
    "FileTables",
    "StrictTable",
    "Table",
    "checked",
    "errors_in",
    "in_folder",
    "skipped_in",
]

_Model = TypeVar("_Model", bound="StrictTable")


class StrictTable(BaseModel):
    """A table of the file: unknown keys and wrong types are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


#: Tables that not every command reads, and which does.
_COMMANDS = {
    "rolling": "viscoroll solve",
    "thermal": "viscoroll solve",
    "motion": "viscoroll roll",
    "sweep": "viscoroll sweep",
    "design": "viscoroll design",
}


class FileTables(StrictTable):
    """Base of a whole file: tables of other commands are skipped, for one file may serve several."""

    @model_validator(mode="before")
    @classmethod
    def _own(cls, document: dict[str, Any]) -> dict[str, Any]:
        return {name: table for name, table in document.items() if name not in skipped(cls, document)}


def skipped(kind: type[FileTables], document: Iterable[str]) -> dict[str, str]:
    """Return the tables of a file that are of other commands, and of which."""
    return {name: _COMMANDS[name] for name in document if name in _COMMANDS and name not in kind.model_fields}


def skipped_in(path: Path, *, command: str) -> str:
    """Return which tables of a file are for other commands, in a sentence, or nothing."""
    others = {name: other for name, other in _COMMANDS.items() if other != command}
    with errors_in(path):
        document = read_toml(path)
    return "; ".join(f"[{name}] is for `{others[name]}`" for name in document if name in others)


class Table:
    """Mark of a class that a table of the file is read as, in ``Annotated[Drive, Table()]``.

    The keys are the parameters of the class, or of `make` in its place, of any type but where `types` says more; a
    table that is of one `kind` of several has the key `type`, too.
    """

    def __init__(self, kind: str | None = None, make: Callable[..., Any] | None = None, **types: Any) -> None:
        self._make = make
        self._types = types | ({} if kind is None else {"type": Literal[kind]})
        self._model: type[StrictTable] | None = None  # made once: modulus and layer are parts of several bodies

    def __get_pydantic_core_schema__(self, source: Callable[..., Any], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a model of the keys, and what is made of it."""
        make = self._make or source

        def made(table: StrictTable) -> Any:
            try:
                return make(**{name: getattr(table, name) for name in table.model_fields_set - {"type"}})
            except TypeError as error:  # of values: those of keys are found above
                raise ValueError(str(error)) from None

        self._model = self._model or self._model_of(make)
        return core_schema.no_info_after_validator_function(made, handler.generate_schema(self._model))

    def _model_of(self, make: Callable[..., Any]) -> type[StrictTable]:
        parameters = inspect.signature(make).parameters
        needed = {"type"} | {name for name, parameter in parameters.items() if parameter.default is parameter.empty}
        keys: dict[str, Any] = {
            name: (self._types.get(name, Any), Field() if name in needed else None)
            for name in [*parameters, *self._types]
        }
        return create_model(make.__name__, __base__=StrictTable, **keys)


class ByName:
    """Mark of an enumeration whose members, or some of them alone, the file names in lower case."""

    def __init__(self, *members: Enum) -> None:
        self._members = members

    def __get_pydantic_core_schema__(self, source: type[Enum], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the names, and how a member is found by them."""
        members = {member.name.lower(): member for member in self._members or source}
        return core_schema.no_info_after_validator_function(
            members.__getitem__, core_schema.literal_schema(list(members))
        )


def in_folder(name: object, info: ValidationInfo) -> Path:
    """Return the path of a named file in the folder of the file that names it; without a folder, refuse every name.

    All names of files pass through this function, so that tables without a folder cannot have any file read.
    """
    if info.context is None:
        raise ValueError("names of files are not allowed here: write the values into the table")
    if not isinstance(name, str):
        raise ValueError(f"file must be the name of a file, got {shown(name)}")
    assert isinstance(info.context, Path)
    return info.context / name


#: The name of a file beside the case file.
FileName: TypeAlias = Annotated[Path, BeforeValidator(in_folder)]


@contextmanager
def errors_in(path: Path) -> Iterator[None]:
    """Turn an error about the content of a file into a ValueError of one line that names the file."""
    try:
        yield
    except RecursionError:
        raise ValueError(one_line(f"{path}: nested too deeply")) from None
    except (TypeError, ValueError) as error:
        raise ValueError(one_line(f"{path}: {error}")) from None


def checked(kind: type[_Model], document: dict[str, Any], folder: Path | None = None) -> _Model:
    """Return the tables of a file whose `kind` says what they may hold; `folder` holds the files that they name.

    Without a folder, tables that name a file are refused, and no file is read.

    Raises
    ------
    ValueError
        Where they hold something else, with the place in the file.
    """
    try:
        return kind.model_validate(document, context=folder)
    except ValidationError as error:
        others = skipped(kind, document) if issubclass(kind, FileTables) else {}
        raise ValueError(_first_line(error, others, kind.model_fields)) from None


#: What Python makes by a call, as a file has it.
_IN_FILES = {
    "hardness_to_modulus(...).value": '{ type = "hardness", hardness = ... }',
    "rebound_to_loss_factor(...).value": '..., or a rebound beside a hardness: type = "hardness"',
}

#: Errors beside the first that are told one by one.
_MOST_TOLD = 3


def _first_line(error: ValidationError, others: Mapping[str, str], tables: Iterable[str]) -> str:
    """Return what is wrong first, with its place in the file, and what else; `others` are tables of other commands."""
    # Values are looked at where all keys of a table are known: the keys of others come first.
    errors = sorted(error.errors(), key=lambda one: one["type"] == "value_error")
    if others and (whole := [one for one in errors if one["type"] == "missing" and len(one["loc"]) == 1]):
        return f"{_told(whole[0])}; such a file is for `{next(iter(others.values()))}`"
    missing = [str(one["loc"][-1]) for one in errors if one["type"] == "missing"]
    unknown = [number for number, one in enumerate(errors) if one["type"] == "extra_forbidden"]
    meant = {}
    for number in unknown:
        *above, name = errors[number]["loc"]
        # A key that is misspelled, or another word for it, is missing as well; tables need not be there.
        if match := meant_by(str(name), missing if above else list(tables)):
            parameter, equals, formula = match.partition(" = ")
            meant[number] = parameter + equals + _IN_FILES.get(formula, formula)
    incomplete = [one["loc"][:-1] for one in errors if one["type"] == "missing" and len(one["loc"]) > 1]
    instead = [number for number in unknown if errors[number]["loc"][:-1] in incomplete]
    chosen = next(iter([*meant, *instead]), 0)
    told = _told(errors[chosen])
    if chosen in meant:
        told += f"; did you mean {meant[chosen]}?"
    named = meant.get(chosen, "").partition(" = ")[0]
    more = [
        _told(one, with_value=False)
        for number, one in enumerate(errors)
        if number != chosen and not (one["type"] == "missing" and one["loc"][-1] == named)
    ]
    if len(more) > _MOST_TOLD:
        return f"{told} (and {len(more)} more)"
    varied = ["; what [sweep] gives is for `viscoroll sweep`"] if set(missing) - {named} and "sweep" in others else []
    return "; ".join([told, *more]) + "".join(varied)


#: Tables of a type, which stands behind their names in the places of pydantic.
_TYPED = ("shear_modulus", "shift", "matrix", "network")

#: What is wrong with a key of such a table.
_WRONG_KEYS = {"missing": "must have", "extra_forbidden": "has no parameter"}


def _told(error: ErrorDetails, *, with_value: bool = True) -> str:
    *above, key = [part for before, part in pairwise(("", *error["loc"])) if before not in _TYPED]
    kind = next((part for before, part in reversed([*pairwise(error["loc"])]) if before in _TYPED), None)
    got = f", got {shown(error['input'])}" if with_value and error["type"] != "missing" else ""
    if kind is not None and error["type"] in _WRONG_KEYS:
        return f"{_place(above)} of type {kind} {_WRONG_KEYS[error['type']]} {key}{got}"
    place, context = _place([*above, key]), error.get("ctx", {})
    if error["type"] == "union_tag_invalid":
        kinds = context["expected_tags"].replace("'", "")
        return f"{place}.type must be one of {kinds}, got {shown(error['input']['type'])}"
    if error["type"] == "value_error":  # says by itself what it got
        return f"{place}: {context['error']}"
    return f"{place}: {error['msg'][0].lower()}{error['msg'][1:]}{got}"


def _place(parts: Sequence[str | int]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in parts).lstrip(".")
