// SPDX-License-Identifier: BSD-3-Clause
// The typed readers and the published schemas give the same verdict, over the fixtures, real files,
// every key with every kind of value, and random mutations.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <doctest/doctest.h>

#include "schema/case_file.hpp"
#include "schema/mutations.hpp"

namespace fs = std::filesystem;
using namespace smurf;
using namespace smurf::test;

namespace {

struct File {
  fs::path path;
  FileKind kind;
  std::string text;
};

std::vector<File> files_below(const fs::path& folder) {
  std::vector<File> files;
  if (!fs::exists(folder)) return files;
  for (const auto& item : fs::recursive_directory_iterator(folder)) {
    const auto kind = kind_of(item.path());
    if (!item.is_regular_file() || !kind) continue;
    std::ifstream stream(item.path(), std::ios::binary);
    files.push_back({item.path(), *kind, {std::istreambuf_iterator<char>(stream), {}}});
  }
  std::sort(files.begin(), files.end(),
            [](const File& a, const File& b) { return a.path < b.path; });
  return files;
}

/// Models and scenes from public repositories; absent on most machines.
std::vector<File> corpus() {
  std::vector<File> files = files_below(SMURF_SHARED "/corpus/smurf");
  for (File& file : files_below(SMURF_SHARED "/corpus/smurf_docs"))
    files.push_back(std::move(file));
  if (files.empty()) MESSAGE("skipped: the corpus of real files is not here");
  return files;
}

void check_agreement(CaseFile& cases) {
  const auto disagreements = cases.disagreements();
  if (!disagreements) {
    MESSAGE("skipped: python3-jsonschema is not installed (scripts/setup)");
    return;
  }
  MESSAGE(cases.size(), " cases, ", cases.valid_count(), " valid, ", disagreements->size(),
          " disagreements");
  CHECK(disagreements->empty());
  for (std::size_t i = 0; i < std::min<std::size_t>(disagreements->size(), 20); ++i) {
    MESSAGE((*disagreements)[i]);
  }
}

/// Real files with forms that a reader refuses, and that reader.
bool is_known_bad(const fs::path& path) {
  const std::string name = path.filename().string();
  // Colours as lists, from a development version of Phobos: they cause an exception in MARS.
  if (name == "example_mechanism_materials.yml") return true;
  // Phobos's templates of motors, sensors, ...: these are not annotations.
  return path.parent_path().filename() == "definitions";
}

}  // namespace

TEST_CASE("sound files have sound shapes") {
  std::vector<File> files = corpus();
  for (const char* folder : {"/models", "/scenes"}) {
    for (File& file : files_below(std::string(SMURF_FIXTURES) + folder))
      files.push_back(std::move(file));
  }
  CHECK(files.size() > 20);
  for (const File& file : files) {
    CAPTURE(file.path.string());
    const Reading reading(file.kind, file.text);
    std::string findings;
    for (const Diagnostic* finding : reading.shape_findings()) findings += finding->message + "\n";
    CHECK(reading.document.has_value());
    CHECK_MESSAGE(findings.empty() != is_known_bad(file.path), findings);
  }
}

TEST_CASE("readers and schemas agree on every kind of value of every key") {
  CaseFile cases;
  enumerate_values([&cases](FileKind kind, std::string text) { cases.add(kind, std::move(text)); });
  check_agreement(cases);
}

TEST_CASE("readers and schemas agree on files and their mutations") {
  constexpr unsigned kSeed = 20260101;
  constexpr int kRounds = 60;
  std::mt19937 random(kSeed);
  std::vector<File> files = files_below(SMURF_FIXTURES);
  for (File& file : corpus()) files.push_back(std::move(file));
  CaseFile cases;
  std::size_t unparsable = 0;
  for (const File& file : files) {
    cases.add(file.kind, file.text);
    for (int round = 0; round < kRounds; ++round) {
      std::string text = file.text;
      for (auto step = 1 + random() % 3; step > 0; --step) text = mutate(std::move(text), random);
      if (!cases.add(file.kind, std::move(text))) ++unparsable;
    }
  }
  MESSAGE(files.size(), " files, seed ", kSeed, ", ", unparsable, " mutations are not YAML");
  check_agreement(cases);
}
