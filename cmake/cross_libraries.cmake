# SPDX-License-Identifier: BSD-3-Clause
# Part of the toolchains for other systems: libraries come from `folder`, which scripts/static-libraries has filled, and
# programs from this machine.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH project)
set(libraries ${project}/build/${folder})
set(CMAKE_FIND_ROOT_PATH ${libraries})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/lib/pkgconfig)
