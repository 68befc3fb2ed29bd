# SPDX-License-Identifier: BSD-3-Clause
"""Files with mistakes of all kinds: every attribute and function gives a value or raises as promised."""
import os
import random

import inputs
import smurf

ROUNDS = int(os.environ.get("SMURF_TEST_CASES", "400"))
EXPECTED = (smurf.Error, ValueError, KeyError)
PIECES = [b"nan", b"1e999", b"-", b"\xff", b"\x00", b"'", b'"', b"<", b">", b"&", b"{", b"[", b"*a", b": ", b"\n- ",
          b"<mimic joint='x'/>", b"world", b"..", b"1e308", b"\xe2\x80\xa8"]


def mutated(text, random):
    text = bytearray(text)
    for _ in range(random.randint(1, 6)):
        at = random.randrange(len(text) + 1)
        match random.randrange(4):
            case 0:
                text[at:at + random.randint(1, 30)] = b""
            case 1:
                text[at:at] = random.choice(PIECES)
            case 2:
                text[at:at + 1] = bytes([random.randrange(256)])
            case 3:
                begin = random.randrange(len(text) + 1)
                text[at:at] = text[begin:begin + random.randint(1, 60)]
    return bytes(text)


def visit(value, depth=0):
    """All attributes of an object and of the objects in them."""
    repr(value)
    if isinstance(value, (list, tuple)):
        for item in value[:20]:
            visit(item, depth)
    elif isinstance(value, dict):
        for item in list(value.values())[:20]:
            visit(item, depth)
    elif type(value).__module__.startswith("smurf") and depth < 5:
        hash(value)
        for name in dir(type(value)):
            if not name.startswith("_") and not callable(getattr(type(value), name)):
                visit(getattr(value, name), depth + 1)


def attempt(function, *arguments, **keywords):
    try:
        return function(*arguments, **keywords)
    except EXPECTED as error:
        str(error), visit(list(getattr(error, "findings", [])))
        return None


def exercise(session, path):
    visit(attempt(session.check, path))
    model = attempt(session.load_model, path)
    if model is not None:
        visit(model)
        attempt(model.forward_kinematics)
        attempt(model.to_urdf)
        attempt(model.to_urdf, force=True, collapse_fixed=True, canonical=True)
        attempt(model.to_json), attempt(model.check)
    scene = attempt(session.load_scene, path)
    if scene is not None:
        visit(scene)
        for dialect in ("spec", "mars", "phobos"):
            visit(attempt(scene.flatten, dialect=dialect, links=True, force=True))
        attempt(scene.to_json), attempt(scene.check)


def test_mutations():
    chosen = random.Random(17)
    files = inputs.fixtures()
    for _ in range(ROUNDS):
        path = chosen.choice(files)
        companions = [p for p in path.parent.rglob("*") if p.suffix in {".urdf", ".yml", ".smurf", ".smurfs"}]
        session = smurf.Session()
        target = chosen.choice(companions or [path])
        if target.stat().st_size < 100_000:
            session.set_text(target, mutated(target.read_bytes(), chosen))
            exercise(session, path)
