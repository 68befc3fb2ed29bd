#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Small xacro files, and folders around them, that ask for much work or memory: 200 of the kinds that once took minutes.

xacro_work_test.py FOLDER_OF_TOOLS [WORD...]

Each ends within the bounds of cost.py; where it fails, a finding names the cause. The inputs are made from templates by a
generator with a fixed start, so that they are the same in every run.
"""
import dataclasses
import pathlib
import random
import sys
import tempfile

import cost

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}<link name="a"/></robot>'
INPUTS = 200
# @ is a size up to a million, # a number of rounds up to a hundred thousand, ~ a big integer.
TEXTS = [
    "('a'*@).strip('b'*@+'a')", "('a'*@).rstrip('c'*@)", "('a'*@+'b') in 'a'*@", "('a'*@).find('a'*@+'b')", "('a'*@).count('a'*@+'b')",
    "('a'*@).replace('a'*@+'b', 'c')", "('ab'*@).partition('ba'*@+'c')", "('a'*@).rsplit('b'+'a'*@)", "('a'*@).rfind('b'+'a'*@)",
    "len('\u00e9'*@)", "('a'*@).isalpha()", "('\\t'*@).expandtabs(0)", "xacro.tokenize('a'*@, 'bcd'*@)", "('a'*@) == ('a'*@)",
    "('a'*@+'b') &lt; ('a'*@)", "('a'*@).title()", "('a b '*@).split()", "('a\\n'*@).splitlines()", "('a'*@).center(@)",
    "'{0}{0}{0}'.format('a'*@)", "'%s%s%s' % ('a'*@, 'b'*@, 'c'*@)", "('a'*@)[::2]", "('\u00e9'*@)[3]", "('a'*@).join(['b']*#)",
    "dict([('a'*@, 1)])", "dict([('a'*@, 1)]).get('a'*@)", "python.repr('\\n'*@)", "float('1'*@)", "int('9'*1200)", "('a'*@).zfill(@)",
]
LISTS = [
    "([0]*# + [1]) in [[0]*#]*#", "([[0]*#]*#).count([0]*# + [1])", "([[0]*#]*#).index([0]*# + [1])", "python.sorted([[0]*# + [i] for i in range(#)])",
    "python.sorted(['a'*@ + str(i) for i in range(#)])", "python.sorted([['a'*@], ['a'*@ + 'b']]*#)", "python.set(range(#)) &lt;= python.set(range(#))",
    "python.set(range(#)) == python.set(range(#))", "python.set(range(#)) - python.set(range(#))", "dict(**dict([(str(i), i) for i in range(#)]))",
    "python.sum([[0]]*#, [])", "python.sum([[i] for i in range(#)], [])", "len(list(python.zip([0]*#, [0]*#)))", "list(python.enumerate([0]*#))",
    "list(map(lambda x: [0]*#, range(#)))", "[[0]*# for i in range(#)]", "max([[0]*# for i in range(9)])", "(lambda l: [l.insert(0, 1) for i in range(#)])([])",
    "(lambda l: [l.pop(0) for i in range(#)])([0]*#)", "[l.reverse() for l in [[0]*#]*#]", "(lambda l: [l.extend(l + [1]) for i in range(#)])([1])",
    "python.tuple(range(#)) == python.tuple(range(#))", "[python.any(x) for x in [[0]*#]*#]", "dict([((i,)*9, i) for i in range(#)])",
    "[x for x in range(#) if x in list(range(#))]", "python.reversed([0]*#)", "[[[[x]]]*9 for x in range(#)]", "math.fsum([1e308, -1e308, 1e-308]*#)",
]
NUMBERS = [
    "~ % (2**2000 + 1)", "~ // 12345678901234567890123", "str(~)", "math.gcd(~, 3**2400)", "math.comb(4000, 2000)", "math.isqrt(~)", "~ * ~", "3**2500",
    "python.divmod(~, 2**64 + 1)", "'%x' % ~", "'{:,}'.format(~)", "math.factorial(500)", "math.perm(600)", "math.lcm(~, 2**1999 - 1)", "'%.900f' % 1e308",
    "round(1.2345e300, 300)", "round(~, -300)", "~ &amp; (~ - 1)", "~ == ~ + 1", "dict([(~, 1)])", "float(2**1000) == 2**1000", "str(1.2345e-300)",
    "1.5e300 &lt; 2**1000", "(~).bit_length()", "~ / 3**2400", "math.hypot(*[1.5]*#)", "math.prod([3]*#)",
]


@dataclasses.dataclass
class Input:
    title: str
    files: dict
    command: tuple


class Generator:
    def __init__(self):
        self.dice = random.Random(53)

    def expression(self, templates):
        text = self.dice.choice(templates)
        for mark, most in (("@", 990_000), ("#", 99_000)):
            while mark in text:
                text = text.replace(mark, str(self.dice.choice([most, most // 3, most // 10, most // 100])), 1)
        return text.replace("~", "(2**" + str(self.dice.choice([4094, 3000, 2040])) + " - 1)")

    def document(self, code):
        """An expression, once or in one of many loops."""
        rounds = self.dice.choice([100, 3000, 99_000])
        calls = "".join("<xacro:m/>" for _ in range(self.dice.choice([10, 300])))
        return self.dice.choice([
            f'<link name="n${{len(str({code}))}}"/>',
            f'<link name="n${{len([{code} for i in range({rounds})])}}"/>',
            f'<link name="n${{len([0 for i in range({rounds}) if {code}])}}"/>',
            f'<link name="n${{len(list(map(lambda x: {code}, range({rounds}))))}}"/>',
            f'<xacro:property name="p" value="${{[{code} for i in range({rounds})]}}"/><link name="n${{len(p)}}"/>',
            f'<xacro:if value="${{len(str({code})) == 1}}"><link name="b"/></xacro:if>',
            f'<xacro:macro name="m" params="x:=${{{code}}}"><link name="n${{len(str(x))}}"/></xacro:macro>{calls}',
            f'<xacro:macro name="m" params=""><xacro:property name="q" value="${{{code}}}"/><xacro:if value="${{len(str(q)) == 1}}"/></xacro:macro>{calls}',
            f'<link name="n${{len(str(python.sum([len(str({code})) for i in range({rounds})])))}}"/>',
        ])

    def expressions(self):
        for name, templates in (("texts", TEXTS), ("lists", LISTS), ("numbers", NUMBERS)):
            for number in range(50):
                code = self.expression(templates)
                yield Input(f"{name} {number}: {code[:60]}", {"r.urdf.xacro": ROBOT.format(self.document(code))}, ("smurf-lint", "r.urdf.xacro"))

    def structures(self):
        def structure(title, inside, files=None, command=("smurf-lint", "r.urdf.xacro")):
            return Input(title, {"r.urdf.xacro": ROBOT.format(inside), **(files or {})}, command)

        def calls(count, levels, body):
            macros = "".join(f'<xacro:macro name="m{i}" params="">' + f"<xacro:m{i + 1}/>" * count + "</xacro:macro>" for i in range(levels))
            return macros + f'<xacro:macro name="m{levels}" params="">{body}</xacro:macro><xacro:m0/>'

        for count, levels in ((10, 4), (30, 3), (100, 2)):
            yield structure(f"comments that macros copy {count}", calls(count, levels, "<!-- a -->\n" * 500))
            yield structure(f"long comments {count}", calls(count, levels, "<x>" + f"<!-- {'a' * 5000} -->\n" * 20 + "</x>"))
            yield structure(f"long attributes {count}", calls(count, levels, f'<x a="{"a" * 5000}"/>' * 20))
            yield structure(f"long texts {count}", calls(count, levels, f"<x>{'a' * 5000}</x>" * 20))
            yield structure(f"character data {count}", calls(count, levels, f"<x><![CDATA[{'a' * 5000}]]></x>" * 20))
            yield structure(f"instructions {count}", calls(count, levels, f"<x><?a {'a' * 5000}?></x>" * 20))
            yield structure(f"empty macros {count}", calls(count, levels, ""))
            yield structure(f"blanks {count}", calls(count, levels, " \n" * 3000))
            many = " ".join(f"p{i}:=1" for i in range(800))
            yield structure(f"parameters {count}", calls(count, levels, "<xacro:n/>" * 5) .replace("<xacro:m0/>", "")
                            + f'<xacro:macro name="n" params="{many}"></xacro:macro><xacro:m0/>')
            given = " ".join(f'p{i}="1"' for i in range(800))
            yield structure(f"given parameters {count}", f'<xacro:macro name="n" params="{many}"></xacro:macro>'
                            + calls(count, levels, f"<xacro:n {given}/>"))
            yield structure(f"conditions of long texts {count}",
                            calls(count, levels, f'<xacro:if value="${{1 or \'{"a" * 9000}\'}}"/>' * 5))
            yield structure(f"names of long expressions {count}",
                            calls(count, levels, f'<xacro:if value="${{[{"v" * 9000} for {"v" * 9000} in range(3)]}}"/>' * 5))

    def neighbours(self):
        lists = f"install(DIRECTORY {' '.join('d' + str(i) for i in range(100_000))} DESTINATION share)\n"
        includes = "".join(f'<xacro:include filename="$(find p)/x{i}.xacro"/>' for i in range(900))
        part = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>'
        package = "<package format=\"3\"><name>p</name>{}</package>"
        yield Input("a CMakeLists of a megabyte, read for each include", {
            "p/package.xml": package.format(""), "p/CMakeLists.txt": lists, "p/r.urdf.xacro": ROBOT.format(includes),
            **{f"p/x{i}.xacro": part for i in range(900)}}, ("smurf-lint", "p/r.urdf.xacro"))
        yield Input("a CMakeLists of a megabyte, read for each missing include", {
            "p/package.xml": package.format(""), "p/CMakeLists.txt": lists,
            "p/r.urdf.xacro": ROBOT.format(includes.replace("filename=", 'optional="true" filename='))}, ("smurf-lint", "p/r.urdf.xacro"))
        yield Input("a package.xml of a megabyte, read for each search", {
            "p/package.xml": package.format("<depend>d</depend>" * 55_000),
            "p/r.urdf.xacro": ROBOT.format('<x a="$(find p)"/>' * 9000)}, ("smurf-lint", "p/r.urdf.xacro"))
        yield Input("a package.xml of a megabyte and many meshes", {
            "p/package.xml": package.format("<depend>d</depend>" * 55_000),
            "p/r.urdf": '<robot name="r"><link name="a">' + "".join(
                f'<visual><geometry><mesh filename="package://p/m{i}.stl"/></geometry></visual>' for i in range(5000)) + "</link></robot>"},
            ("smurf-lint", "p/r.urdf"))
        launch = "<launch>" + '<arg name="a" default="1"/>' * 30_000 + "</launch>"
        arguments = "".join(f'<x a="$(arg a{i})"/>' for i in range(2000))
        yield Input("launch files beside arguments without values", {
            "r.urdf.xacro": ROBOT.format(arguments), **{f"launch/l{i}.launch": launch for i in range(20)}}, ("smurf-lint", "r.urdf.xacro"))
        settings = "xacro:\n" + "".join(f"- {{file: r{i}.urdf.xacro, arguments: {{a: {i}}}}}\n" for i in range(20_000))
        yield Input("a configuration of many robots", {
            ".smurf-lint.yaml": settings, **{f"r{i}.urdf.xacro": ROBOT.format('<xacro:arg name="a" default="1"/>') for i in range(200)}},
            ("smurf-lint", "."))
        undefined = "".join(f'<xacro:n{i}/>' for i in range(20_000))
        macros = "".join(f'<xacro:macro name="k{i}" params="a b c"/>' for i in range(5000))
        yield Input("calls of macros among many", {"r.urdf.xacro": ROBOT.format(macros + undefined)}, ("smurf-lint", "."))
        yield Input("calls of one macro", {"r.urdf.xacro": ROBOT.format('<xacro:macro name="k" params="a"><x/></xacro:macro>'
                                                                         + '<xacro:k a="1"/>' * 40_000)}, ("smurf-lint", "."))
        yield Input("properties without use", {"r.urdf.xacro": ROBOT.format("".join(
            f'<xacro:property name="p{i}" value="${{1 + {i}}}"/>' for i in range(20_000)))}, ("smurf-lint", "."))

    def variants(self):
        for number in range(5):
            code = ["[s[i] for s in ['a'*900000] for i in range(600)]", "[x % 12345678901234567890 for x in [2**4000]*20000]",
                    "[x == y for x in ['a'*900000]*20 for y in ['a'*900000+'b']*20]", "python.sorted([[0]*900 + [i] for i in range(900)])",
                    "[i for i in range(90000)]"][number]
            arguments = "a: [1, 2, 3, 4, 5, 6, 7, 8], b: [1, 2, 3, 4, 5, 6, 7, 8]"
            inside = f'<xacro:arg name="a" default="1"/><xacro:arg name="b" default="1"/><xacro:if value="${{len({code}) == 1}}"/>'
            yield Input(f"64 variants {number}", {"r.urdf.xacro": ROBOT.format(inside), ".smurf-lint.yaml":
                                                  f"xacro: [{{file: r.urdf.xacro, arguments: {{{arguments}}}}}]\n"}, ("smurf-lint", "."))

    def all(self):
        return [*self.expressions(), *self.structures(), *self.neighbours(), *self.variants()]


def faults(tools, one):
    with tempfile.TemporaryDirectory(prefix="smurf-work-") as name:
        folder = pathlib.Path(name)
        (folder / ".git").mkdir()
        for path, text in one.files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            (folder / path).write_text(text)
        runs = []

        def make_run():
            runs.append(cost.Run([tools / one.command[0], "--format", "concise", *one.command[1:]], folder))
            return runs[-1]

        yield from cost.faults(tools, make_run, codes=(0, 1))
        if runs[0].code == 1 and b"SML" not in runs[0].said:
            yield f"names no cause: {runs[0].said[:200]}"
        if "-v" in sys.argv:
            print(f"{runs[0].seconds:5.2f} s {runs[0].megabytes:4.0f} MB {one.title}: {runs[0].said[:90]!r}", flush=True)


def main():
    tools, words = pathlib.Path(sys.argv[1]).resolve(), [word for word in sys.argv[2:] if word != "-v"]
    inputs = [one for one in Generator().all() if not words or any(word in one.title for word in words)]
    failures = [f"{one.title}: {fault}" for one in inputs for fault in faults(tools, one)]
    print("\n".join(failures))
    print(f"{len(inputs)} inputs, {len(failures)} failures")
    return 1 if failures or (len(inputs) < INPUTS and not words) else 0


if __name__ == "__main__":
    sys.exit(main())
