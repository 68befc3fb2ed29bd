// SPDX-License-Identifier: BSD-3-Clause
// Every rule against its fixtures: `bad` raises it and nothing else, `good`, which is a near miss,
// raises nothing; the full text of `bad` is compared with the expected output beside it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "smurf/check.hpp"
#include "smurf/fix.hpp"
#include "smurf/lint.hpp"
#include "smurf/render.hpp"
#include "support/expected_reports.hpp"

namespace fs = std::filesystem;
using namespace smurf;

namespace {

const fs::path kFixtures = fs::path(SMURF_FIXTURES) / "rules";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

MemoryFiles read_folder(const fs::path& folder) {
  MemoryFiles files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.add(fs::relative(entry.path(), folder).generic_string(), read(entry.path()));
    }
  }
  return files;
}

/// A fixture, checked as smurf-lint does, with its configuration.
struct Case {
  SourceMap sources;
  MemoryFiles files;
  std::vector<Diagnostic> diagnostics;

  Case(const fs::path& folder, const RuleSelection& selection)
      : Case(read_folder(folder), selection) {}
  Case(MemoryFiles all, const RuleSelection& selection) : files(std::move(all)) {
    CheckSettings settings;
    settings.selection = selection;
    settings.remembers = false;
    Session session(files);
    diagnostics = session.check(entry(), settings).diagnostics;
    sources = session.sources();
  }

  std::string entry() const {
    for (const char* name : {"scene.svg", "scene.smurfs", "model.smurf", "robot.urdf",
                             "robot.urdf.xacro", "robot.mjcf", "robot.sdf", "robot.srdf"}) {
      if (files.is_file(name)) return name;
    }
    FAIL("there is no entry file");
    return {};
  }

  /// The files after one round of fixes; none if there are no fixes.
  std::optional<MemoryFiles> fixed(Applicability most) const {
    AppliedFixes applied = apply_fixes(diagnostics, sources, most);
    if (applied.texts.empty()) return std::nullopt;
    MemoryFiles result = files;
    for (FixedText& file : applied.texts) result.add(file.path, std::move(file.text));
    return result;
  }

  std::size_t fixable(Applicability most) const {
    return static_cast<std::size_t>(
        std::count_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& diagnostic) {
          return !diagnostic.fixes.empty() &&
                 (most == Applicability::unsafe ||
                  diagnostic.fixes.front().applicability == Applicability::safe);
        }));
  }

  std::string text() const {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
      all += render_full(diagnostic, sources, {});
    }
    return all;
  }
};

void check_snapshot(const fs::path& expected_path, const std::string& actual) {
  if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
    std::ofstream(expected_path, std::ios::binary) << actual;
    return;
  }
  CHECK(read(expected_path) == actual);
}

/// The targets that the file `targets` of a fixture names, blanks between them.
RuleSelection selection_for(const fs::path& folder) {
  RuleSelection selection;
  std::istringstream names(read(folder / "targets"));
  for (std::string name; names >> name;) {
    selection.targets.push_back(find_target(name));
    REQUIRE_MESSAGE(selection.targets.back() != nullptr, name << " is no target");
  }
  return selection;
}

std::string folder_name(const Rule& rule) {
  return std::string(rule.id) + "-" + std::string(rule.name);
}

}  // namespace

TEST_CASE("ids and names mean one rule each") {
  std::map<std::string_view, int> uses;
  for (const Rule* rule : all_rules()) {
    ++uses[rule->id];
    ++uses[rule->name];
  }
  for (const auto& entry : uses) CHECK_MESSAGE(entry.second == 1, entry.first);
}

TEST_CASE("bad fixtures raise their rule and nothing else, good ones nothing") {
  for (const Rule* rule : all_rules()) {
    const fs::path folder = kFixtures / folder_name(*rule);
    CAPTURE(folder_name(*rule));
    if (!fs::exists(folder)) continue;  // another test requires it
    const RuleSelection selection = selection_for(folder);
    // A rule that needs targets has a file with the targets of its fixtures; other fixtures are
    // checked without targets.
    CHECK(rule->needs_target == !selection.targets.empty());
    const Case bad(folder / "bad", selection);
    CHECK_MESSAGE(!bad.diagnostics.empty(), "the bad fixture raises nothing");
    for (const Diagnostic& diagnostic : bad.diagnostics) {
      CHECK_MESSAGE(diagnostic.rule->id == rule->id, bad.text());
      CHECK(!diagnostic.message.empty());
      CHECK(diagnostic.message.back() != '.');
      if (diagnostic.severity == Severity::info) continue;
      const std::string shown = render_full(diagnostic, bad.sources, {});
      CHECK_MESSAGE(shown.find("= help: ") != std::string::npos, "no next step:\n" << shown);
    }
    check_snapshot(test::expected_report(folder_name(*rule)), bad.text());
    const Case good(folder / "good", selection);
    CHECK_MESSAGE(good.diagnostics.empty(), good.text());
  }
}

TEST_CASE("what a fix was applied for is gone, and nothing new has come") {
  std::size_t fixes = 0;
  for (const Rule* rule : all_rules()) {
    const fs::path folder = kFixtures / folder_name(*rule);
    CAPTURE(folder_name(*rule));
    if (!fs::exists(folder)) continue;
    const RuleSelection selection = selection_for(folder);
    for (const Applicability most : {Applicability::safe, Applicability::unsafe}) {
      const Case bad(folder / "bad", selection);
      const std::size_t before = bad.diagnostics.size();
      const std::size_t fixable = bad.fixable(most);
      fixes += fixable;
      std::optional<MemoryFiles> files = bad.fixed(most);
      CHECK((fixable > 0) == files.has_value());
      if (!files) continue;
      Case now(std::move(*files), selection);
      for (int round = 0; round < 10; ++round) {
        std::optional<MemoryFiles> again = now.fixed(most);
        if (!again) break;
        now = Case(std::move(*again), selection);
      }
      CHECK_MESSAGE(now.fixable(most) == 0, now.text());
      // Several findings may share one fix; a fix must not cause other findings.
      CHECK_MESSAGE(now.diagnostics.size() + fixable <= before, now.text());
      for (const Diagnostic& diagnostic : now.diagnostics) {
        CHECK_MESSAGE(diagnostic.rule->id == rule->id, now.text());
      }
    }
  }
  CHECK(fixes > 20);
}

TEST_CASE("every rule has fixtures, and every fixture a rule") {
  std::set<std::string> folders;
  for (const auto& entry : fs::directory_iterator(kFixtures)) {
    folders.insert(entry.path().filename().string());
  }
  // Rules that no file can trigger, because they report messages of the operating system. Limits of
  // scenes would need too many files; scene_test lowers them. Baselines are read by the tool, and
  // losses come from converters; both have their own tests.
  const std::set<std::string> no_fixture = {
      "SML0001-unreadable-file",    "SML0002-file-too-large",     "SML5021-nested-too-deep",
      "SML5022-too-many-instances", "SML8001-not-expressible",    "SML8002-not-requested",
      "SML8003-ambiguous",          "SML8004-vendor-extension",   "SML8005-collapsed-link",
      "SML8101-kept-as-text",       "SML9104-malformed-baseline", "SML9105-stale-baseline-entry"};
  for (const Rule* rule : all_rules()) {
    const std::string name = folder_name(*rule);
    // Reported by simulating a robot, not by reading it; load_check_test has their fixtures.
    if (name.starts_with("SML6")) continue;
    // Losses come from writers, which the tests of the formats check.
    if (no_fixture.contains(name) || rule->id.starts_with("SML82")) continue;
    CHECK_MESSAGE(folders.erase(name) == 1, name << " has no fixtures");
  }
  CHECK_MESSAGE(folders.empty(), "fixtures without a rule: " << *folders.begin());
}

TEST_CASE("the rule table keeps its promises") {
  std::string previous;
  std::set<std::string_view> names;
  const std::set<std::string> stages = {"SML0", "SML1", "SML2", "SML3", "SML4",
                                        "SML5", "SML6", "SML7", "SML8", "SML9"};
  for (const Rule* rule : all_rules()) {
    CAPTURE(rule->id);
    CHECK(std::string(rule->id) > previous);
    previous = rule->id;
    CHECK(rule->id.size() == 7);
    CHECK(stages.contains(std::string(rule->id.substr(0, 4))));
    CHECK(names.insert(rule->name).second);
    for (const char c : rule->name) CHECK((std::islower(c) || std::isdigit(c) || c == '-'));
    CHECK(rule->summary.size() <= 100);
    CHECK(rule->summary.ends_with('.'));
    CHECK((!rule->why.empty() || !facts_about(*rule).empty()));
    CHECK(!rule->remedy.empty());
    CHECK((!rule->sources.empty() || !facts_about(*rule).empty()));
    CHECK(find_rule(rule->id) == rule);
    CHECK(find_rule(rule->name) == rule);
  }
}
