# SPDX-License-Identifier: BSD-3-Clause
# Toolchain of the preset `wasm`: Emscripten, as Debian packages it, and the libraries that
# `scripts/static-libraries --wasm` has built.
find_program(SMURF_EMCONFIG em-config REQUIRED)
execute_process(COMMAND ${SMURF_EMCONFIG} EMSCRIPTEN_ROOT
  OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)

cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH project)
set(libraries ${project}/build/wasm-libraries)
list(APPEND CMAKE_FIND_ROOT_PATH ${libraries})
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/lib/pkgconfig)
# What Emscripten emulates exceptions with is larger and slower; engines of 2022 have real ones.
set(CMAKE_CXX_FLAGS_INIT -fwasm-exceptions)
