"""Writes lares/answers.py from the schemas of server/api/operations.json.

    python3 make_types.py OPERATIONS_JSON > lares/answers.py
"""

import json
import keyword
import sys
from typing import Any, Dict, List, Tuple

SCALARS = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}

HEAD = '''"""What the server answers, as typed dictionaries.

Written by tools/make_types.py from server/api/operations.json: change that, then run it again.
"""

from typing import Any, Dict, List, Optional, TypedDict, Union

'''


def type_of(schema: Dict[str, Any]) -> str:
    """The Python type of a schema, as an expression."""
    if "$ref" in schema:
        return '"' + str(schema["$ref"]).rsplit("/", 1)[-1] + '"'
    for several in ("anyOf", "oneOf"):
        if several in schema:
            return union([type_of(one) for one in schema[several]])
    kind = schema.get("type")
    if isinstance(kind, list):
        return union([type_of({**schema, "type": one}) for one in kind])
    if kind == "array":
        return f"List[{type_of(schema.get('items', {}))}]"
    if kind == "object":
        more = schema.get("additionalProperties")
        return f"Dict[str, {type_of(more)}]" if isinstance(more, dict) else "Dict[str, Any]"
    return SCALARS.get(str(kind), "Any")


def union(types: List[str]) -> str:
    unique = sorted(set(types) - {"None"}, key=types.index)
    inner = unique[0] if len(unique) == 1 else f"Union[{', '.join(unique)}]"
    return f"Optional[{inner}]" if "None" in types else inner


def parts_of(schema: Dict[str, Any]) -> Tuple[List[str], Dict[str, Any], List[str]]:
    """The bases, properties and required names of an object's schema."""
    bases: List[str] = []
    properties = dict(schema.get("properties", {}))
    required = list(schema.get("required", []))
    for part in schema.get("allOf", []):
        if "$ref" in part:
            bases.append(part["$ref"].rsplit("/", 1)[-1])
        else:
            properties.update(part.get("properties", {}))
            required += part.get("required", [])
    return bases, properties, required


def as_class(name: str, bases: List[str], fields: Dict[str, Any], total: bool) -> str:
    """One TypedDict; names that are no Python names need the other way to write it."""
    if any(keyword.iskeyword(field) for field in fields):
        text = f"{name} = TypedDict(\n    \"{name}\",\n    {{\n"
        for field, schema in fields.items():
            text += f'        "{field}": {type_of(schema)},\n'
        return text + "    },\n" + ("" if total else "    total=False,\n") + ")\n"
    head = ", ".join(bases or ["TypedDict"]) + ("" if total else ", total=False")
    text = f"class {name}({head}):\n"
    for field, schema in fields.items():
        text += f"    {field}: {type_of(schema)}\n"
    return text + ("" if fields else "    pass\n")


def declare(name: str, schema: Dict[str, Any]) -> str:
    """A schema as one class, or as two: what is always there, and what may be missing."""
    bases, properties, required = parts_of(schema)
    always = {field: one for field, one in properties.items() if field in required}
    maybe = {field: one for field, one in properties.items() if field not in required}
    if any(keyword.iskeyword(field) for field in properties):
        return as_class(name, [], properties, total=False)
    if not always:
        return as_class(name, bases, maybe, total=False)
    if not maybe:
        return as_class(name, bases, always, total=True)
    first = as_class(f"_{name}Always", bases, always, total=True)
    return first + "\n\n" + as_class(name, [f"_{name}Always"], maybe, total=False)


def write_types(operations: Dict[str, Any]) -> str:
    schemas = operations["components"]["schemas"]
    done: List[str] = []
    waiting = list(schemas)
    while waiting:  # a base stands before what is made of it
        name = next(one for one in waiting if set(parts_of(schemas[one])[0]) <= set(done))
        waiting.remove(name)
        done.append(name)
    return HEAD + "\n" + "\n\n".join(declare(name, schemas[name]) for name in done)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.write(write_types(json.load(file)))
