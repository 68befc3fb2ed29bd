# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset `windows`: Debian's cross compiler with the threads of POSIX, and the libraries that
# `scripts/static-libraries --windows` has built. The programs run under wine, which also writes their pages.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# Debian has the program for programs of 64 bits on no PATH.
find_program(SMURF_WINE wine64 PATHS /usr/lib/wine)
if(SMURF_WINE)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${SMURF_WINE})
endif()

set(folder windows-libraries)
include(${CMAKE_CURRENT_LIST_DIR}/cross_libraries.cmake)
# The headers would else ask for functions of a DLL. Windows of 2015 (10) has all functions that are called.
add_compile_definitions(URDFDOM_STATIC CONSOLE_BRIDGE_STATIC_DEFINE YAML_CPP_STATIC_DEFINE _WIN32_WINNT=0x0A00)
add_compile_options(-Wa,-mbig-obj)
