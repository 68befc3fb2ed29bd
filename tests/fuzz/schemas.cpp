// SPDX-License-Identifier: BSD-3-Clause
// A user's schema, `schema.json`, and a document that it judges, `values.yml`. What names them is
// fixed, so that every change reaches the schema or the document.
#include "fuzz/checked.hpp"
#include "fuzz/clock.hpp"

using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string config = ".smurf-lint.yaml";
  smurf::MemoryFiles files = unbundle(bytes, "schema.json");
  files.add(config, "schemas: {sections: {s: schema.json}, entities: {s: schema.json}}\n");
  files.add("s.smurfs", "entities:\n- {name: e, type: s, file: values.yml}\n");
  require_checked(files, "s.smurfs", config);
  return 0;
}
