// SPDX-License-Identifier: BSD-3-Clause
// A URDF alone, from reading to the exported URDF.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  smurf::MemoryFiles files;
  files.add("r.urdf", std::string(reinterpret_cast<const char*>(data), size));
  require_kept(exercise(files, "r.urdf", {.converts = true}));
  return 0;
}
