"""Tables of TOML files, read as objects of this package (the extra `viscoroll[cli]`).

The keys of a table are the parameters of a class. Pydantic reports unknown and missing keys with their path in the
file; the class itself checks the values and has the defaults.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from enum import Enum
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Self, TypeAlias, TypeVar

from .._support.errors import InvalidInput, in_file
from .._support.extras import extra
from .._support.suggestions import suggestion
from .._support.text import key_path_text, one_line, shown
from .._support.toml import read_toml
from ..bodies import Layer
from .descriptions import parameter_schemas
from .unit_texts import FileKeys, has_quantities

with extra("cli"):
    from pydantic import (
        BaseModel,
        BeforeValidator,
        ConfigDict,
        Field,
        GetCoreSchemaHandler,
        GetJsonSchemaHandler,
        ModelWrapValidatorHandler,
        ValidationError,
        ValidationInfo,
        create_model,
        model_validator,
    )
    from pydantic_core import CoreSchema, ErrorDetails, InitErrorDetails, core_schema

__all__ = [
    "AlsoAs",
    "ByName",
    "ColumnsOf",
    "FileName",
    "FileTables",
    "StrictTable",
    "Table",
    "checked",
    "errors_in",
    "in_folder",
    "problems",
    "skipped_in",
]

_Model = TypeVar("_Model", bound="StrictTable")


class StrictTable(BaseModel):
    """Base of a table of the file: unknown keys and wrong types are errors."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)

    #: Classes and functions whose docstrings describe the keys.
    documented_by: ClassVar[tuple[Callable[..., Any], ...]] = ()

    #: Groups of keys of which the table must have one; the code that uses the table rejects several. Messages about a
    #: missing key name the first one of its group.
    one_of: ClassVar[tuple[tuple[str, ...], ...]] = ()

    @model_validator(mode="wrap")
    @classmethod
    def _has_one(cls, table: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        """Report missing keys of `one_of` as pydantic reports any other missing key, together with all errors."""
        groups = [group for group in cls.one_of if isinstance(table, dict) and table.keys().isdisjoint(group)]
        if not groups:
            return handler(table)
        missing = [InitErrorDetails(type="missing", loc=(group[0],), input=table) for group in groups]
        try:
            handler(table)
        except ValidationError as error:
            others = [
                InitErrorDetails(type=one["type"], loc=one["loc"], input=one["input"], ctx=one.get("ctx", {}))
                for one in error.errors()
            ]
            raise ValidationError.from_exception_data(cls.__name__, [*missing, *others]) from None
        raise ValidationError.from_exception_data(cls.__name__, missing)

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Return the JSON Schema with descriptions and ranges from the docstrings."""
        made = handler(schema)
        if cls.one_of:
            groups = [{"oneOf": [{"required": [name]} for name in group]} for group in cls.one_of]
            handler.resolve_ref_schema(made)["allOf"] = groups
        keys = handler.resolve_ref_schema(made).get("properties", {})
        for name in keys:  # a missing value is None in Python, but not in a file
            kinds = [kind for kind in keys[name].get("anyOf", []) if kind != {"type": "null"}]
            if keys[name].get("default", 0) is None:
                del keys[name]["default"]
            if name in cls.model_fields and isinstance(member := cls.model_fields[name].default, Enum):
                keys[name]["default"] = member.name.lower()  # pydantic gives the number of the member
            if kinds:
                keys[name]["anyOf"] = kinds
            if len(kinds) == 1:
                keys[name] = {k: v for k, v in keys[name].items() if k != "anyOf"} | kinds[0]
        sources: tuple[Callable[..., Any], ...] = (*cls.documented_by, cls)
        for make in sources:
            for name, found in parameter_schemas(make).items():
                if name in keys:
                    keys[name] = found | keys[name]
        for name in [name for name in keys if not _takes_numbers(keys[name])]:
            keys[name].pop("unit", None)
        return made


def _takes_numbers(schema: dict[str, Any]) -> bool:
    """Return whether JSON Schema of a key allows a number or a list of numbers."""
    kinds = [schema, *schema.get("anyOf", []), *schema.get("oneOf", [])]
    return any(kind.get("type") == "number" or kind.get("items", {}).get("type") == "number" for kind in kinds)


#: Tables that only some commands read, and these commands; messages name the first one.
_COMMANDS = {
    "rolling": ("solve", "sweep", "design", "compare", "export", "report", "impact"),
    "thermal": ("solve", "sweep", "design", "report"),
    "motion": ("roll",),
    "ground": ("roll",),
    "tread": ("roll",),
    "axle": ("roll",),
    "surface": ("slide", "sweep"),
    "sliding": ("slide", "sweep"),
    "sweep": ("sweep", "export"),
    "draws": ("sweep",),
    "design": ("design", "report"),
}


#: Texts for tables of which a command reads a part.
_PARTLY = {
    ("roll", "rolling"): "[rolling] is for `viscoroll solve`, except the load if [motion] has none",
}


class FileTables(StrictTable):
    """Base of a whole file. Tables for other commands are skipped, because several commands can read the same file."""

    @classmethod
    def keys_of(cls, document: Mapping[str, Any]) -> FileKeys:
        """Return the keys of a file, which texts with units need."""
        return FileKeys(_schema_of(cls), line_contact=cls.is_of_roller(document))

    @classmethod
    def is_of_roller(cls, document: Mapping[str, Any]) -> bool:  # noqa: ARG003
        """Return whether forces of the file are per length."""
        return False

    @model_validator(mode="before")
    @classmethod
    def _own(cls, document: dict[str, Any]) -> dict[str, Any]:
        return {name: table for name, table in document.items() if name not in skipped(cls, document)}


@cache
def _schema_of(kind: type[FileTables]) -> dict[str, Any]:
    return kind.model_json_schema()


def skipped(kind: type[FileTables], document: Iterable[str]) -> dict[str, str]:
    """Return the names of the tables that are for other commands, with these commands."""
    return {
        name: f"viscoroll {_COMMANDS[name][0]}"
        for name in document
        if name in _COMMANDS and name not in kind.model_fields
    }


def skipped_in(path: Path, *, command: str) -> str:
    """Return a text that lists the tables of a file that a command such as "solve" does not use, or an empty text."""
    with errors_in(path):
        document = read_toml(path)
    others = {name: readers[0] for name, readers in _COMMANDS.items() if command not in readers}
    return "; ".join(
        _PARTLY.get((command, name), f"[{name}] is for `viscoroll {others[name]}`")
        for name in document
        if name in others
    )


class Table:
    """Annotation of a class that is made from a table of the file, for example ``Annotated[Drive, Table()]``.

    The keys of the table are the parameters of the class.

    Parameters
    ----------
    kind : str, optional
        Value of the key `type`, for tables that describe one of several classes.
    make : callable, optional
        Function that makes the object instead of the class; its parameters are the keys.
    documented_by : class or function, optional
        Another class, or a function, whose docstring describes the same keys.
    **types : type
        Types of keys. Other keys may have any type.
    """

    def __init__(
        self,
        kind: str | None = None,
        make: Callable[..., Any] | None = None,
        *,
        documented_by: Callable[..., Any] | None = None,
        **types: Any,
    ) -> None:
        self._make = make
        self._documented_by = documented_by
        self._types = types | ({} if kind is None else {"type": Literal[kind]})
        self._model: type[StrictTable] | None = None  # made once: several bodies contain moduli and layers

    def __get_pydantic_core_schema__(self, source: Callable[..., Any], handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a schema that checks the keys and makes the object."""
        make = self._make or source

        def made(table: StrictTable) -> Any:
            return make(**{name: getattr(table, name) for name in table.model_fields_set - {"type"}})

        self._model = self._model or self._model_of(make)
        return core_schema.no_info_after_validator_function(made, handler.generate_schema(self._model))

    def _model_of(self, make: Callable[..., Any]) -> type[StrictTable]:
        parameters = inspect.signature(make).parameters
        needed = {"type"} | {name for name, parameter in parameters.items() if parameter.default is parameter.empty}
        keys: dict[str, Any] = {
            name: (self._types.get(name, Any), Field() if name in needed else None)
            for name in [*parameters, *self._types]
        }
        model: type[StrictTable] = create_model(make.__name__.removeprefix("_"), __base__=StrictTable, **keys)
        model.documented_by = (make,) if self._documented_by is None else (self._documented_by,)
        return model


class AlsoAs:
    """Annotation of a table for which the file may also give a value of another type of JSON, as an abbreviation."""

    def __init__(self, *types: str) -> None:
        self._types = types

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Return the JSON Schema of the table or of an abbreviation."""
        return {"anyOf": [*({"type": kind} for kind in self._types), handler(schema)]}


class ColumnsOf:
    """Annotation of a table whose key `file` may replace some keys, which are then columns of the file.

    Parameters
    ----------
    replace : callable
        Function of a table and of the validation info that replaces the file by its columns.
    names : tuple of str
        Keys that the file replaces.
    """

    def __init__(self, replace: Callable[[Any, ValidationInfo], Any], names: tuple[str, ...]) -> None:
        self._replace = replace
        self._names = names

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a schema that replaces the file before the table is checked."""
        return core_schema.with_info_before_validator_function(self._replace, handler(source))

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Return the JSON Schema, in which either the file or all columns are required."""
        made = handler(schema)
        table = handler.resolve_ref_schema(made)
        table["properties"] |= {"file": {"type": "string", "description": "CSV file with the columns."}}
        table["required"] = [name for name in table["required"] if name not in self._names]
        table["oneOf"] = [{"required": ["file"]}, {"required": list(self._names)}]
        return made


class ByName:
    """Annotation of an enumeration: the file gives the name of a member in lower case; `members` limits the choice."""

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
        raise InvalidInput("file", "must be left out here: write the values into the table")
    if not isinstance(name, str):
        raise InvalidInput("file", "must be the name of a file", shown(name))
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
        raise in_file(error, path) from None


def checked(kind: type[_Model], document: dict[str, Any], folder: Path | None = None) -> _Model:
    """Return the tables of a file as an object of `kind`, which defines the allowed content.

    Texts such as "10 mm" become numbers in SI units.

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
    InvalidInput
        If the tables have other content.
    """
    if issubclass(kind, FileTables) and has_quantities(document):
        document = kind.keys_of(document).in_si(document)
    try:
        return kind.model_validate(document, context=folder)
    except ValidationError as error:
        others = skipped(kind, document) if issubclass(kind, FileTables) else {}
        raise _first_error(error, others, kind.model_fields) from None


def problems(kind: type[FileTables], document: dict[str, Any], folder: Path | None) -> list[InvalidInput]:
    """Return all errors of tables that can be found without making the bodies; parameters as in `checked`."""
    found: list[InvalidInput] = []
    if has_quantities(document):
        document, found = kind.keys_of(document).converted(document)
    try:
        kind.model_validate(document, context=folder)
    except ValidationError as error:
        keys = kind.keys_of(document)
        places = tuple(one.parameter for one in found)
        for one in error.errors():
            more = _elsewhere(one["loc"]) if one["type"] == "extra_forbidden" else ""
            if one["type"] == "extra_forbidden" and not more and (meant := keys.meant(document, one["loc"])):
                more = f"did you mean {meant}?"
            invalid = _invalid(one, more=more)
            if not any(place.startswith(invalid.parameter) for place in places):
                found.append(invalid)
    return found


#: Python calls that messages suggest, and their form in a file.
_IN_FILES = {
    "hardness_to_modulus(...).value": '{ type = "hardness", hardness = ... }',
    "rebound_to_loss_factor(...).value": '..., or give a rebound with a hardness: type = "hardness"',
}

#: Largest number of further errors that a message lists.
_MAX_LISTED = 3


def _first_error(error: ValidationError, others: Mapping[str, str], tables: Iterable[str]) -> InvalidInput:
    """Return the most relevant error; its message also lists the others.

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
        return _invalid(whole[0], more=f"this file is for `{next(iter(others.values()))}`")
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
    named = meant.get(chosen, "").partition(" = ")[0]
    elsewhere = _elsewhere(errors[chosen]["loc"]) if chosen in unknown else ""
    more = [elsewhere] if elsewhere else [f"did you mean {meant[chosen]}?"] if chosen in meant else []
    rest = [
        str(_invalid(one, with_value=False))
        for number, one in enumerate(errors)
        if number != chosen and not (one["type"] == "missing" and one["loc"][-1] == named)
    ]
    more += rest if len(rest) <= _MAX_LISTED else [f"and {len(rest)} more errors"]
    if set(missing) - {named} and "sweep" in others and len(rest) <= _MAX_LISTED:
        more.append("only `viscoroll sweep` uses the values of [sweep]")
    return _invalid(errors[chosen], more="; ".join(more))


#: Tables of bodies whose layers are tables of their own.
_WITH_LAYERS = ("ball", "cylinder", "wheel", "other_ball", "other_cylinder", "other_wheel", "plane")


def _elsewhere(location: tuple[str | int, ...]) -> str:
    """Return what to do with a key that a body does not have, or an empty text for any other key."""
    if len(location) != 2:
        return ""
    body, key = map(str, location)
    if key == "width" and body in ("cylinder", "other_cylinder"):
        return "loads, forces and torques of rollers are per length: multiply them by the width"
    return f"did you mean {body}.layers[0].{key}?" if body in _WITH_LAYERS and key in Layer.__dataclass_fields__ else ""


#: Names of types that pydantic appends to the location of a key that may have one of several types.
_ALTERNATIVES = ("float", "list[float]")

#: Tables with a key `type`. Pydantic adds its value to the location, after the name of the table.
_TYPED = ("shear_modulus", "shift", "matrix", "network", "ground", "tread")


def _invalid(error: ErrorDetails, *, with_value: bool = True, more: str = "") -> InvalidInput:
    """Return an error of pydantic as an error of a parameter."""
    parts = pairwise(("", *error["loc"]))
    path = key_path_text([part for before, part in parts if before not in _TYPED and part not in _ALTERNATIVES])
    kind = next((part for before, part in reversed([*pairwise(error["loc"])]) if before in _TYPED), None)
    context, message = error.get("ctx", {}), error["msg"]
    value = shown(error["input"]) if with_value else ""
    if error["type"] == "value_error":
        found = context["error"]
        if isinstance(found, InvalidInput):
            return found.inside(path).with_more(more)
        return InvalidInput(path, f"is invalid: {found}", more=more)
    if error["type"] == "missing":
        return InvalidInput(path, "must be given" + (f" for the type {kind}" if kind else ""), more=more)
    if error["type"] == "extra_forbidden":
        return InvalidInput(path, "is not a parameter" + (f" of the type {kind}" if kind else ""), value, more=more)
    if error["type"] == "union_tag_invalid":
        kinds = context["expected_tags"].replace("'", "")
        return InvalidInput(f"{path}.type", f"must be one of {kinds}", shown(error["input"]["type"]), more=more)
    wanted = message.removeprefix("Input should be ")
    rule = f"must be {wanted}" if wanted != message else f"is invalid: {message[0].lower()}{message[1:]}"
    return InvalidInput(path, rule, value, more=more)
