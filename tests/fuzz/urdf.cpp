// SPDX-License-Identifier: BSD-3-Clause
// A URDF alone, from reading to the exported URDF. What we take for XML, tinyxml2 reads alike.
#include "fuzz/bundle.hpp"
#include "support/described_xml.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  MemoryFiles files;
  const std::string text(reinterpret_cast<const char*>(data), size);
  files.add("r.urdf", text);
  Exercise result = exercise(files, "r.urdf", {.converts = true});
  if (described_xml(XmlReader::ours, text) != described_xml(XmlReader::tinyxml2, text)) {
    result.broken.emplace_back("tinyxml2 reads something else");
  }
  require_kept(result);
  return 0;
}
