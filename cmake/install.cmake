# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts where, so that find_package(smurf) and pkg-config find the library.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/smurf)
install(TARGETS smurf smurf_referees EXPORT smurf-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT smurf-targets NAMESPACE smurf:: DESTINATION ${package_dir})
configure_package_config_file(cmake/smurf-config.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/smurf-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/smurf-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/smurf-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/smurf-config-version.cmake DESTINATION ${package_dir})

file(RELATIVE_PATH SMURF_PC_TO_PREFIX
  "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
configure_file(cmake/smurf.pc.in ${CMAKE_CURRENT_BINARY_DIR}/smurf.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/smurf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(DIRECTORY schemas/ DESTINATION ${CMAKE_INSTALL_DATADIR}/smurf/schemas)

# All pages, in the folders that their links expect.
install(FILES LICENSE README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(DIRECTORY schemas DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(FILES python/examples/robots.ipynb
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/python/examples COMPONENT documentation)
