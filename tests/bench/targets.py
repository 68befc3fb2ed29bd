#!/usr/bin/env python3
"""The table of performance targets, measured now: targets.py BIN [--quick]

Processor time of whole processes, the best of several interleaved runs, so that what else the machine
does matters little; what counts is the ratio to a peer in the same run. Peers that no package offers
are taken from the environment and skipped without it: SMURF_BENCH_PHOBOS and SMURF_BENCH_SMURF_PARSER
are commands that load the .smurf file given as their last argument.

Exit code 1 when a floor does not hold.
"""
import json
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
PYTHON_PEER = """
import sys, yaml
from lxml import etree
for path in sys.argv[1:]:
    if path.endswith('.urdf'):
        etree.parse(path)
    else:
        yaml.load(open(path, encoding='utf-8'), Loader=yaml.SafeLoader)
"""
PYTHON = "/usr/bin/python3"  # Debian's, which has the packages
HELLO = '#include <iostream>\nint main() { std::cout << "hello\\n"; }\n'


class Run:
    """Processor time (s), wall time (s) and peak memory (bytes) of one process."""

    def __init__(self, command, **kwargs):
        start = time.perf_counter()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **kwargs)
        _, status, usage = os.wait4(process.pid, 0)
        self.wall = time.perf_counter() - start
        self.cpu = usage.ru_utime + usage.ru_stime
        self.memory = usage.ru_maxrss * 1024
        self.code = os.waitstatus_to_exitcode(status)


def best(commands: list, rounds: int) -> list:
    """The fastest run of each command, with the commands taking turns. Short commands are run more often, because a
    long run of another command changes caches and memory."""
    fastest = [Run(command) for command in commands]
    longest = max(run.cpu for run in fastest)
    for _ in range(rounds):
        for i, command in enumerate(commands):
            times = max(1, min(5, round(longest / max(fastest[i].cpu, 1e-4))))
            fastest[i] = min(fastest[i], *(Run(command) for _ in range(times)), key=lambda run: run.cpu)
    return fastest


def instructions(command: list):
    """Instructions of the whole process, counted by callgrind; none if valgrind is not installed."""
    try:
        done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command],
                              capture_output=True, text=True)
    except FileNotFoundError:
        return None
    counts = [line.rsplit(":", 1)[1] for line in done.stderr.splitlines() if "I   refs" in line or "Collected" in line]
    return int(counts[-1].replace(",", "")) if counts else None


def exponent(sizes: list, costs: list) -> float:
    return math.log(costs[-1] / costs[0]) / math.log(sizes[-1] / sizes[0])


class Bench:
    def __init__(self, binaries: pathlib.Path, work: pathlib.Path, quick: bool):
        self.lint = str(binaries / "smurf-lint")
        self.pieces = binaries / "pieces"
        self.work = work
        self.quick = quick
        self.rows = []

    def generate(self, kind: str, size: int, *shape: str) -> pathlib.Path:
        folder = self.work / "-".join([kind, str(size), *shape])
        if not folder.exists():
            subprocess.run([sys.executable, HERE / "generate.py", kind, str(size), folder, *shape], check=True)
        return folder

    def model(self, links: int, *shape: str) -> str:
        return str(self.generate("model", links, *shape) / "smurf/m.smurf")

    def row(self, name: str, what: str, figure, floor, goal, at_least: bool = True, digits: int = 2):
        """`figure` may be a text with the reason why there is none."""
        if isinstance(figure, str):
            self.rows.append((name, what, figure, floor, goal, "-"))
            return
        holds = lambda bound: bound is None or (figure >= bound if at_least else figure <= bound)
        verdict = "FLOOR BROKEN" if not holds(floor) else "goal" if holds(goal) else "floor"
        self.rows.append((name, what, f"{figure:.{digits}f}", floor, goal, verdict))

    def ratio(self, name: str, what: str, peer: list, ours: list, floor: float, goal: float, rounds: int):
        a, b = best([peer, ours], rounds)
        if a.code != 0:
            self.row(name, what, "the peer failed", floor, goal)
        else:
            self.row(name, what, a.cpu / b.cpu, floor, goal)

    def against_environment(self, name: str, what: str, variable: str, links: int, floor: float, goal: float):
        command = os.environ.get(variable)
        if not command:
            self.row(name, what, f"no {variable}", floor, goal)
            return
        model = self.model(links)
        self.ratio(name, what, [*shlex.split(command), model], [self.lint, model], floor, goal, 5)

    def run(self):
        small, large = self.model(42), self.model(4200)
        large_folder = pathlib.Path(large).parent.parent
        large_files = [str(path) for path in sorted(large_folder.rglob("*.*"))]
        self.against_environment("T1", "Phobos load / lint, 420 links", "SMURF_BENCH_PHOBOS", 420, 30, 200)
        self.ratio("T2", "PyYAML + lxml / lint, 4,200 links", [PYTHON, "-c", PYTHON_PEER, *large_files],
                   [self.lint, large], 10, 60, 1 if self.quick else 3)
        self.against_environment("T3", "smurf_parser / lint, 42 links", "SMURF_BENCH_SMURF_PARSER", 42, 1.8, 5)
        self.against_environment("T4", "smurf_parser / lint, 4,200 links", "SMURF_BENCH_SMURF_PARSER", 4200, 2.5, 12)
        self.measure_pieces(large_folder)
        self.measure_start_up()
        self.measure_memory()
        self.measure_growth()
        self.measure_threads()
        self.measure_hostile()
        count = instructions([self.lint, small])
        self.row("T13", "million instructions, lint of 42 links", count / 1e6 if count else "no valgrind", 85, 12,
                 at_least=False, digits=1)

    def measure_pieces(self, folder: pathlib.Path):
        done = subprocess.run([self.pieces, "--benchmark_format=json", "--benchmark_min_time=0.5"],
                              env={**os.environ, "SMURF_BENCH_MODEL": str(folder)}, capture_output=True, text=True)
        if done.returncode != 0:
            raise SystemExit(done.stderr)
        time_of = {row["name"]: row["cpu_time"] for row in json.loads(done.stdout)["benchmarks"]}
        self.row("T5", "urdfdom / URDF load with checks, 4,200 links",
                 time_of["urdf_urdfdom"] / time_of["urdf_load"], 3.5, 4.5)
        self.row("T6", "whole lint / load alone", time_of["model_load_and_lint"] / time_of["model_load"],
                 None, 1.5, at_least=False)
        self.row("T7", "yaml-cpp with tree / its bare events",
                 time_of["yaml_tree/yaml_cpp"] / time_of["yaml_yaml_cpp_events"], 1.1, None, at_least=False)
        self.row("-", "yaml-cpp with tree / scanner with tree",
                 time_of["yaml_tree/yaml_cpp"] / time_of["yaml_tree/scanner_first"], 1, None)

    def measure_start_up(self):
        (self.work / "hello.cpp").write_text(HELLO)
        hello = str(self.work / "hello")
        subprocess.run([os.environ.get("CXX", "c++"), "-O2", "-o", hello, self.work / "hello.cpp"], check=True)
        # One start is too short for the clock of rusage.
        loop = lambda command: ["sh", "-c", f"for i in $(seq 50); do {shlex.quote(command[0])} {' '.join(command[1:])}; done"]
        peer, ours = best([loop([hello]), loop([self.lint, "--version"])], 5)
        self.row("T8", "--version / a hello with iostream", ours.cpu / peer.cpu, 2, 1.5, at_least=False)

    def measure_memory(self):
        # The cost of each further byte: the kernel includes this script, the parent, in the peak of a small process.
        # Pages of 2 MB make single runs differ.
        sizes = (4200, 16800)
        models = [self.model(size) for size in sizes]
        peaks = [min(Run([self.lint, "-j", "1", model]).memory for _ in range(5)) for model in models]
        bytes_of = [sum(path.stat().st_size for path in pathlib.Path(model).parent.parent.rglob("*.*"))
                    for model in models]
        self.row("T9", "further peak memory / input, 4,200 to 16,800 links",
                 (peaks[1] - peaks[0]) / (bytes_of[1] - bytes_of[0]), 10, 7, at_least=False)

    def measure_growth(self):
        sizes = [1000, 4000] if self.quick else [1000, 4000, 16000]
        for shape in ("chain", "star"):
            costs = [best([[self.lint, self.model(size, shape)]], 5)[0] for size in sizes]
            self.row("T10", f"growth of time, {shape} of {sizes[0]} to {sizes[-1]} links",
                     exponent(sizes, [run.cpu for run in costs]), 1.25, 1.15, at_least=False)
            counts = [instructions([self.lint, self.model(size, shape)]) for size in sizes[:2]]
            self.row("T10", f"growth of instructions, {shape}",
                     exponent(sizes[:2], counts) if all(counts) else "no valgrind", 1.05, None, at_least=False)

    def measure_threads(self):
        folder = str(self.generate("many", 20 if self.quick else 200))
        runs = [[Run([self.lint, "-j", jobs, folder]) for jobs in ("1", "2")] for _ in range(9)]
        one, two = (min(row[i].wall for row in runs) for i in range(2))
        self.row("T11", "wall time of -j 1 / -j 2, many models", one / two, 1.5, 1.7)

    def measure_hostile(self):
        probes = {
            "brackets.yml": "a: " + "[" * 1_000_000,
            "depth.yml": "- " * 100_000,
            "bomb.yml": "a0: &a0 [x,x,x,x,x,x,x,x,x]\n" + "".join(
                f"a{i}: &a{i} [{','.join([f'*a{i - 1}'] * 9)}]\n" for i in range(1, 12)),
            "nul.yml": "motors:\n- name: a\0b\n",
            "utf8.yml": "motors:\n- name: \udcff\n",
            "attributes.urdf": "<robot " + " ".join(f"a{i}='1'" for i in range(16_000)) + "/>",
            "nested.urdf": "<a>" * 1_000_000,
            "entities.urdf": '<!DOCTYPE r [<!ENTITY a "&b;&b;"><!ENTITY b "&a;&a;">]><robot name="&a;"/>',
            "printf.urdf": "<robot name='%s%n%s%n'><link name='%n%n%n'/></robot>",
        }
        slowest, largest = 0.0, 0.0
        for name, text in probes.items():
            path = self.work / name
            path.write_bytes(text.encode("utf-8", "surrogateescape"))
            run = Run([self.lint, str(path)])
            if run.code not in (0, 1, 2):
                raise SystemExit(f"{name}: exit code {run.code}")
            slowest, largest = max(slowest, run.cpu), max(largest, run.memory / 1e6)
        self.row("T12", "slowest hostile probe, s", slowest, 2, 0.5, at_least=False)
        self.row("T12", "largest memory of a hostile probe, MB", largest, 300, None, at_least=False, digits=0)


def main() -> int:
    with tempfile.TemporaryDirectory() as work:
        bench = Bench(pathlib.Path(sys.argv[1]), pathlib.Path(work), "--quick" in sys.argv)
        bench.run()
    print(f"{'':4} {'target':48} {'today':>18} {'floor':>7} {'goal':>7}")
    for name, what, figure, *bounds, verdict in bench.rows:
        floor, goal = ("-" if bound is None else bound for bound in bounds)
        print(f"{name:4} {what:48} {figure:>18} {floor:>7} {goal:>7}  {verdict}")
    return 1 if any(row[-1] == "FLOOR BROKEN" for row in bench.rows) else 0


if __name__ == "__main__":
    sys.exit(main())
