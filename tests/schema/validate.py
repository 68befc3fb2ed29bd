# SPDX-License-Identifier: BSD-3-Clause
"""Judges instances by the project's schemas with the jsonschema package.

    validate.py SCHEMAS CASES VERDICTS

CASES has one JSON object a line, {"schema": "motors.schema.json", "instance": ...}; VERDICTS gets
one line each, 1 for valid and 0 for invalid. Exit code 3: the package is not installed; 1: a schema
is not valid draft-07.
"""
import json
import pathlib
import sys

try:
    from jsonschema import Draft7Validator, SchemaError
except ImportError:
    sys.exit(3)


def resolved(schema, schemas):
    """The schema with references to other files replaced by their targets."""
    if isinstance(schema, list):
        return [resolved(item, schemas) for item in schema]
    if not isinstance(schema, dict):
        return schema
    target = schemas.get(schema.get("$ref"))
    if target is not None:
        return resolved({k: v for k, v in target.items() if k != "$id"}, schemas)
    return {key: resolved(value, schemas) for key, value in schema.items()}


def main(folder, cases, verdicts):
    schemas = {p.name: json.loads(p.read_text("utf-8")) for p in sorted(pathlib.Path(folder).iterdir())}
    for name, schema in schemas.items():
        try:
            Draft7Validator.check_schema(schema)
        except SchemaError as error:
            sys.exit(f"{name}: {error.message}")
    validators = {name: Draft7Validator(resolved(schema, schemas)) for name, schema in schemas.items()}
    with open(cases, encoding="utf-8") as lines, open(verdicts, "w", encoding="ascii") as out:
        for line in lines:
            case = json.loads(line)
            out.write("1\n" if validators[case["schema"]].is_valid(case["instance"]) else "0\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
