# SPDX-License-Identifier: BSD-3-Clause
"""Finds out from the bytes of a program for Linux or Windows on which systems it runs."""
import struct
import sys
import sysconfig

MACHINES = {62: "x86_64", 183: "aarch64"}
# Libraries of every glibc. A program that needs other libraries runs only where these are installed.
GLIBC = ("libc.so.", "libm.so.", "libdl.so.", "libpthread.so.", "librt.so.", "ld-linux")
OLDEST_GLIBC = (2, 17)  # no pip asks for an older one

LOAD, DYNAMIC = 1, 2
NEEDED, STRTAB, VERNEED, VERNEEDNUM = 1, 5, 0x6FFFFFFE, 0x6FFFFFFF


class Elf:
    """A 64-bit little-endian ELF file: its machine, libraries and versions of symbols."""

    def __init__(self, content):
        self.content = content
        self.machine = MACHINES.get(struct.unpack_from("<H", content, 18)[0], "unknown")
        start, size, count = *struct.unpack_from("<Q", content, 32), *struct.unpack_from("<HH", content, 54)
        headers = [struct.unpack_from("<IIQQQQ", content, start + size * i) for i in range(count)]
        self.loads = [(address, length, offset) for kind, _, offset, address, _, length in headers if kind == LOAD]
        self.entries = [entry for header in headers if header[0] == DYNAMIC for entry in self._dynamic(header[2])]
        self.libraries = [self._string(value) for key, value in self.entries if key == NEEDED]
        self.versions = list(self._versions())

    def _dynamic(self, offset):
        while (entry := struct.unpack_from("<QQ", self.content, offset))[0] != 0:
            yield entry
            offset += 16

    def _value(self, key):
        return next((value for other, value in self.entries if other == key), 0)

    def _offset(self, address):
        return next(address - start + offset for start, length, offset in self.loads if start <= address < start + length)

    def _string(self, index):
        start = self._offset(self._value(STRTAB)) + index
        return self.content[start : self.content.index(b"\0", start)].decode()

    def _versions(self):
        """Names such as GLIBC_2.34."""
        count = self._value(VERNEEDNUM)
        offset = self._offset(self._value(VERNEED)) if count else 0
        for _ in range(count):
            names, first, following = struct.unpack_from("<2xH4xII", self.content, offset)
            name_offset = offset + first
            for _ in range(names):
                name, next_name = struct.unpack_from("<8xII", self.content, name_offset)
                yield self._string(name)
                name_offset += next_name
            offset += following


def _glibc_of(elf):
    """The oldest glibc it runs with; None where it needs other libraries as well."""
    if not all(library.startswith(GLIBC) for library in elf.libraries):
        return None
    numbers = [version[6:].split(".") for version in elf.versions if version[:6] == "GLIBC_" and version[6:7].isdigit()]
    return max([OLDEST_GLIBC, *((int(major), int(minor)) for major, minor, *_ in numbers)])


def machine_of(content):
    """Such as linux-aarch64, or win-amd64: what sysconfig.get_platform() says where the program runs."""
    if is_for_windows(content):
        return "win-amd64"
    return f"linux-{Elf(content).machine}"


def is_for_windows(content):
    """A PE file for x86_64."""
    header = struct.unpack_from("<I", content, 60)[0] if content.startswith(b"MZ") and len(content) >= 64 else 0
    return header > 0 and content[header : header + 6] == b"PE\0\0\x64\x86"


def _platforms(files):
    if all(map(is_for_windows, files)):
        return "win_amd64"
    if not all(content.startswith(b"\x7fELF\x02\x01") for content in files):
        return sysconfig.get_platform().replace("-", "_").replace(".", "_")
    elves = [Elf(content) for content in files]
    machine = elves[0].machine
    if any(elf.machine != machine for elf in elves):
        raise ValueError("the programs are for different machines")
    oldest = [_glibc_of(elf) for elf in elves]
    if None in oldest:
        return f"linux_{machine}"
    major, minor = max(oldest)
    names = [f"manylinux_{major}_{minor}_{machine}"]
    if (major, minor) == OLDEST_GLIBC:
        names.append(f"manylinux2014_{machine}")
    if not any(elf.libraries for elf in elves):
        names.append(f"musllinux_1_1_{machine}")
    return ".".join(names)


def tag_of(files, is_for_this_python):
    """The tag of a wheel with these programs and modules. With modules for several Pythons, it is for all of them."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{_platforms(files)}" if is_for_this_python else f"py3-none-{_platforms(files)}"
