# SPDX-License-Identifier: BSD-3-Clause
"""Random schemas and values: smurf-lint accepts the values that the Python package jsonschema accepts.

usage: user_schemas_test.py SMURF_LINT [COUNT]; skips without the package jsonschema.
"""
import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    sys.exit(77)

NAMES = ["a", "ab", "b", "ba", "c_1", "wheel"]
PATTERNS = ["^a", "b$", "^[ab]+$", "(a|b)+", "_\\d", "^.?$", "e{2}"]
TYPES = ["array", "boolean", "integer", "null", "number", "object", "string"]


def scalar(rng):
    return rng.choice([None, True, False, 0, 1, 2, 3, -1, 1.0, 0.5, 2.5, "a", "ab", "wheel", "", "3"])


def value(rng, depth=2):
    kind = rng.random()
    if depth and kind < 0.3:
        return [value(rng, depth - 1) for _ in range(rng.randrange(4))]
    if depth and kind < 0.7:
        return {name: value(rng, depth - 1) for name in rng.sample(NAMES, rng.randrange(5))}
    return scalar(rng)


def some(rng, make, most=3):
    return [make() for _ in range(rng.randint(1, most))]


def schema(rng, depth=3):
    if rng.random() < 0.06:
        return rng.random() < 0.6
    inner = (lambda: schema(rng, depth - 1)) if depth else (lambda: {})
    whole = lambda: rng.randrange(4)
    makers = {
        "type": lambda: rng.choice([rng.choice(TYPES), rng.sample(TYPES, 3)]),
        "enum": lambda: some(rng, lambda: value(rng), 4),
        "const": lambda: value(rng),
        "maximum": whole, "minimum": whole, "exclusiveMaximum": whole, "exclusiveMinimum": whole,
        "multipleOf": lambda: rng.choice([1, 2, 0.5]),
        "maxItems": whole, "minItems": whole, "maxLength": whole, "minLength": whole,
        "maxProperties": whole, "minProperties": whole,
        "uniqueItems": lambda: rng.random() < 0.7,
        "pattern": lambda: rng.choice(PATTERNS),
        "required": lambda: rng.sample(NAMES, rng.randint(1, 2)),
        "items": lambda: inner() if rng.random() < 0.6 else some(rng, inner),
        "additionalItems": inner,
        "contains": inner,
        "properties": lambda: {name: inner() for name in rng.sample(NAMES, 2)},
        "patternProperties": lambda: {pattern: inner() for pattern in rng.sample(PATTERNS, 2)},
        "additionalProperties": inner,
        "propertyNames": inner,
        "dependencies": lambda: {rng.choice(NAMES): rng.choice([inner(), rng.sample(NAMES, 1)])},
        "allOf": lambda: some(rng, inner), "anyOf": lambda: some(rng, inner), "oneOf": lambda: some(rng, inner),
        "not": inner, "if": inner, "then": inner, "else": inner,
    }
    made = {name: makers[name]() for name in rng.sample(sorted(makers), rng.randint(1, 3))}
    if isinstance(made.get("items"), bool):  # jsonschema raises an exception for both
        made.pop("additionalItems", None)
    if depth == 3:
        made["definitions"] = {"d": schema(rng, 1)}
        if rng.random() < 0.4:
            made.setdefault("allOf", []).append({"$ref": "#/definitions/d"})
    return made


def main(program, count=400):
    seed = random.randrange(10**6)
    rng = random.Random(seed)
    cases = [(schema(rng), rng.choice([{}, []]) if rng.random() < 0.05 else value(rng)) for _ in range(count)]
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        names = [f"s{i}" for i in range(count)]
        (root / ".smurf-lint.yaml").write_text(
            "schemas: {sections: {" + ", ".join(f"{name}: {name}.json" for name in names) + "}}\n")
        for name, (one, data) in zip(names, cases):
            (root / f"{name}.json").write_text(json.dumps(one))
            (root / f"{name}.smurf").write_text(f"modelname: m\nfiles: []\n{name}: {json.dumps(data)}\n")
        done = subprocess.run([os.path.abspath(program), "--format", "json", "--exit-zero", "."], cwd=folder, capture_output=True, text=True)
        found = json.loads(done.stdout)["diagnostics"]
    refused = {pathlib.Path(one["file"]).stem for one in found if one["id"] == "SML4301"}
    broken = {pathlib.Path(one["file"]).stem for one in found if one["id"] == "SML9011"}
    assert not broken, (broken, seed)
    wrong = []
    for name, (one, data) in zip(names, cases):
        fits = jsonschema.Draft7Validator(one).is_valid(data)
        if fits == (name in refused):
            wrong.append(f"jsonschema {'accepts' if fits else 'refuses'} {json.dumps(data)} by {json.dumps(one)}")
    fitting = count - len(refused)
    print(f"seed {seed}: {count} values, {fitting} of them fit, {len(wrong)} verdicts differ")
    print("\n".join(wrong[:10]))
    assert fitting > count / 10 and len(refused) > count / 10
    sys.exit(1 if wrong else 0)


main(sys.argv[1], *map(int, sys.argv[2:]))
