# SPDX-License-Identifier: BSD-3-Clause
"""Reports as plain values: what their pickles become, and the records of check_each()."""
from __future__ import annotations

import json
import os
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import asdict, dataclass, fields
from importlib import import_module
from itertools import islice
from typing import Any, Deque, Dict, List, Tuple
from warnings import warn


@dataclass(frozen=True)
class PlainPlace:
    """A smurf.Place: lines and columns (characters) from 1; the end is exclusive."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}:{self.column}"


@dataclass(frozen=True)
class PlainFinding:
    """A smurf.Finding without the texts of the files."""

    id: str
    name: str
    severity: str
    message: str
    help: str
    notes: List[str]
    pointer: str
    place: PlainPlace
    labels: List[Tuple[PlainPlace, str]]
    fix: Dict[str, Any] | None
    line: str  # that of the concise report

    def __str__(self) -> str:
        return self.line


@dataclass(frozen=True)
class PlainVerdict:
    """A smurf.TargetVerdict."""

    target: str
    answer: str
    refusals: int
    losses: int
    unknown: int


@dataclass(frozen=True)
class PlainReport:
    """A smurf.Report without the texts of the files, so that it cannot make fixed ones."""

    findings: List[PlainFinding]
    errors: int
    warnings: int
    infos: int
    suppressed: int
    targets: List[PlainVerdict]

    def __len__(self) -> int:
        return len(self.findings)

    def __iter__(self) -> Iterator[PlainFinding]:
        return iter(self.findings)

    def __getitem__(self, index: int) -> PlainFinding:
        return self.findings[index]


@dataclass(frozen=True)
class CheckRecord:
    """What check_each() says about one robot or scene. Every value is plain: it can be pickled, and
    `dataclasses.asdict()` makes a line of JSON of it.
    """

    path: str
    ok: bool  # without an error
    loads: Dict[str, str]  # what each target does: "takes", "loses", "unknown" or "refuses"
    counts: Dict[str, int]  # of errors, warnings, infos, and of what is suppressed
    findings: List[PlainFinding]
    digest: str  # of the bytes of the file, as `b2sum --length 256` prints it; "" if it could not be read
    links: int | None  # of a robot that could be read
    mass: float | None  # kg: the sum of all masses that its links state


def same(one: Any) -> Any:
    """What a pickle of a part of a report calls."""
    return one


def plain_place(one: Any) -> PlainPlace:
    return PlainPlace(one.file, one.line, one.column, one.end_line, one.end_column)


def plain_finding(one: Any) -> PlainFinding:
    return PlainFinding(
        one.id, one.name, one.severity, one.message, one.help, one.notes, one.pointer, plain_place(one.place),
        [(plain_place(place), text) for place, text in one.labels], one.fix, str(one))


def plain_verdict(one: Any) -> PlainVerdict:
    return PlainVerdict(one.target, one.answer, one.refusals, one.losses, one.unknown)


def plain_report(one: Any) -> PlainReport:
    return PlainReport(
        [plain_finding(finding) for finding in one.findings], one.errors, one.warnings, one.infos, one.suppressed,
        [plain_verdict(verdict) for verdict in one.targets])


def _record(path: str, report: Any, digest: str, size: Tuple[int, float] | None) -> CheckRecord:
    counts = {"errors": report.errors, "warnings": report.warnings, "infos": report.infos,
              "suppressed": report.suppressed}
    return CheckRecord(path, report.errors == 0, {verdict.target: verdict.answer for verdict in report.targets},
                       counts, [plain_finding(finding) for finding in report], digest, *(size or (None, None)))


_CLASSES = (CheckRecord, PlainFinding, PlainPlace)
_FORM = "python 1 " + " ".join(field.name for one in _CLASSES for field in fields(one))


def _read_record(text: bytes) -> CheckRecord | None:
    """What `json.dumps(asdict(record))` has written; None for null, a part of robots."""
    data = json.loads(text)
    if data is None:
        return None
    for finding in data["findings"]:
        finding["place"] = PlainPlace(**finding["place"])
        finding["labels"] = [(PlainPlace(**place), message) for place, message in finding["labels"]]
    data["findings"] = [PlainFinding(**finding) for finding in data["findings"]]
    return CheckRecord(**data)


def check_each(paths: Any, *, jobs: int | None = None, skip: Iterable[str] = (), cache: Any = None,
               **settings: Any) -> Iterator[CheckRecord]:
    """Checks each robot and scene of files and folders by itself, and yields a smurf.CheckRecord for each, in the
    order of their paths and as soon as it is known.

        for record in smurf.check_each("robots/", targets=["mujoco"]):
            if record.loads["mujoco"] == "refuses":
                print(record.path, *record.findings, sep="\\n  ")

    Memory does not grow with the number of robots. A robot has the findings of `smurf.check(path)`; what only the
    whole folder shows, such as companion files that no robot has, is what `smurf.check(folder)` reports. A xacro
    file in a folder that is only a part of robots has no record. `jobs` is the number of threads (default: one
    for each processor), `skip` are paths of records that are there already; `settings` are those of smurf.check().
    `cache` is a folder in which the records are kept: of them, only those are made again on which a change of files,
    settings or the version may have an influence. Where it cannot be written, there is a warning.
    Raises smurf.Error at once for a path that cannot be read.
    """
    from ._smurf import _plan_each

    if jobs is None:
        jobs = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if jobs < 1:
        raise ValueError(f"jobs must be 1 or more, and not {jobs}")
    plan = _plan_each(paths, **settings)
    if cache is not None:
        plan.use_cache(cache, _FORM)
    return _records(plan, jobs, frozenset(skip), cache is not None)


def check_batches(paths: Any, *, size: int = 1024, jobs: int | None = None, skip: Iterable[str] = (),
                  cache: Any = None, **settings: Any) -> Iterator[Any]:
    """What check_each() yields, as `pyarrow.RecordBatch` of `size` robots each: for tables of Arrow, Parquet, DuckDB
    and Polars. Columns: `path`, `ok`, `loads_TARGET` for each target, `errors`, `warnings`, `infos`, `suppressed`,
    `digest`, `links`, `mass`, and `findings`, a list of structs with `id`, `severity`, `message`, `file`, `line` and
    `column`. Needs pyarrow.
    """
    pyarrow = import_module("pyarrow")
    if size < 1:
        raise ValueError(f"size must be 1 or more, and not {size}")
    records = check_each(paths, jobs=jobs, skip=skip, cache=cache, **settings)
    finding = pyarrow.struct([
        ("id", pyarrow.string()), ("severity", pyarrow.string()), ("message", pyarrow.string()),
        ("file", pyarrow.string()), ("line", pyarrow.int64()), ("column", pyarrow.int64())])
    counts = ("errors", "warnings", "infos", "suppressed")

    def batches() -> Iterator[Any]:
        while rows := list(islice(records, size)):
            columns = {"path": pyarrow.array([row.path for row in rows]), "ok": pyarrow.array([row.ok for row in rows])}
            for target in rows[0].loads:
                columns[f"loads_{target}"] = pyarrow.array([row.loads[target] for row in rows])
            for count in counts:
                columns[count] = pyarrow.array([row.counts[count] for row in rows], pyarrow.int64())
            for name, of_type in (("digest", pyarrow.string()), ("links", pyarrow.int64()), ("mass", pyarrow.float64())):
                columns[name] = pyarrow.array([getattr(row, name) for row in rows], of_type)
            columns["findings"] = pyarrow.array(
                [[{"id": one.id, "severity": one.severity, "message": one.message, "file": one.place.file,
                   "line": one.place.line, "column": one.place.column} for one in row.findings] for row in rows],
                pyarrow.list_(finding))
            yield pyarrow.RecordBatch.from_pydict(columns)

    return batches()


def _check(plan: Any, index: int, has_cache: bool) -> CheckRecord | None:
    one = plan.of(index)
    known = one.known()
    if known is not None:
        try:
            return _read_record(known)
        except (KeyError, TypeError, ValueError):  # somebody else has written it
            pass
    report = one.check()
    record = None if report is None else _record(plan.path(index), report, one.digest(), one.size())
    if has_cache:
        one.keep(json.dumps(record and asdict(record)))
    return record


def _records(plan: Any, jobs: int, skip: frozenset[str], has_cache: bool) -> Iterator[CheckRecord]:
    left = (index for index in range(len(plan)) if plan.path(index) not in skip)
    waiting: Deque[Future[CheckRecord | None]] = deque()
    with ThreadPoolExecutor(jobs) as threads:
        try:
            while True:
                waiting.extend(threads.submit(_check, plan, index, has_cache)
                               for index in islice(left, 4 * jobs - len(waiting)))
                if not waiting:
                    break
                record = waiting.popleft().result()
                if record is not None:
                    yield record
        finally:
            for one in waiting:
                one.cancel()
    if problem := plan.cache_problem():
        warn(f"cache: {problem}; the records are complete without it", RuntimeWarning, stacklevel=2)
