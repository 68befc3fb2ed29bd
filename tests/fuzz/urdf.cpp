// SPDX-License-Identifier: BSD-3-Clause
// A URDF alone, from reading to the exported URDF. The scanner of XML and tinyxml2 read the same
// tree wherever the scanner takes the file for plain.
#include "fuzz/bundle.hpp"
#include "support/described_xml.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  MemoryFiles files;
  const std::string text(reinterpret_cast<const char*>(data), size);
  files.add("r.urdf", text);
  Exercise result = exercise(files, "r.urdf", {.converts = true});
  if (described_xml(XmlEngine::scanner_first, text) != described_xml(XmlEngine::tinyxml2, text)) {
    result.broken.emplace_back("the scanner and tinyxml2 disagree");
  }
  require_kept(result);
  return 0;
}
