# SPDX-License-Identifier: BSD-3-Clause
"""A small and strict client of smurf-lsp over real standard streams."""
import json
import pathlib
import queue
import subprocess
import threading
import urllib.parse


def uri(path):
    return "file://" + urllib.parse.quote(str(path))


def path_of(address):
    assert address.startswith("file://"), address
    return urllib.parse.unquote(address[len("file://"):])


class RequestError(Exception):
    def __init__(self, error):
        super().__init__(error["message"])
        self.code = error["code"]


class Client:
    """Starts a server. `capabilities` are those of the client."""

    def __init__(self, tool, folders=(), capabilities=None, options=None, arguments=(), cwd=None):
        self.process = subprocess.Popen([str(tool), *arguments], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, cwd=cwd)
        self.inbox = queue.Queue()
        self.notifications = []  # (method, params), in order
        self.requests = []  # of the server
        self.answers = {}  # by request, of those that nobody has asked for yet
        self.seen = []  # every message, for who validates them
        self.stderr = b""
        self.threads = [threading.Thread(target=run, daemon=True) for run in (self._read, self._drain)]
        for thread in self.threads:
            thread.start()
        self.last_id = 0
        self.versions = {}
        self.texts = {}
        self.diagnostics = {}  # by path, as last published
        self.initialized = self.request("initialize", {
            "processId": None, "rootUri": uri(folders[0]) if folders else None,
            "workspaceFolders": [{"uri": uri(one), "name": pathlib.Path(one).name} for one in folders] or None,
            "capabilities": capabilities or {}, "initializationOptions": options})
        self.notify("initialized", {})

    def _drain(self):
        for line in self.process.stderr:
            self.stderr += line

    def _read(self):
        stream = self.process.stdout
        while True:
            length = None
            while (line := stream.readline()) not in (b"\r\n", b""):
                name, value = line.decode("ascii").split(":")
                if name.lower() == "content-length":
                    length = int(value)
            if length is None:
                self.inbox.put(None)
                return
            self.inbox.put(json.loads(stream.read(length)))

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        content = json.dumps(message).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n%b" % (len(content), content))

    def notify(self, method, params):
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def _take(self, timeout):
        message = self.inbox.get(timeout=timeout)
        if message is None:
            raise EOFError(f"the server ended with {self.process.wait()}: {self.stderr.decode(errors='replace')}")
        self.seen.append(message)
        if "method" in message and "id" in message:
            self.requests.append(message)
            self.send({"jsonrpc": "2.0", "id": message["id"], "result": None})
        elif "method" not in message:
            self.answers[message.get("id")] = message
        else:
            self.notifications.append((message["method"], message["params"]))
            if message["method"] == "textDocument/publishDiagnostics":
                self.diagnostics[path_of(message["params"]["uri"])] = message["params"]
        return message

    def begin(self, method, params):
        self.last_id += 1
        self.send({"jsonrpc": "2.0", "id": self.last_id, "method": method, "params": params})
        return self.last_id

    def answer(self, request, timeout=600):
        while request not in self.answers:
            self._take(timeout)
        message = self.answers.pop(request)
        if "error" in message:
            raise RequestError(message["error"])
        return message["result"]

    def request(self, method, params, timeout=600):
        return self.answer(self.begin(method, params), timeout)

    def open(self, path, text=None, language="yaml"):
        path = str(path)
        self.texts[path] = pathlib.Path(path).read_bytes().decode("utf-8", "replace") if text is None else text
        self.versions[path] = 1
        self.notify("textDocument/didOpen", {"textDocument": {
            "uri": uri(path), "languageId": language, "version": 1, "text": self.texts[path]}})

    def change(self, path, changes):
        path = str(path)
        self.versions[path] += 1
        self.notify("textDocument/didChange", {
            "textDocument": {"uri": uri(path), "version": self.versions[path]}, "contentChanges": changes})

    def replace(self, path, text):
        self.texts[str(path)] = text
        self.change(path, [{"text": text}])

    def edit(self, path, begin, end, text):
        """Replaces characters of the server's text."""
        path = str(path)
        old = self.texts[path]
        self.texts[path] = old[:begin] + text + old[end:]
        self.change(path, [{"range": {"start": position(old, begin), "end": position(old, end)}, "text": text}])

    def close(self, path):
        self.notify("textDocument/didClose", {"textDocument": {"uri": uri(path)}})

    def at(self, method, path, offset, **more):
        """A request about a place in a document."""
        return self.request(method, {"textDocument": {"uri": uri(path)},
                                     "position": position(self.texts[str(path)], offset), **more})

    def of(self, method, path, **more):
        return self.request(method, {"textDocument": {"uri": uri(path)}, **more})

    def published(self, path, timeout=600):
        """The findings of the current version of a document."""
        path = str(path)
        while self.diagnostics.get(path, {}).get("version") != self.versions[path]:
            self._take(timeout)
        return self.diagnostics[path]["diagnostics"]

    def stop(self):
        self.request("shutdown", None)
        self.notify("exit", None)
        self.process.stdin.close()
        return self.process.wait(timeout=600)

    def end(self):
        """Whatever happened before."""
        self.process.kill()
        self.process.wait()
        for thread in self.threads:
            thread.join()
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            stream.close()


def position(text, offset):
    """In UTF-16, the default of the protocol."""
    before = text[:offset].split("\n")
    return {"line": len(before) - 1, "character": len(before[-1].encode("utf-16-le")) // 2}


def offset(text, place):
    lines = text.split("\n")
    begin = sum(len(line) + 1 for line in lines[:place["line"]])
    if place["line"] >= len(lines):
        return len(text)
    line = lines[place["line"]].encode("utf-16-le")[:2 * place["character"]]
    return begin + len(line.decode("utf-16-le", "ignore"))


def text_in(text, span):
    return text[offset(text, span["start"]):offset(text, span["end"])]


def apply(text, edits):
    """The text after edits of the protocol, all of which refer to the original text."""
    for edit in sorted(edits, key=lambda one: offset(text, one["range"]["start"]), reverse=True):
        begin, end = (offset(text, edit["range"][side]) for side in ("start", "end"))
        text = text[:begin] + edit["newText"] + text[end:]
    return text
