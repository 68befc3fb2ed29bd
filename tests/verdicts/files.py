# SPDX-License-Identifier: BSD-3-Clause
"""Damages of whole bodies, of the tree of links, and of the file itself."""
import robot as robots
from robot import Element

LINKS = ("base", "plate", "arm", "tool", "wheel")


def inertial(mass, moments, products=("0", "0", "0")):
    names = zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), (*moments, *products))
    return Element("inertial", children=[Element("mass", [("value", mass)]), Element("inertia", names)])


BODIES = {
    "massless": inertial("0", ("0.01", "0.01", "0.01")), "nothing": inertial("0", ("0", "0", "0")),
    "no-moments": inertial("1", ("0", "0", "0")), "negative-mass": inertial("-1", ("0.01", "0.01", "0.01")),
    "negative-moment": inertial("1", ("-0.01", "0.01", "0.01")),
    "negative-moments": inertial("1", ("-0.01", "-0.01", "-0.01")),
    "triangle": inertial("1", ("0.01", "0.01", "0.05")), "triangle-slightly": inertial("1", ("0.01", "0.01", "0.0200001")),
    "triangle-rounding": inertial("1", ("0.01", "0.01", "0.02000000000000001")),
    "rod": inertial("1", ("0.01", "0.01", "0")), "flat": inertial("1", ("0.01", "0.01", "0.02")),
    "indefinite": inertial("1", ("0.01", "0.01", "0.01"), ("0.02", "0", "0")),
    "indefinite-slightly": inertial("1", ("0.01", "0.01", "0.01"), ("0.0100001", "0", "0")),
    "tiny-mass": inertial("1e-7", ("3e-22", "3e-22", "3e-22")), "small-mass": inertial("1e-5", ("1e-9", "1e-9", "1e-9")),
    "smaller-mass": inertial("1e-9", ("1e-3", "1e-3", "1e-3")), "smallest-mass": inertial("1e-16", ("1e-3", "1e-3", "1e-3")),
    "tiny-moments": inertial("1", ("1e-16", "1e-16", "1e-16")), "small-moments": inertial("1", ("1e-9", "1e-9", "1e-9")),
    "huge": inertial("1e12", ("1e12", "1e12", "1e12")), "huge-moments": inertial("1", ("1e6", "1e6", "1e6")),
    "identity": inertial("1", ("1", "1", "1")), "one-negative-product": inertial("1", ("0.01", "0.012", "0.014"), ("-0.001", "0", "0")),
}


def with_link(base, name, change):
    changed = base.copy()
    change(changed.first(f"link:{name}"))
    return changed


def damage_bodies(cases, base):
    def without(*tags):
        return lambda link: setattr(link, "children", [one for one in link.children if one.tag not in tags])

    def replace(body):
        return lambda link: (without("inertial")(link), link.children.insert(0, body.copy()))

    for name in LINKS:
        for kind, body in BODIES.items():
            cases.add(f"link.{name}~{kind}", with_link(base, name, replace(body)))
            if kind in ("massless", "nothing", "no-moments", "rod", "tiny-mass", "smaller-mass", "tiny-moments"):
                hulled = with_link(with_link(base, name, replace(body)), name, without("collision"))
                cases.add(f"link.{name}~{kind}-without-hull", hulled)
        for what in (("inertial",), ("visual",), ("collision",), ("inertial", "collision"), ("visual", "collision"),
                     ("inertial", "visual", "collision")):
            cases.add(f"link.{name}~without-" + "-".join(what), with_link(base, name, without(*what)))
    damage_all_bodies(cases, base, without)


def damage_all_bodies(cases, base, without):
    for what in (("inertial",), ("visual",), ("collision",), ("inertial", "collision"), ("inertial", "visual", "collision")):
        changed = base.copy()
        for link in changed.all("link"):
            without(*what)(link)
        cases.add("links~without-" + "-".join(what), changed)
    for kind in ("massless", "nothing", "tiny-mass", "negative-mass"):
        changed = base.copy()
        for link in changed.all("link"):
            without("inertial")(link)
            link.children.insert(0, BODIES[kind].copy())
        cases.add(f"links~{kind}", changed)
    for places in (("visual",), ("collision",), ("visual", "collision")):
        for path in ("gone.stl", "gone/gone.stl", "package://nowhere/gone.stl"):
            for names in (("arm",), ("base", "arm"), ("base",)):
                changed = base.copy()
                for name in names:
                    for place in places:
                        changed.first(f"link:{name}", place, "geometry").children = [Element("mesh", [("filename", path)])]
                kind = path.split(":")[0].replace("/", "-")
                cases.add("links." + "-".join(names) + "~missing-" + "-".join(places) + ":" + kind, changed)


def joint(name, kind, parent, child, *rest):
    ends = [Element("parent", [("link", parent)]), Element("child", [("link", child)])]
    return Element("joint", [("name", name), ("type", kind)], [*ends, *rest])


def damage_trees(cases, base):
    """Links and joints that do not form a tree, and names that occur twice."""
    body = BODIES["identity"]
    limit = Element("limit", [("lower", "-1"), ("upper", "1"), ("effort", "1"), ("velocity", "1")])
    for kind in ("fixed", "revolute", "floating", "planar", "spherical"):
        extra = [limit.copy()] if kind == "revolute" else []
        for name, parent, child in (("self", "tool", "tool"), ("ring", "tool", "base"), ("second-parent", "plate", "tool"),
                                    ("same-parent", "base", "arm"), ("backwards", "tool", "arm"),
                                    ("unknown-parent", "nowhere", "tool"), ("unknown-child", "tool", "nowhere"),
                                    ("both-unknown", "nowhere", "nowhere")):
            add_with(cases, base, f"tree:{name}-{kind}", [joint("extra", kind, parent, child, *extra)])
        for new, contents in (("empty", []), ("body", [body])):
            add_with(cases, base, f"tree:leaf-{new}-{kind}", [Element("link", [("name", "extra")], contents),
                                                             joint("extra_bolt", kind, "tool", "extra", *extra)])
            add_with(cases, base, f"tree:root-{new}-{kind}", [Element("link", [("name", "extra")], contents),
                                                             joint("extra_bolt", kind, "extra", "base", *extra)])
            add_with(cases, base, f"tree:world-{new}-{kind}", [Element("link", [("name", "world")], contents),
                                                              joint("world_bolt", kind, "world", "base", *extra)])
            add_with(cases, base, f"tree:detached-ring-{new}-{kind}", [
                Element("link", [("name", "one")], contents), Element("link", [("name", "two")], contents),
                joint("there", kind, "one", "two", *extra), joint("back", kind, "two", "one", *extra)])
        add_with(cases, base, f"tree:link-and-joint-{kind}", [Element("link", [("name", "extra")], [body]),
                                                              joint("extra", kind, "tool", "extra", *extra)])
        add_with(cases, base, f"tree:joint-and-other-link-{kind}", [Element("link", [("name", "extra")], [body]),
                                                                    joint("base", kind, "tool", "extra", *extra)])
    for new, contents in (("empty", []), ("body", [body])):
        add_with(cases, base, f"tree:detached-{new}", [Element("link", [("name", "extra")], contents)])
        add_with(cases, base, f"tree:same-link-{new}", [Element("link", [("name", "tool")], contents)])
        add_with(cases, base, f"tree:nameless-link-{new}", [Element("link", [], contents)])
        cases.add(f"tree:one-link-{new}", Element("robot", [("name", "one")], [Element("link", [("name", "one")], contents)]))
    damage_mimics(cases, base)


def add_with(cases, base, name, elements):
    changed = base.copy()
    changed.children += [one.copy() for one in elements]
    cases.add(name, changed)


def damage_mimics(cases, base):
    for name, followed in (("shoulder", "shoulder"), ("shoulder", "knuckle"), ("rail", "shoulder"), ("axle", "knuckle"),
                           ("rail", "plate_bolt"), ("plate_bolt", "shoulder"), ("axle", "axle")):
        changed = base.copy()
        changed.first(f"joint:{name}").children.append(Element("mimic", [("joint", followed)]))
        cases.add(f"tree:mimic-{name}-{followed}", changed)


def damage_files(cases, base):
    text = robots.document(base)
    data = text.encode()
    line = text.index('<link name="plate"')
    changes = {
        "no-declaration": data[data.index(b"<robot"):], "mark": b"\xef\xbb\xbf" + data, "blank-first": b"\n " + data,
        "utf-16": text.replace("1.0\"?>", "1.0\" encoding=\"UTF-16\"?>").encode("utf-16"),
        "says-utf-16": data.replace(b'"1.0"?>', b'"1.0" encoding="UTF-16"?>', 1),
        "latin-1": data.replace(b'"1.0"?>', b'"1.0" encoding="ISO-8859-1"?>', 1).replace(b"base_look", b"b\xe4se", 1),
        "bad-utf-8": data.replace(b"base_look", b"b\xffse", 1), "zero-byte": data.replace(b"base_look", b"b\0se", 1),
        "control": data.replace(b"base_look", b"b\x01se", 1), "windows": data.replace(b"\n", b"\r\n"),
        "empty": b"", "blank": b" \n", "text": b"robot\n", "half": data[:len(data) // 2], "unclosed": data[:-9],
        "closed-early": data.replace(b"  <link name=\"plate\"", b"</robot>\n  <link name=\"plate\"", 1),
        "two-roots": data + b'<robot name="second"><link name="only"/></robot>\n', "trailing-text": data + b"foo\n",
        "comment": text.replace("<link name=\"plate\"", "<!-- a -- b --><link name=\"plate\"").encode(),
        "comment-unclosed": (text[:line] + "<!-- " + text[line:]).encode(),
        "ampersand": data.replace(b"base_look", b"a & b", 1), "less": data.replace(b"base_look", b"a < b", 1),
        "no-quotes": data.replace(b'value="8"', b"value=8", 1), "single-quotes": data.replace(b'"', b"'"),
        "quote-missing": data.replace(b'value="8"', b'value="8', 1), "no-value": data.replace(b'value="8"', b"value", 1),
        "tag-mismatch": data.replace(b"</inertial>", b"</inertia>", 1), "blank-tag": data.replace(b"<mass ", b"< mass ", 1),
        "entity": data.replace(b"base_look", b"&look;", 1), "character": data.replace(b"base_look", b"&#98;ase", 1),
        "bad-character": data.replace(b"base_look", b"&#0;", 1), "section": (text[:line] + "<![CDATA[ a ]]>" + text[line:]).encode(),
        "instruction": (text[:line] + "<?foo bar?>" + text[line:]).encode(),
        "doctype": data.replace(b"<robot", b"<!DOCTYPE robot [<!ENTITY look \"base\">]>\n<robot", 1),
        "pointer": robots.meshes()["pointer.stl"], "markup": b"<html><body>404</body></html>\n",
        "undeclared-prefix": data.replace(b"<link name=\"plate\"", b"<foreign:x/><link name=\"plate\"", 1),
        "xacro": data.replace(b"<link name=\"plate\"", b"<xacro:property name=\"a\" value=\"1\"/><link name=\"plate\"", 1),
        "wrapped": data.replace(b"<robot", b"<models><robot", 1) + b"</models>\n",
        "extension": data.replace(b"</robot>", b"<mujoco><compiler discardvisual=\"false\"/></mujoco></robot>", 1),
        "comma-lists": data.replace(b" 0 0 ", b", 0, 0, ", 1), "upper": data.upper(),
    }
    for kind, changed in changes.items():
        cases.add(f"file:{kind}", changed)
    damage_extensions(cases, base)


def damage_extensions(cases, base):
    """The extensions of Gazebo and MuJoCo that change how they read the rest."""
    reference = Element("gazebo", [("reference", "tool_bolt")])
    for name, text in (("preserveFixedJoint", "true"), ("preserveFixedJoint", "foo"), ("disableFixedJointLumping", "true")):
        for kind, body in (("whole", None), ("massless", BODIES["nothing"]), ("triangle", BODIES["triangle"])):
            changed = base.copy()
            extension = reference.copy()
            extension.children.append(Element(name, text=text))
            changed.children.append(extension)
            if body:
                changed.first("link:tool").children[0] = body.copy()
            cases.add(f"extension:{name}-{text}-{kind}", changed)
    for compiler, value in (("discardvisual", "false"), ("fusestatic", "false"), ("strippath", "false"), ("meshdir", "gone"),
                            ("balanceinertia", "true"), ("inertiafromgeom", "true"), ("boundmass", "0.001"), ("angle", "degree"),
                            ("foreign", "1"), ("discardvisual", "foo")):
        for kind in ("whole", "missing-visual", "sizeless-visual", "triangle"):
            changed = base.copy()
            changed.children.append(Element("mujoco", children=[Element("compiler", [(compiler, value)])]))
            if kind == "missing-visual":
                changed.first("link:arm", "visual", "geometry", "mesh").set("filename", "gone.stl")
            elif kind == "sizeless-visual":
                changed.first("link:base", "visual", "geometry", "box").set("size", "0 0 0")
            elif kind == "triangle":
                changed.first("link:arm").children[0] = BODIES["triangle"].copy()
            cases.add(f"extension:{compiler}-{value}-{kind}", changed)
