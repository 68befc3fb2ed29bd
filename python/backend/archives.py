# SPDX-License-Identifier: BSD-3-Clause
"""Wheels and sdists whose bytes depend only on their contents."""
import base64
import gzip
import hashlib
import io
import tarfile
import zipfile

EPOCH = (1980, 1, 1, 0, 0, 0)  # the first time that a zip file can name


def write_wheel(path, files, record):
    """`files` are contents by name; the file `record` with their sums is added."""
    lines = []
    with zipfile.ZipFile(path, "w") as wheel:
        for name, content in sorted(files.items()):
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            lines.append(f"{name},sha256={digest},{len(content)}\n")
            _add(wheel, name, content)
        _add(wheel, record, "".join([*lines, f"{record},,\n"]).encode())


def _add(wheel, name, content):
    info = zipfile.ZipInfo(name, EPOCH)
    info.create_system = 3  # Unix, wherever this runs
    info.external_attr = (0o100755 if "/scripts/" in name else 0o100644) << 16
    info.compress_type = zipfile.ZIP_DEFLATED
    wheel.writestr(info, content)


def write_sdist(path, folder, files, metadata):
    """`files` are paths by name; the metadata are added as PKG-INFO."""
    contents = {name: (file.read_bytes(), file.stat().st_mode & 0o100) for name, file in files.items()}
    contents["PKG-INFO"] = (metadata.encode(), 0)
    with open(path, "wb") as raw, gzip.GzipFile("", "wb", fileobj=raw, mtime=0) as packed:
        with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
            for name, (content, is_program) in sorted(contents.items()):
                info = tarfile.TarInfo(f"{folder}/{name}")
                info.size = len(content)
                info.mode = 0o755 if is_program else 0o644
                archive.addfile(info, io.BytesIO(content))
