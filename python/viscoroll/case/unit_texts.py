"""Conversion of texts such as "10 mm" in tables of case files, with the unit that the JSON Schema gives each key."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from .._support.errors import InvalidInput
from .._support.suggestions import suggestion
from .._support.text import key_path_text
from .._support.units import unit_in_contact
from .quantities import as_quantity, in_si

__all__ = ["FileKeys", "Key", "has_quantities"]

#: Largest number of further errors that a message lists.
_MAX_LISTED = 3

#: Characters with which a number may start.
_STARTS = tuple("0123456789.+-\N{MINUS SIGN}")


@dataclass(frozen=True, slots=True)
class Key:
    """A key of a file that takes numbers.

    Attributes
    ----------
    unit : str
        SI unit, "1" for numbers without unit.
    difference : bool
        Whether a value in K is a difference of temperatures.
    """

    unit: str
    difference: bool = False

    def number(self, text: str, path: str) -> float:
        """Return the number in SI units that a text states; the path is that of the key, for messages."""
        return in_si(text, self.unit, path=path, difference=self.difference)


def has_quantities(content: object) -> bool:
    """Return whether any text of tables and lists starts like a number, so that it may be a number with a unit."""
    if isinstance(content, str):
        return content.lstrip().startswith(_STARTS)
    if isinstance(content, dict):
        return any(map(has_quantities, content.values()))
    return isinstance(content, list) and any(map(has_quantities, content))


@dataclass(frozen=True, slots=True)
class FileKeys:
    """Keys of a file, as its JSON Schema describes them.

    Attributes
    ----------
    schema : mapping
        JSON Schema of the file.
    line_contact : bool
        Whether the rolling body of the file is a roller, whose forces are per length.
    """

    schema: Mapping[str, Any]
    line_contact: bool

    def in_si(self, document: Mapping[str, Any]) -> Any:
        """Return the tables of a file in which numbers in SI units replace texts with units.

        Raises
        ------
        InvalidInput
            If a text is not a number with a unit of the right dimension. The message also lists other such texts.
        """
        found, errors = self.converted(document)
        if not errors:
            return found
        listed = [f"{error.parameter} {error.rule}" for error in errors[1:]]
        raise errors[0].with_more("; ".join(listed) if len(listed) <= _MAX_LISTED else f"and {len(listed)} more errors")

    def converted(self, document: Mapping[str, Any]) -> tuple[Any, list[InvalidInput]]:
        """Return the tables of a file with numbers in place of texts, and the errors of texts that remain."""
        errors: list[InvalidInput] = []
        return self._converted(document, self.schema, (), errors), errors

    def at(self, document: Mapping[str, Any], path: Sequence[str | int]) -> Key | None:
        """Return the key at a path of the file, or None if there is no such key or its values are not numbers."""
        node: Mapping[str, Any] | None = self.schema
        value: Any = document
        for part in path:
            node = None if node is None else self.child(node, value, part)
            if isinstance(part, int):
                value = value[part] if isinstance(value, list) and part < len(value) else {}
            else:
                value = value.get(part, {}) if isinstance(value, dict) else {}
        return None if node is None else self._key(node)

    def _converted(
        self, value: Any, node: Mapping[str, Any] | None, path: tuple[str | int, ...], errors: list[InvalidInput]
    ) -> Any:
        if node is None:
            return value
        if isinstance(value, dict):
            return {
                name: self._converted(v, self.child(node, value, name), (*path, name), errors)
                for name, v in value.items()
            }
        if isinstance(value, list):
            return [self._converted(v, self.child(node, value, i), (*path, i), errors) for i, v in enumerate(value)]
        if not isinstance(value, str) or (key := self._key(node)) is None:
            return value
        is_number = as_quantity(value) is not None or (has_quantities(value) and not self._takes_texts(node))
        if not is_number:
            return value
        try:
            return key.number(value, key_path_text(path))
        except InvalidInput as error:
            errors.append(error)
            return value

    def _takes_texts(self, node: Mapping[str, Any]) -> bool:
        """Return whether a key also takes texts of another meaning, such as names of files."""
        return any(kind.get("type") == "string" or "enum" in kind for kind in self._kinds(node))

    def _key(self, node: Mapping[str, Any]) -> Key | None:
        if not any(kind.get("type") == "number" for kind in self._kinds(node)):
            return None
        unit = unit_in_contact(node.get("unit", "1"), line_contact=self.line_contact)
        return Key(unit, difference=unit == "K" and "difference" in node.get("description", ""))

    def child(self, node: Mapping[str, Any], value: Any, part: str | int) -> Mapping[str, Any] | None:
        """Return the schema of a key of a table, or of an entry of a list, which has the unit of the list.

        Parameters
        ----------
        node : mapping
            Schema of the table or list.
        value : object
            The table or list, whose key `type` may decide between several schemas.
        part : str or int
            Key or index.
        """
        if isinstance(part, int):
            items = next((kind["items"] for kind in self._kinds(node) if "items" in kind), None)
            return None if items is None else {**{k: node[k] for k in ("unit", "description") if k in node}, **items}
        return self.properties(node, value).get(part)

    def properties(self, node: Mapping[str, Any], value: Any) -> dict[str, Mapping[str, Any]]:
        """Return the schemas of the keys of a table; parameters as in `child`."""
        tables = [kind["properties"] for kind in self._kinds(node) if "properties" in kind]
        keys = value if isinstance(value, dict) else {}
        typed = [table for table in tables if table.get("type", {}).get("const", 0) == keys.get("type")]
        fitting = [table for table in tables if keys.keys() <= table.keys()]
        return dict(next(iter((*typed, *fitting, *tables)), {}))

    def meant(self, document: Mapping[str, Any], path: Sequence[str | int]) -> str:
        """Return a suggestion for an unknown key: a similar one of its table, or the same one of another table."""
        node: Mapping[str, Any] | None = self.schema
        value: Any = document
        for part in path[:-1]:
            node = None if node is None else self.child(node, value, part)
            value = value[part]
        name = str(path[-1])
        if node is not None and (similar := suggestion(name, self.properties(node, value))):
            return similar
        if name in self.schema["properties"]:
            return f"{name}, at the beginning of the file"
        tables = [table for table in document if name in self.properties(self.schema["properties"].get(table, {}), {})]
        return f"{tables[0]}.{name}" if len(path) == 1 and tables else ""

    def kinds_text(self, node: Mapping[str, Any]) -> str:
        """Return the values of the key `type` that a table may have, for a comment."""
        tables = [kind["properties"] for kind in self._kinds(node) if "type" in kind.get("properties", {})]
        return ", ".join(dict.fromkeys(table["type"]["const"] for table in tables))

    def holds_tables(self, node: Mapping[str, Any]) -> bool:
        """Return whether the value of a key is a table, or a list of tables."""
        kinds = [*self._kinds(node)]
        entries = [entry for kind in kinds if "items" in kind for entry in self._kinds(kind["items"])]
        return any("properties" in kind for kind in (*kinds, *entries))

    def _kinds(self, node: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
        """Yield the alternatives of a schema, without references."""
        if "$ref" in node:
            yield from self._kinds(self.schema["$defs"][node["$ref"].rpartition("/")[2]])
        yield node
        for kind in (*node.get("anyOf", ()), *node.get("oneOf", ())):
            yield from self._kinds(kind)
