// SPDX-License-Identifier: BSD-3-Clause
// The files in schemas/ match the tables. SMURF_UPDATE_SNAPSHOTS=1 rewrites it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "ast/keys.hpp"
#include "ast/sections.hpp"
#include "schema/schema_writer.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path kSchemas = SMURF_SCHEMAS;

std::string read(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("the schemas are up to date") {
  for (const auto& file : smurf::test::write_schemas()) {
    const std::string &name = file.first, &text = file.second;
    CAPTURE(name);
    if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
      std::ofstream(kSchemas / name, std::ios::binary) << text;
    }
    CHECK_MESSAGE(read(kSchemas / name) == text,
                  "stale: run this test with SMURF_UPDATE_SNAPSHOTS=1");
  }
}

TEST_CASE("every schema says what it is") {
  for (const auto& file : fs::directory_iterator(kSchemas)) {
    CAPTURE(file.path().string());
    const auto schema = nlohmann::json::parse(read(file.path()));
    const std::string id = schema.at("$id");
    CHECK(schema.at("$schema") == "http://json-schema.org/draft-07/schema#");
    CHECK(id.ends_with("/schemas/" + file.path().filename().string()));
    CHECK(!schema.at("title").get<std::string>().empty());
    CHECK(!schema.at("description").get<std::string>().empty());
  }
}

TEST_CASE("every key of every section has a sentence, and defaults are JSON") {
  for (const smurf::SectionSpec* section : smurf::all_sections()) {
    for (const smurf::KeySpec* key : section->keys()) {
      CAPTURE(section->name);
      CAPTURE(key->name);
      CHECK(!key->doc.empty());
      CHECK((key->fallback.empty() || nlohmann::json::accept(key->fallback)));
    }
  }
}
