// SPDX-License-Identifier: BSD-3-Clause
// Fixes of a model: a file that could be read can be read after all its fixes were applied.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const MemoryFiles files = unbundle(bytes, "r.smurf");
  const Exercise before = exercise(files, "r.smurf", {.renders = false, .fixes = true});
  require_kept(before);
  MemoryFiles fixed(&files);
  for (const auto& [path, text] : before.fixed) fixed.add(path, text);
  Exercise after = exercise(fixed, "r.smurf", {.renders = false, .fixes = true});
  for (const auto& [path, text] : before.fixed) {
    if (after.unreadable.contains(path) && !before.unreadable.contains(path)) {
      after.broken.emplace_back("a fix broke the syntax of its file");
    }
  }
  require_kept(after);
  return 0;
}
