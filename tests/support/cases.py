# SPDX-License-Identifier: BSD-3-Clause
"""Runs the tools in one process (cases.cpp), for tests with thousands of cases.

    with cases.Cases(program) as tools:
        done = tools.run("smurf-lint", "--format", "json", path, cwd=folder)

The result has the members of subprocess.CompletedProcess, with text in its streams. A case that ends the process, or takes
longer than two minutes, ends the test and is named.
"""
import os
import pathlib
import subprocess
import sys

NOT_INHERITED = ("NO_COLOR", "FORCE_COLOR", "TERM", "GITHUB_ACTIONS")


class Cases:
    def __init__(self, program):
        self.last_words = os.memfd_create("stderr")
        variables = {name: value for name, value in os.environ.items() if name not in NOT_INHERITED}
        self.process = subprocess.Popen([pathlib.Path(program).resolve()], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=self.last_words, env=variables)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        code = self.process.wait()
        words = os.pread(self.last_words, 1 << 20, 0).decode("utf-8", "replace") if code else ""
        os.close(self.last_words)
        if code:
            sys.exit(f"{self.process.args[0]} ended with {code}\n{words}")

    def run(self, *command, cwd=None, stdin=b""):
        folder = cwd or os.getcwd()
        request = b"".join(os.fsencode(part) + b"\0" for part in (folder, *command))
        try:
            self.process.stdin.write(b"%d %d\n" % (len(request), len(stdin)) + request + stdin)
            self.process.stdin.flush()
            code, *sizes = map(int, self.process.stdout.readline().split())
            texts = [self.process.stdout.read(size).decode("utf-8", "replace") for size in sizes]
            return subprocess.CompletedProcess(command, code, *texts)
        except (BrokenPipeError, ValueError):
            words = os.pread(self.last_words, 1 << 20, 0).decode("utf-8", "replace")
            sys.exit(f"ended with {self.process.wait()} in {folder}: {' '.join(map(str, command))}\n{words}")


class Folder:
    """Has the files of one case at a time. Writes only what differs, because most files of two cases are equal."""

    def __init__(self, path):
        self.path, self.files = pathlib.Path(path).resolve(), {}

    def become(self, files):
        """`files` are texts or bytes by path."""
        for name in self.files.keys() - files.keys():
            self.remove(self.path / name)
        for name, content in files.items():
            if self.files.get(name) != content:
                (self.path / name).parent.mkdir(parents=True, exist_ok=True)
                data = content if isinstance(content, bytes) else content.encode(errors="surrogateescape")
                (self.path / name).write_bytes(data)
        self.files = dict(files)

    def remove(self, path):
        path.unlink()
        while path.parent != self.path and not any(path.parent.iterdir()):
            path = path.parent
            path.rmdir()
