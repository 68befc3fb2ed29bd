// SPDX-License-Identifier: BSD-3-Clause
// Every rule of the load check against its fixtures: `bad` raises it in its stage and nothing else,
// `good`, which is a near miss, passes all stages.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "load_check/built.hpp"
#include "smurf-load-check/check.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "smurf/render.hpp"

namespace fs = std::filesystem;
using namespace smurf;
using namespace smurf::load_check;

namespace {

const fs::path kFixtures = fs::path(SMURF_FIXTURES) / "load-check";
const fs::path kExpected = SMURF_ROOT "/fixtures/load-check";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Case {
  SourceMap sources;
  MemoryFiles files;
  CheckResult result;

  explicit Case(const fs::path& folder) {
    start_engine_once();
    files.add("robot.urdf", read(folder / "robot.urdf"));
    DiagnosticSink sink;
    LoadContext context{sources, files, sink, {}, {}};
    const LinkedModel model = load_model("robot.urdf", context);
    REQUIRE(model.robot);
    REQUIRE(sink.diagnostics().empty());
    result = check_model(model, {files}, {}, [](Stage, const CheckResult&) {});
    locate(model, result.diagnostics);
    result.diagnostics = apply_selection(std::move(result.diagnostics), sources, {});
  }

  std::string text() const {
    std::string all;
    for (const Diagnostic& diagnostic : result.diagnostics) {
      all += render_full(diagnostic, sources, {});
    }
    return all;
  }

  /// The first stage that fails, or that warns when none fails.
  std::string stage() const {
    for (const Verdict verdict : {Verdict::fail, Verdict::warn}) {
      for (const StageResult& stage : result.stages) {
        if (stage.verdict == verdict) return std::string(to_string(stage.stage));
      }
    }
    return "none";
  }
};

/// The stage, by the third digit of the id; faults that the linter also finds are found in BUILD.
std::string stage_of(const Rule& rule) {
  const std::string stages[] = {"", "BUILD", "POSE0", "STILL", "HANG", "DROP", "ANCHOR"};
  return stages[rule.id.starts_with("SML6") ? static_cast<std::size_t>(rule.id[4] - '0') : 1];
}

}  // namespace

TEST_CASE("each rule of the load check: in its stage, at its place, alone") {
  // Fixtures that need a limit, a scene or a tighter bound are in the tests of the command line.
  const std::set<std::string_view> elsewhere = {"SML6001", "SML6002", "SML6105",
                                                "SML6302", "SML6402", "SML6601"};
  std::set<std::string_view> covered = elsewhere;
  for (const auto& entry : fs::directory_iterator(kFixtures)) {
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    const Rule* rule = find_rule(name.substr(0, name.find('-')));
    REQUIRE_MESSAGE(rule != nullptr, "fixtures without a rule");
    CHECK(name == std::string(rule->id) + "-" + std::string(rule->name));
    covered.insert(rule->id);
    const Case bad(kFixtures / name / "bad");
    CHECK(bad.stage() == stage_of(*rule));
    CHECK(!bad.result.diagnostics.empty());
    for (const Diagnostic& diagnostic : bad.result.diagnostics) {
      CHECK_MESSAGE(diagnostic.rule->id == rule->id, bad.text());
    }
    const fs::path expected = kExpected / name / "bad.expected.txt";
    if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
      std::ofstream(expected, std::ios::binary) << bad.text();
    }
    CHECK(read(expected) == bad.text());
    const Case good(kFixtures / name / "good");
    CHECK_MESSAGE(good.result.diagnostics.empty(), good.text());
    CHECK(good.stage() == "none");
  }
  for (const Rule* rule : all_rules()) {
    if (!rule->id.starts_with("SML6")) continue;
    CHECK_MESSAGE(covered.contains(rule->id), rule->id << " has no fixtures");
  }
}
