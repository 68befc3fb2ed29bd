# SPDX-License-Identifier: BSD-3-Clause
# cmake -D BUILD=... -D SOURCE=... -D MODEL=... -D WORK=... -D GENERATOR=... -D FLAGS=...
#   -D COMPILER=... -D ROOT=... -D SCRIPTS=... [-D PYTHON=...] -P install_and_use.cmake
# Installs the build into a prefix of its own, moves it, and builds and runs against it the consumer and the programs
# of docs/library.md. ROOT is that of the repository, SCRIPTS the Python that runs scripts.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
file(RENAME ${WORK}/first ${WORK}/prefix)

# Libraries that are only used inside are not asked of a consumer.
file(GLOB_RECURSE exported ${WORK}/prefix/smurf-targets*.cmake)
foreach(file IN LISTS exported)
  file(READ ${file} text)
  if(text MATCHES "Eigen|nlohmann|doctest|${BUILD}|${SOURCE}")
    message(FATAL_ERROR "${file} mentions ${CMAKE_MATCH_0}")
  endif()
endforeach()

# run_consumer(PROGRAM): it loads the model as it should.
function(run_consumer program)
  run(${program} ${MODEL})
  if(NOT out STREQUAL "6 motors, 0 findings\n")
    message(FATAL_ERROR "the consumer says: ${out}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK}/examples)
run(${SCRIPTS} ${SOURCE}/examples.py ${ROOT}/docs/library.md ${WORK}/examples)
string(REGEX MATCHALL "[^\n]+" examples "${out}")
if(NOT examples)
  message(FATAL_ERROR "no program was found in docs/library.md")
endif()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -D EXAMPLES=${WORK}/examples
  -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_FLAGS=${FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run_consumer(${WORK}/build/consumer)

foreach(example IN LISTS examples)
  separate_arguments(words UNIX_COMMAND "${example}")
  list(POP_FRONT words name)
  list(TRANSFORM words PREPEND ${ROOT}/)
  run(${WORK}/build/${name} ${words})
  file(READ ${WORK}/examples/${name}.txt expected)
  if(NOT out STREQUAL expected)
    message(FATAL_ERROR "${name} of docs/library.md prints: ${out}")
  endif()
endforeach()

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE package ${WORK}/prefix/smurf.pc)
  cmake_path(GET package PARENT_PATH folder)
  run(${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${PKG_CONFIG} --cflags --libs smurf)
  separate_arguments(flags UNIX_COMMAND "${FLAGS} -std=c++20 ${SOURCE}/main.cpp ${out}")
  run(${COMPILER} ${flags} -o ${WORK}/consumer)
  run_consumer(${WORK}/consumer)
endif()

# The Python module, and the tools beside it.
if(PYTHON)
  file(GLOB_RECURSE package ${WORK}/prefix/__init__.py)
  list(GET package 0 package)
  cmake_path(GET package PARENT_PATH folder)
  cmake_path(GET folder PARENT_PATH folder)
  set(python ${CMAKE_COMMAND} -E env PYTHONPATH=${folder} PYTHONDONTWRITEBYTECODE=1 PATH=/nowhere ${PYTHON})
  run(${python} -c "import sys, smurf
arm = smurf.load_model(sys.argv[1])
print(len(arm.motors), 'motors,', len(arm.check()), 'findings')" ${MODEL})
  if(NOT out STREQUAL "6 motors, 0 findings\n")
    message(FATAL_ERROR "the Python module says: ${out}")
  endif()
  run(${python} -m smurf lint ${MODEL})
endif()

foreach(tool smurf-lint smurf-lsp smurf2urdf urdf2smurf smurfs-flatten smurf-diff)
  run(${WORK}/prefix/bin/${tool} --version)
endforeach()
