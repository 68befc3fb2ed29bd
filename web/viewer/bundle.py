# SPDX-License-Identifier: BSD-3-Clause
"""Makes one page of the modules here and three.js: OUTPUT_FOLDER/viewer.html.

usage: bundle.py OUTPUT_FOLDER

Fetches three.js and the bundler esbuild from the npm registry (npm_config_registry names another one) into
OUTPUT_FOLDER/packages, once, and compares their sums with those below. Neither node nor npm is needed.
"""
import base64
import hashlib
import io
import os
import pathlib
import platform
import re
import subprocess
import sys
import tarfile
import urllib.request

HERE = pathlib.Path(__file__).parent
REGISTRY = os.environ.get("npm_config_registry", "https://registry.npmjs.org").rstrip("/")
THREE = ("three", "0.187.0",
         "Qiu7R+Cmh8CstZsY1uJOSWnVlfo7ZtNLV7mF8Jltk3LB3AtDu9cRZlcnRKkAk8Y4z6KKw35z7Y7Urd7jWY8etA==")
ESBUILD = {
    "x86_64": ("@esbuild/linux-x64", "0.28.2",
               "4xTZr1FUmSoQW4XIWmit3tzQrUTZM+N3P0XV8xROKYF50XfI7xeO90+1bZvNwxIufQ9hDQVRJH5YhgPVF8A/HQ=="),
    "aarch64": ("@esbuild/linux-arm64", "0.28.2",
                "pW4AC0P3it8c7do9MVM4p51FzHzdM/TZrerurgRcHJ2WTa1VQ1CIq18xncfpBJw4ojkiZZrKW2yIBWBP92j6Ug=="),
}
SECONDS = 60  # without an answer of the registry


def fetch(package, folder):
    """The folder of a package. Its last step is a rename, so that a folder with its final name is complete."""
    name, version, expected = package
    target = folder / name
    if (target / "package.json").is_file() and f'"version": "{version}"' in (target / "package.json").read_text():
        return target
    address = f"{REGISTRY}/{name}/-/{name.split('/')[-1]}-{version}.tgz"
    with urllib.request.urlopen(address, timeout=SECONDS) as answer:
        archive = answer.read()
    if base64.b64encode(hashlib.sha512(archive).digest()).decode() != expected:
        sys.exit(f"bundle.py: {address} is not the file that was expected: its sum differs")
    unpacked = folder / "unpacked"
    subprocess.run(["rm", "-rf", unpacked, target], check=True)
    with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
        tar.extractall(unpacked)
    target.parent.mkdir(parents=True, exist_ok=True)
    (unpacked / "package").rename(target)
    return target


def bundle(esbuild, packages, name, output):
    subprocess.run(
        [esbuild, HERE / name, f"--outfile={output}", "--bundle", "--minify", "--charset=ascii", "--format=iife",
         "--target=chrome110,firefox115,safari16", "--log-level=warning",
         "--legal-comments=none"],  # the page has the licence as a whole
        env={**os.environ, "NODE_PATH": str(packages.resolve())}, check=True)
    return output.read_text(encoding="ascii").rstrip()


def sum_of(text):
    """The content security policy of the page allows one script and one style, by these sums."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def make_page(script, style, licence):
    parts = {
        "<!-- @LICENCE@ -->": f"<!--\nthree.js, which is part of this page:\n\n{licence}\n-->",
        "@SCRIPT_HASH@": sum_of(script),
        "@STYLE_HASH@": sum_of(style),
        "<!-- @STYLE@ -->": f"<style>{style}</style>",
        "<!-- @SCRIPT@ -->":
            f'<script id="scene" type="application/json">@SCENE@</script>\n<script>{script}</script>',
    }
    page = (HERE / "index.html").read_text(encoding="utf-8")
    for mark, text in parts.items():
        page = page.replace(mark, text)
    if re.search("</script|<!--", script, re.I) or re.search("</style", style, re.I):
        sys.exit("bundle.py: the script or style ends its own element")
    if re.search(r"[^\x20-\x7e\n\t]", page):
        sys.exit("bundle.py: the page is not ASCII, which cmake/EmbedPage.cmake needs")
    if page.count("@SCENE@") != 1:
        sys.exit("bundle.py: the page needs exactly one place for the scene")
    return page


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if platform.system() != "Linux" or platform.machine() not in ESBUILD:
        sys.exit(f"bundle.py: no esbuild is known for {platform.system()} on {platform.machine()}")
    output = pathlib.Path(sys.argv[1])
    packages = output / "packages"
    packages.mkdir(parents=True, exist_ok=True)
    try:
        three = fetch(THREE, packages)
        esbuild = fetch(ESBUILD[platform.machine()], packages) / "bin/esbuild"
    except OSError as error:
        sys.exit(f"bundle.py: cannot fetch three.js and esbuild from {REGISTRY}: {error}")
    esbuild.chmod(0o755)
    licence = (three / "LICENSE").read_text(encoding="utf-8").strip().replace("\u00a9", "(c)")
    page = make_page(bundle(esbuild, packages, "main.js", output / "viewer.js"),
                     bundle(esbuild, packages, "style.css", output / "viewer.css"), licence)
    (output / "viewer.html").write_text(page, encoding="ascii")


if __name__ == "__main__":
    main()
