"""Tables of TOML files, read as objects of this package (the extra `viscoroll[cli]`).

The keys of a table are the parameters of a class. Pydantic reports unknown and missing keys with their place in the
file; the class itself checks the values and has the defaults.
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
from .._support.suggestions import suggestion
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
    """Base of a table of the file: unknown keys and wrong types are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


#: Tables that only some commands read, and the command to name in messages.
_COMMANDS = {
    "rolling": "viscoroll solve",
    "thermal": "viscoroll solve",
    "motion": "viscoroll roll",
    "sweep": "viscoroll sweep",
    "design": "viscoroll design",
}


class FileTables(StrictTable):
    """Base of a whole file. Tables for other commands are skipped, because several commands can read the same file."""

    @model_validator(mode="before")
    @classmethod
    def _own(cls, document: dict[str, Any]) -> dict[str, Any]:
        return {name: table for name, table in document.items() if name not in skipped(cls, document)}


def skipped(kind: type[FileTables], document: Iterable[str]) -> dict[str, str]:
    """Return the names of the tables that are for other commands, with these commands."""
    return {name: _COMMANDS[name] for name in document if name in _COMMANDS and name not in kind.model_fields}


def skipped_in(path: Path, *, command: str) -> str:
    """Return a text that lists the tables of a file for other commands; empty if there are none."""
    others = {name: other for name, other in _COMMANDS.items() if other != command}
    with errors_in(path):
        document = read_toml(path)
    return "; ".join(f"[{name}] is for `{others[name]}`" for name in document if name in others)


class Table:
    """Annotation of a class that is made from a table of the file, for example ``Annotated[Drive, Table()]``.

    The keys of the table are the parameters of the class.

    Parameters
    ----------
    kind : str, optional
        Value of the key `type`, for tables that describe one of several classes.
    make : callable, optional
        Function that makes the object instead of the class; its parameters are the keys.
    **types : type
        Types of keys. Other keys may have any type.
    """

    def __init__(self, kind: str | None = None, make: Callable[..., Any] | None = None, **types: Any) -> None:
        self._make = make
        self._types = types | ({} if kind is None else {"type": Literal[kind]})
        self._model: type[StrictTable] | None = None  # made once: several bodies contain moduli and layers

    def __get_pydantic_core_schema__(self, source: Callable[..., Any], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a schema that checks the keys and makes the object."""
        make = self._make or source

        def made(table: StrictTable) -> Any:
            try:
                return make(**{name: getattr(table, name) for name in table.model_fields_set - {"type"}})
            except TypeError as error:  # wrong types of values; the model has checked the keys
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
    """Annotation of an enumeration: the file gives the name of a member, or of one of `members`, in lower case."""

    def __init__(self, *members: Enum) -> None:
        self._members = members

    def __get_pydantic_core_schema__(self, source: type[Enum], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a schema that checks the name and returns the member."""
        members = {member.name.lower(): member for member in self._members or source}
        return core_schema.no_info_after_validator_function(
            members.__getitem__, core_schema.literal_schema(list(members))
        )


def in_folder(name: object, info: ValidationInfo) -> Path:
    """Return the path of a file in the folder of the file that refers to it; without a folder, reject every name.

    All names of files pass through this function, so that tables without a folder cannot cause any file to be read.
    """
    if info.context is None:
        raise ValueError("names of files are not allowed here: write the values into the table")
    if not isinstance(name, str):
        raise ValueError(f"file must be the name of a file, got {shown(name)}")
    assert isinstance(info.context, Path)
    return info.context / name


#: Name of a file in the folder of the case file.
FileName: TypeAlias = Annotated[Path, BeforeValidator(in_folder)]


@contextmanager
def errors_in(path: Path) -> Iterator[None]:
    """Convert errors about the content of a file to a ValueError with a message of one line that names the file."""
    try:
        yield
    except RecursionError:
        raise ValueError(one_line(f"{path}: tables are nested too deeply")) from None
    except (TypeError, ValueError) as error:
        raise ValueError(one_line(f"{path}: {error}")) from None


def checked(kind: type[_Model], document: dict[str, Any], folder: Path | None = None) -> _Model:
    """Return the tables of a file as an object of `kind`, which defines the allowed content.

    Parameters
    ----------
    kind : type
        Class of the tables.
    document : dict
        Content of the file.
    folder : Path, optional
        Folder of the files to which the tables refer. Without a folder, no file is read, and tables that refer to a
        file are rejected.

    Raises
    ------
    ValueError
        If the tables have other content. The message names the place in the file.
    """
    try:
        return kind.model_validate(document, context=folder)
    except ValidationError as error:
        others = skipped(kind, document) if issubclass(kind, FileTables) else {}
        raise ValueError(_first_line(error, others, kind.model_fields)) from None


#: Python calls that messages suggest, and their form in a file.
_IN_FILES = {
    "hardness_to_modulus(...).value": '{ type = "hardness", hardness = ... }',
    "rebound_to_loss_factor(...).value": '..., or give a rebound with a hardness: type = "hardness"',
}

#: Largest number of further errors that a message lists.
_MAX_LISTED = 3


def _first_line(error: ValidationError, others: Mapping[str, str], tables: Iterable[str]) -> str:
    """Return a message with the most relevant error and its place, then the others.

    Parameters
    ----------
    error : ValidationError
        All errors of the file.
    others : mapping of str to str
        Tables of the file for other commands, with these commands.
    tables : iterable of str
        Names of all tables that the file may have.
    """
    # Values are checked only in tables without wrong keys: report the wrong keys of other tables first.
    errors = sorted(error.errors(), key=lambda one: one["type"] == "value_error")
    if others and (whole := [one for one in errors if one["type"] == "missing" and len(one["loc"]) == 1]):
        return f"{_told(whole[0])}; this file is for `{next(iter(others.values()))}`"
    missing = [str(one["loc"][-1]) for one in errors if one["type"] == "missing"]
    unknown = [number for number, one in enumerate(errors) if one["type"] == "extra_forbidden"]
    meant = {}
    for number in unknown:
        *above, name = errors[number]["loc"]
        # If a key is misspelled or a synonym, the correct key is among the missing ones. Tables may be optional.
        if match := suggestion(str(name), missing if above else list(tables)):
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
    if len(more) > _MAX_LISTED:
        return f"{told} (and {len(more)} more)"
    varied = (
        ["; only `viscoroll sweep` uses the values of [sweep]"] if set(missing) - {named} and "sweep" in others else []
    )
    return "; ".join([told, *more]) + "".join(varied)


#: Tables with a key `type`, whose value follows their name in the locations of pydantic.
_TYPED = ("shear_modulus", "shift", "matrix", "network")

#: Messages about keys of such tables, by the error type of pydantic.
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
    if error["type"] == "value_error":  # this message contains the given value
        return f"{place}: {context['error']}"
    return f"{place}: {error['msg'][0].lower()}{error['msg'][1:]}{got}"


def _place(parts: Sequence[str | int]) -> str:
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in parts).lstrip(".")
