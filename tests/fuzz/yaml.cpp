// SPDX-License-Identifier: BSD-3-Clause
// YAML: the scanner of plain YAML and yaml-cpp read the same tree wherever the scanner reads one.
#include "fuzz/bundle.hpp"
#include "support/described_yaml.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  Exercise result;
  if (described_yaml(YamlEngine::scanner_first, text) !=
      described_yaml(YamlEngine::yaml_cpp, text)) {
    result.broken.emplace_back("the scanner and yaml-cpp disagree");
  }
  require_kept(result);
  return 0;
}
