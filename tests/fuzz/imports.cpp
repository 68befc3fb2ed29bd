// SPDX-License-Identifier: BSD-3-Clause
// An MJCF or SDF with the files that it names, from reading to the exported URDF.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const smurf::MemoryFiles files = unbundle(bytes, "r.xml");
  require_kept(exercise(files, "r.xml", {.converts = true, .fixes = true}));
  return 0;
}
