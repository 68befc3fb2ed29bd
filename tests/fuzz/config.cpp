// SPDX-License-Identifier: BSD-3-Clause
// The configuration of the linter, and the schemas it names.
#include "smurf/config.hpp"
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string path(kConfigName);
  const MemoryFiles files = unbundle(bytes, path);
  SourceMap sources;
  DiagnosticSink sink;
  read_config(path, sources, files, sink);
  Exercise result;
  check_findings({sink.diagnostics().begin(), sink.diagnostics().end()}, sources, result);
  require_kept(result);
  return 0;
}
