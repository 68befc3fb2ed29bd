# SPDX-License-Identifier: BSD-3-Clause
"""Robots whose text ends twice or has bytes of another encoding, and tensors without value in bodies of several links.

A cell of texts_executed.tsv says `refuses`, `crashes` or `loads`.
"""
import itertools

from paths import Case

PLAIN = {"ixx": "0.01", "ixy": "0.001", "ixz": "0.001", "iyy": "0.02", "iyz": "0.001", "izz": "0.025"}
NOTHING = dict.fromkeys(PLAIN, "0")


def inertial(mass="0.5", xyz="0.01 0 0", rpy="0 0 0", **moments):
    values = " ".join(f'{name}="{value}"' for name, value in {**PLAIN, **moments}.items())
    return f'<inertial><origin xyz="{xyz}" rpy="{rpy}"/><mass value="{mass}"/><inertia {values}/></inertial>'


def joint(name, kind, parent, child):
    return (f'<joint name="{name}" type="{kind}"><origin xyz="0.1 0 0" rpy="0.1 0 0"/><parent link="{parent}"/><child link="{child}"/>'
            '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>')


def robot(links, joints, begin="", end="", name="r"):
    return f'{begin}<robot name="{name}">' + "".join(f'<link name="{key}">{value}</link>' for key, value in links.items()) + joints + f"</robot>{end}"


# Where a byte stands: what is replaced by it.
PLACES = {"comment": "<!-- @ -->", "text": "@", "name-of-robot": "", "name-of-link": "", "name-of-joint": "", "tag": "<@/>",
          "attribute": '<a @="1"/>', "material": '<material name="@"><color rgba="1 0 0 1"/></material>',
          "gazebo": '<gazebo reference="hand"><material>@</material></gazebo>'}
BYTES = {"last": b"a\xe9", "inside": b"a\xe9bcd", "pair": b"a\xc3", "continuation": b"a\x80"}
DECLARATIONS = {"none": "", "plain": '<?xml version="1.0"?>\n', "utf-8": '<?xml version="1.0" encoding="UTF-8"?>\n',
                "latin": '<?xml version="1.0" encoding="ISO-8859-1"?>\n'}


def byte_cases():
    for place, written, declared in itertools.product(PLACES, BYTES, DECLARATIONS):
        if written in ("pair", "continuation") and declared != "plain":
            continue
        text = BYTES[written].decode("utf-8", "surrogateescape")
        hand = text if place == "name-of-link" else "hand"
        links = {"base": inertial(), hand: inertial()}
        body = joint(text if place == "name-of-joint" else "j", "revolute", "base", hand) + PLACES[place].replace("@", text)
        name = text if place == "name-of-robot" else "r"
        yield f"byte:{place}:{written}:{declared}", robot(links, body, DECLARATIONS[declared], name=name)


ENDS = {"nul": "\0", "line-nul": "\n\0", "nul-line": "\0\n", "nuls": "\n\0\0\0\n \0", "comment-nul": "<!-- c -->\0",
        "robot": "<robot name='b'/>", "robots": "\n<robot name='b'><link name='q'/></robot>\n<robot/>", "element": "<x/>",
        "broken-robot": "<robot name='b'><a></robot>", "open-robot": "<robot name='b'>", "text": "hello"}


def end_cases():
    for what, end in ENDS.items():
        yield f"end:{what}", robot({"base": inertial(), "hand": inertial()}, joint("j", "revolute", "base", "hand"), end=end)


# What moves with the link that is wrong: the inertial of the link that carries it, or of the one that it carries.
COMPANY = {"carried-none": "", "carried-zero": inertial("1e-9", "0 0 0", **NOTHING), "carried-point": inertial("0.2", **NOTHING),
           "carried-good": inertial(), "carrier-none": "", "carrier-zero": inertial("1e-9", "0 0 0", **NOTHING), "carrier-good": inertial()}
WRONG = {"mass": ("nan", "inf"), "xyz": ("nan", "inf"), "rpy": ("nan", "inf"), "ixx": ("nan", "inf", "1e-320"), "ixy": ("nan", "inf", "1e-320"),
         "izz": ("nan", "inf", "1e-320")}


def body_cases():
    for (company, other), (field, values) in itertools.product(COMPANY.items(), WRONG.items()):
        for value in values:
            wrong = inertial(**{field: f"0 {value} 0" if field in ("xyz", "rpy") else value})
            upper, lower = (wrong, other) if company.startswith("carried") else (other, wrong)
            yield f"body:{company}:{field}:{value}", robot(
                {"base": inertial(), "upper": upper, "lower": lower}, joint("j", "continuous", "base", "upper") + joint("k", "fixed", "upper", "lower"))
    for field in PLAIN:
        yield f"product:{field}", robot({"base": inertial(), "hand": inertial(**{**NOTHING, field: "1e-320"})}, joint("j", "continuous", "base", "hand"))


def all_cases():
    """{name: Case}"""
    return {name: Case(text, {}) for name, text in (*byte_cases(), *end_cases(), *body_cases())}
