# SPDX-License-Identifier: BSD-3-Clause
"""In Chromium, the npm package finds in every fixture and in every repository of the corpus what the native smurf-lint finds.

usage: browser_test.py FOLDER_OF_TOOLS PACKAGE [CORPUS]
"""
import base64
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

from built import skip_without

FIXTURES = pathlib.Path(__file__).resolve().parent.parent.parent / "build/fixtures"
TIME = 1200  # s
PAGE = """<!doctype html><script type="module">
const results = [];
try {
  const { run } = await import("/index.mjs");
  for (let job = 0, count = await (await fetch("/jobs")).json(); job < count; ++job) {
    const { args, files } = await (await fetch("/jobs/" + job)).json();
    const decoded = Object.entries(files).map(([name, text]) => [name, Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]);
    const { code, stdout, stderr } = await run("smurf-lint", args, Object.fromEntries(decoded));
    results.push([code, stdout, stderr]);
  }
} catch (error) {
  results.push(String(error?.stack ?? error));
}
await fetch("/results", { method: "POST", body: JSON.stringify(results) });
</script>"""
TYPES = {".mjs": "text/javascript", ".wasm": "application/wasm"}


def files_of(folders, root):
    return {str(path.relative_to(root)): base64.b64encode(path.read_bytes()).decode()
            for folder in folders for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink()}


def jobs(corpus):
    folders = [folder for kind in ("rules/*/*", "models/*", "load-check/*") for folder in sorted(FIXTURES.glob(kind))]
    if corpus is None:
        print("there is no corpus; only the fixtures are compared")
    else:
        folders += sorted(corpus.glob("*/*"))
    for folder in folders:
        files = files_of([folder], folder)
        has_links = any(path.is_symlink() for path in folder.rglob("*"))
        if folder.is_dir() and not has_links and all(not name.startswith("..") for name in files):
            yield folder, {"args": ["--format=json", "--all", "."], "files": files}
    for scene in sorted((FIXTURES / "scenes").iterdir()):  # scenes use the models
        yield FIXTURES, {"args": ["--format=json", "--all", f"scenes/{scene.name}"],
                         "files": files_of([scene, FIXTURES / "models"], FIXTURES)}


class Site(http.server.BaseHTTPRequestHandler):
    package = page_jobs = results = None
    is_done = threading.Event()

    def do_GET(self):
        path = Site.package / self.path.strip("/")
        if self.path == "/":
            self.answer("text/html", PAGE.encode())
        elif self.path == "/jobs":
            self.answer("application/json", str(len(Site.page_jobs)).encode())
        elif self.path.startswith("/jobs/"):
            self.answer("application/json", json.dumps(Site.page_jobs[int(self.path.removeprefix("/jobs/"))]).encode())
        elif path.is_file():
            self.answer(TYPES.get(path.suffix, "text/plain"), path.read_bytes())
        else:
            self.send_error(404)

    def do_POST(self):
        Site.results = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.answer("text/plain", b"")
        Site.is_done.set()

    def answer(self, kind, data):
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, *_):
        pass


def main():
    tools, package = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    skip_without(tools, package)
    browser = shutil.which("chromium")
    if browser is None:
        print("skipped: there is no chromium")
        sys.exit(77)
    corpus = pathlib.Path(sys.argv[3]).resolve() if len(sys.argv) > 3 and (pathlib.Path(sys.argv[3]) / "MANIFEST.tsv").is_file() else None
    all_jobs = list(jobs(corpus))
    Site.package = package
    Site.page_jobs = [job for _, job in all_jobs]
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Site)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(prefix="smurf-browser-", ignore_cleanup_errors=True) as home:
        process = subprocess.Popen([browser, "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={home}",
                                    "http://{}:{}/".format(*server.server_address)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        is_done = Site.is_done.wait(TIME)
        process.terminate()
        process.wait()
    if not is_done or len(Site.results) != len(all_jobs):
        sys.exit(f"the page did not come to its end: {(Site.results or ['no answer'])[-1]}")
    different = 0
    for (folder, job), result in zip(all_jobs, Site.results):
        done = subprocess.run([tools / "smurf-lint", *job["args"]], cwd=folder, capture_output=True, check=False)
        native = [done.returncode, done.stdout.decode(), done.stderr.decode()]
        if native != result:
            different += 1
            print(f"{folder} {job['args']} differs:\n{str(native)[:2000]}\n{str(result)[:2000]}" if different < 5 else folder)
    print(f"{len(all_jobs) - different} of {len(all_jobs)} folders give the same findings")
    sys.exit(different > 0)


main()
