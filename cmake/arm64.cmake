# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset `arm64`: Debian's cross compiler, and the libraries that
# `scripts/static-libraries --arm64` has built. The manual pages are written by the programs, under qemu.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)

set(folder arm64-libraries)
include(${CMAKE_CURRENT_LIST_DIR}/cross_libraries.cmake)
