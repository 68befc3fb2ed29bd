// SPDX-License-Identifier: BSD-3-Clause
// A scene of several files, from reading to every format that it is written in.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  require_kept(exercise(unbundle(bytes, "s.smurfs"), "s.smurfs", {.converts = true}));
  return 0;
}
