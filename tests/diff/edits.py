# SPDX-License-Identifier: BSD-3-Clause
"""Edits of robots and scenes that change exactly one fact, and edits that change none."""
import random
import re
import xml.parsers.expat

try:
    import yaml
except ImportError:
    yaml = None


class Edit:
    """A text with one changed fact: `kind`, `name` and `owner` identify the thing, `path` the property."""

    def __init__(self, text, kind, name, path, owner="", new=None, change="changed"):
        self.text, self.kind, self.name, self.path, self.owner, self.new = text, kind, name, path, owner, new
        self.change = change

    def __repr__(self):
        return f"{self.kind} {self.name} of {self.owner or 'nothing'}: {self.change} {self.path} {self.new or ''}"

    def is_told_by(self, found):
        """Whether a difference of the JSON report is this one; of a vector, the whole may be reported."""
        if (found["change"], found["kind"], found["name"], found.get("of", "")) != (
                self.change, self.kind, self.name, self.owner):
            return False
        if self.change != "changed":
            return True
        told = found["property"]
        return self.path == told or any(self.path.startswith(told + mark) for mark in ".[")


class Element:
    def __init__(self, tag, attributes, begin, parent):
        self.tag, self.attributes, self.begin, self.parent = tag, attributes, begin, parent
        self.children, self.end = [], 0

    def child(self, tag):
        return next((one for one in self.children if one.tag == tag), None)

    def up(self, *tags):
        one = self.parent
        while one is not None and one.tag not in tags:
            one = one.parent
        return one


def elements_of(text):
    """All elements of a URDF, with their bytes."""
    parser = xml.parsers.expat.ParserCreate()
    stack, found = [], []

    def start(tag, attributes):
        one = Element(tag, attributes, parser.CurrentByteIndex, stack[-1] if stack else None)
        if stack:
            stack[-1].children.append(one)
        stack.append(one)
        found.append(one)

    def end(_):
        index = parser.CurrentByteIndex
        one = stack.pop()
        # For an empty element, the index is that of the text after it.
        closing = text.find(b">", index) + 1 if text[index:index + 2] == b"</" else 0
        one.end = closing or text.index(b">", one.begin) + 1

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.Parse(text, True)
    return found


def attribute_span(text, element, name):
    tag = re.compile(rb"<(?:[^>\"']|\"[^\"]*\"|'[^']*')*>", re.S).match(text, element.begin)
    found = re.compile(rb"[\s\"']" + name.encode() + rb"\s*=\s*(\"[^\"]*\"|'[^']*')", re.S).search(
        text, element.begin, tag.end())
    return found.start(1) + 1, found.end(1) - 1


def moved(number, rng):
    """Another number that differs enough to be visible."""
    return float(repr(number * rng.choice([1.1, 0.9, 1.5]) if abs(number) > 1e-4 else number + rng.choice([0.05, 0.3])))


# The place of a number: the names of its element and attribute.
NUMBERS = {
    "limit": ("lower", "upper", "effort", "velocity"), "dynamics": ("damping", "friction"),
    "mimic": ("multiplier", "offset"), "safety_controller": ("k_velocity", "k_position", "soft_lower_limit"),
    "axis": ("xyz",), "origin": ("xyz", "rpy"), "mass": ("value",), "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "box": ("size",), "sphere": ("radius",), "cylinder": ("radius", "length"), "mesh": ("scale",), "color": ("rgba",),
}


def owner_of(element):
    """(kind, name, owner) of the thing of an element of a link or joint, and its name unless it is one of several
    without a name."""
    thing = element.up("joint", "visual", "collision", "link", "material")
    material = element.up("material")
    if thing is material and material.parent.tag != "robot":
        thing = material.up("visual")
    if thing is None:
        return None
    name = thing.attributes.get("name", "")
    if thing.tag in ("visual", "collision"):
        return thing.tag, name, "link " + thing.parent.attributes.get("name", "")
    return thing.tag, name, ""


def path_of(element, attribute):
    tag, parent = element.tag, element.parent.tag
    if tag == "origin":
        return {"xyz": "inertial.center_of_mass", "rpy": "inertial.inertia"}[attribute] if parent == "inertial" else "pose"
    if tag == "inertia":
        return "inertial.inertia"
    if tag == "mass":
        return "inertial.mass"
    if tag == "color":
        return "color" if element.parent.parent.tag == "robot" else "material.color"
    if tag == "axis":
        return "axis"
    return f"{tag}.{attribute}"


# The parents must be among these, because others are unknown in URDF, or misspelt.
PARENTS = {"robot", "link", "joint", "material", "visual", "collision", "inertial", "geometry"}


def is_standard(element):
    """Whether URDF defines the element there; only the first one, and not in an element of a vendor."""
    parents = {"limit": "joint", "dynamics": "joint", "mimic": "joint", "safety_controller": "joint", "axis": "joint",
               "mass": "inertial", "inertia": "inertial", "box": "geometry", "sphere": "geometry", "cylinder": "geometry",
               "mesh": "geometry", "color": "material"}
    parent = element.parent
    if parent is None or parent.child(element.tag) is not element:
        return False
    if element.tag == "origin":
        if parent.tag not in ("joint", "inertial", "visual", "collision"):
            return False
    elif parents.get(element.tag) != parent.tag or (parent.tag == "geometry" and parent.children[0] is not element):
        return False
    chain = []
    while parent is not None:
        chain.append(parent.tag)
        parent = parent.parent
    return chain[-1] == "robot" and chain[-2:-1] and chain[-2] in ("link", "joint", "material") and PARENTS.issuperset(chain)


def tensor_turns(element):
    """Whether rotating the frame changes the inertia, unlike that of a ball."""
    tensor = element.parent.child("inertia")
    values = [float(tensor.attributes.get(key, "0")) for key in NUMBERS["inertia"]] if tensor else [0] * 6
    largest = max(map(abs, values))
    off = max(map(abs, (values[1], values[2], values[4])))
    return largest > 0 and (off > 1e-3 * largest or max(abs(values[0] - values[3]), abs(values[3] - values[5])) > 1e-3 * largest)


def number_edits(text, rng):
    """A number of a URDF."""
    places = [(element, name) for element in elements_of(text) if element.tag in NUMBERS and is_standard(element)
              for name in NUMBERS[element.tag] if name in element.attributes]
    rng.shuffle(places)
    for element, name in places:
        owner = owner_of(element)
        if owner is None or (name == "rpy" and element.parent.tag == "inertial" and not turns_by(element)):
            continue
        try:
            numbers = [float(word) for word in element.attributes[name].split()]
        except ValueError:
            continue
        which = rng.randrange(len(numbers)) if numbers else None
        if which is None or max(map(abs, numbers)) > 1e300:
            continue
        before = list(numbers)
        numbers[which] = moved(numbers[which], rng)
        if name == "rgba":
            numbers[which] = 0.5 if before[which] < 0.4 else 0.25
        if name == "rpy" and element.parent.tag == "inertial" and not turns_by(element, before, numbers):
            continue
        begin, end = attribute_span(text, element, name)
        new = " ".join(repr(number) for number in numbers).encode()
        kind, thing, of = owner
        yield Edit(text[:begin] + new + text[end:], kind, thing, path_of(element, name), of, numbers[which])


def matrix(rpy):
    from math import cos, sin
    (r, p, y) = rpy
    return [[cos(y) * cos(p), cos(y) * sin(p) * sin(r) - sin(y) * cos(r), cos(y) * sin(p) * cos(r) + sin(y) * sin(r)],
            [sin(y) * cos(p), sin(y) * sin(p) * sin(r) + cos(y) * cos(r), sin(y) * sin(p) * cos(r) - cos(y) * sin(r)],
            [-sin(p), cos(p) * sin(r), cos(p) * cos(r)]]


def turns_by(element, before=None, after=None):
    """Whether a changed rpy of an inertial frame changes the inertia in the frame of the link."""
    if before is None:
        return tensor_turns(element)
    tensor = element.parent.child("inertia").attributes
    xx, xy, xz, yy, yz, zz = (float(tensor.get(key, "0")) for key in NUMBERS["inertia"])
    inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]

    def turned(rpy):
        rotation = matrix(rpy)
        return [sum(rotation[i][k] * inertia[k][m] * rotation[j][m] for k in range(3) for m in range(3))
                for i in range(3) for j in range(3)]
    largest = max(abs(value) for row in inertia for value in row)
    return len(before) == 3 and max(abs(a - b) for a, b in zip(turned(before), turned(after))) > 1e-6 * largest


def removals(text, rng):
    """Deletes an element of a link or joint."""
    places = [one for one in elements_of(text) if one.parent is not None and (
        (one.tag in ("visual", "collision") and one.parent.tag == "link") or
        (one.tag in ("dynamics", "mimic") and one.parent.tag == "joint"))]
    rng.shuffle(places)
    for element in places:
        cut = text[:element.begin] + text[element.end:]
        if element.tag in ("visual", "collision"):
            if element.attributes.get("name"):
                yield Edit(cut, element.tag, element.attributes["name"], "", "link " + element.parent.attributes["name"],
                           change="removed")
        elif any(float(value) != 0 for name, value in element.attributes.items() if name in NUMBERS[element.tag]):
            if element.parent.child(element.tag) is element:
                several = sum(float(value) != (1 if name == "multiplier" else 0) for name, value in element.attributes.items()
                              if name in NUMBERS[element.tag]) + (element.tag == "mimic")
                path = element.tag if several != 1 else element.tag + ".damping"
                if several == 1 and element.tag == "dynamics":
                    path = "dynamics." + next(n for n in ("damping", "friction") if float(element.attributes.get(n, 0)) != 0)
                if several == 1 and element.tag == "mimic":
                    path = "mimic.joint"
                yield Edit(cut, "joint", element.parent.attributes["name"], path)


def types(text, rng):
    """Changes the type of a joint."""
    places = [one for one in elements_of(text) if one.tag == "joint" and one.parent.tag == "robot" and "type" in one.attributes]
    rng.shuffle(places)
    for element in places:
        begin, end = attribute_span(text, element, "type")
        new = "continuous" if element.attributes["type"] != "continuous" else "revolute"
        yield Edit(text[:begin] + new.encode() + text[end:], "joint", element.attributes["name"], "type", new=new)


def urdf_edit(text, rng):
    """One edit, or None if there is nothing to edit."""
    makers = rng.choices([number_edits, removals, types], weights=[10, 2, 1], k=4) + [number_edits]
    return next((edit for maker in makers for edit in maker(text, rng)), None)


# YAML.

ENTRIES = {"motors": "motor", "sensors": "sensor", "controllers": "controller", "materials": "material annotation",
           "material": "material annotation", "collision": "collision annotation", "collisions": "collision annotation",
           "visuals": "visual annotation", "link": "link annotation", "links": "link annotation", "joint": "joint annotation",
           "joints": "joint annotation", "poses": "joint pose set", "lights": "light", "nodes": "node",
           "motor": "motor", "sensor": "sensor", "entities": "entity", "smurfs": "entity", "smurfa": "entity"}


def numbers_in(node, path):
    """(path, scalar) of the plain numbers below a node; items of a list are reported with the list."""
    if isinstance(node, yaml.ScalarNode):
        if node.tag in ("tag:yaml.org,2002:int", "tag:yaml.org,2002:float") and node.style is None:
            try:
                float(node.value)
            except ValueError:
                return
            yield path, node
    elif isinstance(node, yaml.MappingNode):
        if path.split(".")[-1] == "rotation" and sum(value.value.strip("+-0.") != "" for _, value in node.value) < 2:
            return  # a quaternion of one component is the same rotation for any length
        for key, value in node.value:
            yield from numbers_in(value, f"{path}.{key.value}" if path else key.value)
    else:
        if path == "rotation" and len(node.value) not in (1, 3):
            return  # a multiple of a quaternion is the same rotation
        for number, value in enumerate(node.value):
            yield from numbers_in(value, f"{path}[{number}]")


def has_repeated_keys(node):
    if isinstance(node, yaml.MappingNode):
        keys = [key.value for key, _ in node.value if isinstance(key, yaml.ScalarNode)]
        return len(set(keys)) < len(keys) or any(has_repeated_keys(value) for _, value in node.value)
    return isinstance(node, yaml.SequenceNode) and any(map(has_repeated_keys, node.value))


def yaml_edit(text, rng, around=""):
    """Changes a number of an entry of a section or of an entity. With anchors, other entries may share the number;
    PyYAML reads some words as booleans."""
    if re.search(r"[&*]\w|<<:", text) or re.search(r"(?im)[:\-\[,{]\s*(yes|no|on|off)\s*($|[,}\]#])", text):
        return None
    root = yaml.compose(text)
    if has_repeated_keys(root):
        return None  # MARS uses the first one, PyYAML the last one
    places = []
    for key, section in root.value if isinstance(root, yaml.MappingNode) else ():
        if key.value not in ENTRIES or not isinstance(section, yaml.SequenceNode):
            continue
        entries = [entry for entry in section.value if isinstance(entry, yaml.MappingNode)]
        names = [next((v.value for k, v in entry.value if k.value == "name"), "") for entry in entries]
        for entry, name in zip(entries, names):
            if name and names.count(name) == 1:
                places += [(ENTRIES[key.value], name, *place) for place in numbers_in(entry, "")]
    if not places:
        return None
    # The other numbers of a rotation may be a multiple of w, and a changed name is another thing.
    places = [place for place in places if not place[2].endswith("rotation.w") and place[2] != "name"]
    if not places:
        return None
    kind, name, path, node = rng.choice(places)
    is_whole = node.tag.endswith("int")
    number = float(node.value)
    new = str(int(number) + 1) if is_whole else repr(moved(number, rng))
    if kind == "entity" and path.split("[")[0].split(".")[0] in ("position", "rotation"):
        path = "placement"
    changed = text[:node.start_mark.index] + new + text[node.end_mark.index:]
    return Edit(changed, kind, around + name, path, new=float(new))


def shuffled_yaml(text, rng):
    """The same document with entries and keys in another order and in another style."""
    def mix(value):
        if isinstance(value, dict):
            items = [(key, mix(one)) for key, one in value.items()]
            rng.shuffle(items)
            return dict(items)
        if isinstance(value, list) and all(isinstance(one, dict) and "name" in one for one in value):
            value = [mix(one) for one in value]
            rng.shuffle(value)
        return value
    loader = type("Loader", (yaml.SafeLoader,), {})
    loader.yaml_implicit_resolvers = {first: [(tag, pattern) for tag, pattern in found if not tag.endswith("timestamp")]
                                      for first, found in yaml.SafeLoader.yaml_implicit_resolvers.items()}
    data = mix(yaml.load(text, loader))
    return "# a comment\n" + yaml.safe_dump(data, sort_keys=False, default_flow_style=rng.choice([True, False, None]))


def shuffled_urdf(text, rng):
    """The same robot with its elements and attributes in another order, quotes, blanks and comments."""
    def write(element, depth):
        pairs = [(name, value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;").replace("\n", "&#10;").replace("\t", "&#9;"))
                 for name, value in element.attributes.items()]
        rng.shuffle(pairs)
        tag = "<" + element.tag + "".join(f' {" " * rng.randrange(2)}{name} = "{value}"' for name, value in pairs)
        children = element.children
        body = text[element.begin:element.end].decode()
        inner = re.sub(r"<!--.*?-->", "", body, flags=re.S)
        if element.parent is not None and element.parent.tag == "robot" and element.tag not in ("link", "joint", "material"):
            return body + "\n"
        if not children:
            return " " * depth + tag + (">" + inner[inner.index(">") + 1:inner.rindex("</")] + f"</{element.tag}>" if "</" in inner else "/>") + "\n"
        if element.tag in ("robot", "joint", "inertial") or (element.tag in ("visual", "collision")):
            children = rng.sample(children, len(children))
            seen, order = set(), []
            for one in children:  # repeated keys keep their order
                if one.tag in ("link", "joint", "visual", "collision") and "name" in one.attributes:
                    order.append(one)
                elif one.tag not in seen:
                    seen.add(one.tag)
                    order += [other for other in element.children if other.tag == one.tag and not (
                        other.tag in ("link", "joint", "visual", "collision") and "name" in other.attributes)]
            children = order
        return (" " * depth + tag + ">\n<!-- a comment -->\n" + "".join(write(one, rng.randrange(5)) for one in children) +
                f"</{element.tag}>\n")
    return write(elements_of(text)[0], 0).encode()
