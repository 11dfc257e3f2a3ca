"""The part of JSON Schema that `softwet explain --json-schema` uses; another word in a schema is an error."""

import datetime
import re

KNOWN = {"$schema", "title", "description", "type", "enum", "minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum",
         "pattern", "items", "minItems", "maxItems", "properties", "additionalProperties", "required", "anyOf"}
TYPES = {"object": dict, "array": list, "string": str, "number": (int, float), "integer": int}


def plain(value):
    """As validators of TOML see it: times and dates are texts."""
    if isinstance(value, dict):
        return {name: plain(entry) for name, entry in value.items()}
    if isinstance(value, list):
        return [plain(entry) for entry in value]
    return value.isoformat() if isinstance(value, (datetime.date, datetime.time)) else value


def has_type(value, name):
    if name in ("number", "integer") and isinstance(value, bool):
        return False
    return isinstance(value, TYPES[name]) or (name == "integer" and isinstance(value, float) and value.is_integer())


def faults(value, schema, place=""):
    """What is wrong with a value, a line each."""
    unknown = set(schema) - KNOWN
    if unknown:
        raise ValueError(f"the schema has {unknown} at {place}")
    found = []
    if "type" in schema and not has_type(value, schema["type"]):
        return [f"{place}: {value!r} is no {schema['type']}"]
    if "enum" in schema and value not in schema["enum"]:
        found.append(f"{place}: {value!r} is none of {schema['enum']}")
    for word, holds in (("minimum", lambda v, b: v >= b), ("maximum", lambda v, b: v <= b),
                        ("exclusiveMinimum", lambda v, b: v > b), ("exclusiveMaximum", lambda v, b: v < b)):
        if word in schema and not holds(value, schema[word]):
            found.append(f"{place}: {value!r} breaks {word} {schema[word]}")
    if "pattern" in schema and not re.search(schema["pattern"], value):
        found.append(f"{place}: {value!r} does not look like {schema['pattern']}")
    if "anyOf" in schema and all(faults(value, one, place) for one in schema["anyOf"]):
        found.append(f"{place}: {value!r} is nothing of what may stand there")
    if isinstance(value, list):
        found += list_faults(value, schema, place)
    if isinstance(value, dict):
        found += table_faults(value, schema, place)
    return found


def list_faults(value, schema, place):
    found = []
    if not schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)):
        found.append(f"{place}: {len(value)} entries")
    for number, entry in enumerate(value):
        found += faults(entry, schema.get("items", {}), f"{place}[{number}]")
    return found


def table_faults(value, schema, place):
    properties = schema.get("properties", {})
    found = [f"{place}.{name} is missing" for name in schema.get("required", []) if name not in value]
    for name, entry in value.items():
        if name in properties:
            found += faults(entry, properties[name], f"{place}.{name}")
        elif schema.get("additionalProperties", True) is False:
            found.append(f"{place}.{name} is unknown")
    return found
