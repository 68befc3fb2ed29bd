# SPDX-License-Identifier: BSD-3-Clause
# cmake -D BUILD=... -D SOURCE=... -D MODEL=... -D WORK=... -D GENERATOR=... -P install_and_use.cmake
# Installs the build into a prefix of its own and builds and runs the consumer against it.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR}
  -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${MODEL})
if(NOT out STREQUAL "6 motors, 0 findings\n")
  message(FATAL_ERROR "the consumer says: ${out}")
endif()
foreach(tool smurf-lint smurf2urdf smurfs-flatten)
  run(${WORK}/prefix/bin/${tool} --version)
endforeach()
