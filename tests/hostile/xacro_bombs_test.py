# SPDX-License-Identifier: BSD-3-Clause
"""xacro files that would need the time, the memory, the files or the environment of their reader: each is a finding, in bounded
time and memory, and nothing outside of the folder is read.

xacro_bombs_test.py FOLDER_OF_TOOLS
"""
import pathlib
import shutil
import sys
import tempfile

import cost
import hostile_cli_test
import inputs

ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}<link name="a"/></robot>'
SECRET = "a8f1c3-secret"
LIMIT = b"SML3312"


def value(expression):
    return f'<link name="${{{expression}}}"/>'


def chain(count, text, first, end=None):
    """A property for each of `text`, which names the one before as {}."""
    return f'<xacro:property name="p0" value="{first}"/>' + "".join(
        f'<xacro:property name="p{i}" value="{text.replace("@", f"p{i - 1}")}"/>' for i in range(1, count)) + value(end or f"len(str(p{count - 1}))")


def doubling(count, call="<xacro:m{}/><xacro:m{}/>"):
    """Macros that call the next twice."""
    text = "".join(f'<xacro:macro name="m{i}" params="">{call.replace("{}", str(i + 1))}</xacro:macro>' for i in range(count))
    return text + f'<xacro:macro name="m{count}" params=""><b/></xacro:macro><xacro:m0/>'


def recursion(parameters, again, call):
    return (f'<xacro:macro name="m" params="{parameters}"><xacro:if value="${{True}}">{again}</xacro:if></xacro:macro>{call}')


def yaml_bomb(levels):
    text = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n"
    return text + "".join(f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, levels))


LOAD = '<xacro:property name="d" value="${xacro.load_yaml(\'d.yaml\')}"/>'
# The title, what stands in the robot, the rules of which one must be reported, other files.
BOMBS = [
    ("a text times a number", value("'a'*10**8"), LIMIT, {}),
    ("a number times a text", value("10**8*'ab'"), LIMIT, {}),
    ("a text times a large number", value("'a'*10**30"), LIMIT, {}),
    ("a list times a number", value("len([0]*10**9)"), LIMIT, {}),
    ("a list of lists times a number", value("[[[0]*1000]*1000]*1000"), LIMIT, {}),
    ("a power", value("10**10**10"), LIMIT, {}),
    ("a power of a power", value("9**9**9"), LIMIT, {}),
    ("a negative power", value("(-10)**10**10"), LIMIT, {}),
    ("a shift", value("1 &lt;&lt; 10**12"), LIMIT, {}),
    ("a factorial", value("factorial(10**7)"), b"SML33", {}),
    ("binomial coefficients", value("comb(10**7, 10**6)"), b"SML33", {}),
    ("permutations", value("perm(10**7)"), b"SML33", {}),
    ("a product of a range", value("prod(range(1, 10**6))"), LIMIT, {}),
    ("the least common multiple", value("lcm(*[2**4000+i for i in range(1000)])"), LIMIT, {}),
    ("an integer of many digits", value("1" * 100_000), b"SML33", {}),
    ("an integer in a text", value("int('1'*100000)"), b"SML33", {}),
    ("a list of a range", value("list(range(10**9))"), LIMIT, {}),
    ("a range as a text", f'<xacro:if value="${{range(10**9)[5] == 5}}">{value("list(range(10**18))")}</xacro:if>', LIMIT, {}),
    ("the sum of a range", value("python.sum(range(10**12))"), LIMIT, {}),
    ("comprehensions in each other", value("[1 for a in range(10**4) for b in range(10**4) for c in range(10**4)]"), LIMIT, {}),
    ("comprehensions that keep nothing", value("[1 for a in range(10**5) for b in range(10**5) if False]"), LIMIT, {}),
    ("a lambda that calls itself", value("(lambda f: f(f))(lambda f: f(f))"), LIMIT, {}),
    ("a lambda that doubles", value("(lambda f: f(f, 40))(lambda f, n: f(f, n-1) + f(f, n-1) if n else 1)"), LIMIT, {}),
    ("map in map", value("list(map(lambda x: list(map(lambda y: list(range(10**5)), range(10**5))), range(10**5)))"), LIMIT, {}),
    ("sorting without end", value("[python.sorted(range(10**5)) for i in range(10**5)]"), LIMIT, {}),
    ("a wide format", value("'%1000000000d' % 1"), b"SML33", {}),
    ("a wide field", value("'{:1000000000}'.format(1)"), b"SML33", {}),
    ("many decimals", value("'%.1000000000f' % 1"), b"SML33", {}),
    ("a wide column", value("'a'.center(10**12)"), LIMIT, {}),
    ("wide tabs", value("'\\t'.expandtabs(10**12)"), LIMIT, {}),
    ("replacements that grow", value("('a'*10**5).replace('a', 'b'*10**5)"), LIMIT, {}),
    ("joining", value("('a'*10**5).join(['b']*10**5)"), LIMIT, {}),
    ("repr of a list that shares", chain(60, "${[@, @, @, @]}", "x"), LIMIT, {}),
    ("equality of lists that share", chain(60, "${[@, @, @, @]}", "x", "p59 == p59 + []") + value("p59 == p58 + []"), LIMIT, {}),
    ("comparison of lists that share", chain(60, "${[@, @, @, @]}", "x", "1") + chain(60, "${[@, @, @, @]}", "x", "1").replace('"p', '"q').replace("[p", "[q")
     .replace(" p", " q") + value("p59 == q59"), LIMIT, {}),
    ("the place of a list that shares", chain(60, "${[@, @, @, @]}", "x", "1") + chain(60, "${[@, @, @, @]}", "x", "1").replace('"p', '"q').replace("[p", "[q")
     .replace(" p", " q") + value("[p59].index(q59)"), LIMIT, {}),
    ("keys that share", chain(60, "${(@, @, @, @)}", "x", "dict([(p59, 1)])"), b"SML33", {}),
    ("texts that double", chain(60, "${@ + @}", "xx"), LIMIT, {}),
    ("texts that double in words", chain(60, "${@}${@}", "xx"), LIMIT, {}),
    ("integers that square", chain(60, "${@ * @}", "12345678901"), LIMIT, {}),
    ("properties of each other", chain(5000, "${@}", "x"), LIMIT, {}),
    ("a list that grows", recursion("", '<xacro:property name="q" value="${[l.extend(l + [1])]}" lazy_eval="false"/><xacro:m/>',
                                    '<xacro:property name="l" value="${[1]}"/><xacro:m/>'), LIMIT, {}),
    ("a list in itself", '<xacro:property name="l" value="${[1]}"/>' + value("[l.append(l), l]"), b"SML3304", {}),
    ("brackets", value("(" * 50_000 + ")" * 50_000), b"SML33", {}),
    ("square brackets", value("[" * 50_000), b"SML33", {}),
    ("signs", value("-" * 100_000 + "1"), b"SML33", {}),
    ("nots", value("not " * 50_000 + "1"), b"SML33", {}),
    ("conditions", value("1 if 1 else " * 50_000 + "1"), b"SML33", {}),
    ("lambdas", value("lambda: " * 50_000 + "1"), b"SML33", {}),
    ("powers", value("1**" * 50_000 + "1"), b"SML33", {}),
    ("attributes", value("x" + ".x" * 100_000), b"SML33", {}),
    ("indices", value("x" + "[0]" * 50_000), b"SML33", {}),
    ("many dollars", f'<link name="{"$" * 500_000}"/>', b"SML33", {}),
    ("many openings", f'<link name="{"${" * 100_000}"/>', b"SML33", {}),
    ("macros that call the next twice", doubling(40), LIMIT, {}),
    ("macros that call the next twice with empty bodies", doubling(200, "<xacro:m{}/><xacro:m{}/>").replace("<b/>", ""), LIMIT, {}),
    ("conditions in macros", doubling(40, '<xacro:if value="1"><xacro:m{}/></xacro:if><xacro:unless value="0"><xacro:m{}/></xacro:unless>'), LIMIT, {}),
    ("a macro that calls itself", recursion("", "<xacro:m/>", "<xacro:m/>"), LIMIT, {}),
    ("a macro that calls itself twice", recursion("", "<xacro:m/><xacro:m/>", "<xacro:m/>"), LIMIT, {}),
    ("a macro that calls itself with more", recursion("x", '<xacro:m x="${x + x}"/>', '<xacro:m x="ab"/>'), LIMIT, {}),
    ("a macro that passes its block on", recursion("*b", '<xacro:m><c><xacro:insert_block name="b"/><xacro:insert_block name="b"/></c></xacro:m>',
                                                   "<xacro:m><c/></xacro:m>"), LIMIT, {}),
    ("blocks in blocks", "".join(f'<xacro:property name="b{i + 1}"><c><xacro:insert_block name="b{i}"/><xacro:insert_block name="b{i}"/></c></xacro:property>'
                                 for i in range(60)) + '<xacro:property name="b0"><c/></xacro:property><xacro:insert_block name="b60"/>', LIMIT, {}),
    ("a block of itself", '<xacro:property name="b"><xacro:insert_block name="b"/></xacro:property><xacro:insert_block name="b"/>', LIMIT, {}),
    ("a call of a call", '<xacro:call macro="call"/>', b"SML33", {}),
    ("an element that renames itself", '<xacro:element xacro:name="xacro:element"/>', b"SML33", {}),
    ("a property of itself", '<xacro:property name="p" value="${p}"/>' + value("p"), b"SML3316", {}),
    ("an argument of itself", '<xacro:arg name="q" default="$(arg q)"/>', b"SML33", {}),
    ("an include of itself", '<xacro:include filename="robot.xacro"/>', b"SML33", {}),
    ("eight includes of itself in a package", '<xacro:include filename="robot.xacro"/>' * 8, b"SML33",
     {"package.xml": "<package><name>p</name><export><build_type>ament_cmake</build_type></export></package>",
      "launch/robot.launch.py": "from launch import LaunchDescription\n"}),
    ("an include of each other", '<xacro:include filename="b.xacro"/>', b"SML33",
     {"b.xacro": ROBOT.format('<xacro:include filename="robot.xacro"/>')}),
    ("an include of itself by a pattern", '<xacro:include filename="*.xacro"/>', b"SML33", {}),
    ("two includes of the next", '<xacro:include filename="i0.xacro"/>', b"SML33",
     {f"i{i}.xacro": ROBOT.format(f'<xacro:include filename="i{i + 1}.xacro"/>' * 2) for i in range(40)}),
    ("a pattern with many stars", '<xacro:include filename="' + "*a" * 2000 + '*b"/>' + value("1/0"), b"SML", {"a" * 200 + ".xacro": ROBOT.format("")}),
    ("a list of YAML in lists", LOAD + value("d"), b"SML", {"d.yaml": yaml_bomb(12)}),
    ("YAML of many levels", LOAD + value("d"), b"SML", {"d.yaml": "[" * 100_000}),
    ("YAML with a large number", LOAD + value("d"), b"SML33", {"d.yaml": "!degrees 10**10**10"}),
    ("YAML that merges itself", LOAD + value("d"), b"SML", {"d.yaml": "a: &a {<<: *a}"}),
    ("code in YAML", LOAD + value("d"), b"SML33", {"d.yaml": "!!python/object/apply:os.system [touch stolen]"}),
    ("a file outside", value("xacro.load_yaml('../../../secret.yaml')"), b"SML", {}),
    ("an absolute file", value("xacro.load_yaml('@/secret.yaml')"), b"SML", {}),
    ("an include outside", '<xacro:include filename="../../../secret.xacro"/>', b"SML", {}),
    ("a pattern outside", '<xacro:include filename="../../../*.xacro"/><xacro:include filename="/et[c]/passw[d]"/>' + value("secret"), b"SML", {}),
    ("a pattern that walks out", '<xacro:include filename="*/../../../../*.xacro"/>' + value("secret"), b"SML", {"s/t.xacro": ROBOT.format("")}),
    ("the environment", '<link name="$(env TOKEN)"/>', b"SML3317", {}),
    ("the environment by eval", "<link name=\"$(eval env('TOKEN')\"/>", b"SML33", {}),
    ("the environment, perhaps", '<link name="$(optenv TOKEN none)"/>' + value("1/0"), b"SML33", {}),
    ("a package outside", '<link name="$(find ../..)"/>', b"SML33", {}),
    ("a program", value("().__class__.__base__.__subclasses__()"), b"SML33", {}),
    ("a program in a comprehension", value("[c.__init__.__globals__ for c in [1]]"), b"SML33", {}),
    ("a program in a lambda", value("(lambda: open('stolen', 'w'))()"), b"SML33", {}),
    ("a program by eval", "<link name=\"$(eval open('stolen','w')\"/>", b"SML33", {}),
    ("a format that reaches in", value("'{0.__class__}'.format(1)"), b"SML33", {}),
]


def check(tool, bomb, place):
    title, document, rule, files = bomb
    work = place / "far/below/work"
    (work / "out").mkdir(parents=True)
    (work / ".git").mkdir()  # the end of the project, wherever temporary files are
    (place / "secret.yaml").write_text(SECRET)
    (place / "secret.xacro").write_text(ROBOT.format(f'<xacro:property name="secret" value="{SECRET}"/>'))
    for name, text in {"robot.xacro": ROBOT.format(document.replace("@/", f"{place}/")), **files}.items():
        (work / name).parent.mkdir(exist_ok=True)
        (work / name).write_text(text)
    case = inputs.Case(title, {}, "robot.xacro", codes=(1,))
    found, run = hostile_cli_test.faults(tool.parent, case, lambda: cost.Run([f"TOKEN={SECRET}", tool, "robot.xacro"], work), work)
    yield from found
    if rule not in run.said:
        yield f"did not report {rule.decode()}, but {run.said[:200]}"
    if SECRET.encode() in run.said:
        yield "printed the secret"
    if (work / "stolen").exists():
        yield "ran code"


def main():
    tools = pathlib.Path(sys.argv[1]).resolve()
    failures = []
    with tempfile.TemporaryDirectory(prefix="smurf-bombs-") as folder:
        for tool in ("smurf2urdf", "smurf-lint"):
            for bomb in BOMBS:
                place = pathlib.Path(folder) / "bomb"
                failures += [f"{tool}: {bomb[0]}: {fault}" for fault in check(tools / tool, bomb, place)]
                shutil.rmtree(place)
    print("\n".join(failures))
    print(f"{len(BOMBS)} files, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
