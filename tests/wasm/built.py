# SPDX-License-Identifier: BSD-3-Clause
"""Whether there is a package to test."""
import shutil
import sys


def skip_without(tools, package):
    """Ends with 77, which CTest shows as skipped, unless the package is there and not older than the native tools."""
    module = package / "smurf.wasm"
    if shutil.which("node") is None or shutil.which("npm") is None or not module.exists():
        print("skipped: scripts/wasm builds what is tested here")
        sys.exit(77)
    if module.stat().st_mtime < (tools / "smurf-lint").stat().st_mtime:
        print("skipped: the package is older than the native tools; scripts/wasm builds it again")
        sys.exit(77)
