// SPDX-License-Identifier: BSD-3-Clause
// docs/rules.md is made from the rule table and the fixtures; this test fails when it is stale.
// SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "docs/page.hpp"
#include "smurf/readers.hpp"

namespace fs = std::filesystem;
using namespace smurf;

namespace {

std::string family_title(std::string_view id) {
  static const std::map<char, std::string> kTitles = {
      {'0', "SML0xxx: files, YAML, encodings, limits"},
      {'1', "SML1xxx: the URDF"},
      {'2', "SML2xxx: the main file"},
      {'3', "SML3xxx: what annotations refer to"},
      {'4', "SML4xxx: shapes and values of annotations"},
      {'5', "SML5xxx: scenes and assemblies"},
      {'6', "SML6xxx: the load check"},
      {'7', "SML7xxx: readers that disagree"},
      {'8', "SML8xxx: losses in a conversion"},
      {'9', "SML9xxx: configuration and suppressions"}};
  return kTitles.at(id[3]);
}

/// Why it matters, and what readers make of it.
std::string reasons(const Rule& rule) {
  std::string text;
  if (!rule.why.empty()) text += "**Why it matters.** " + std::string(rule.why) + "\n\n";
  std::string readers;
  for (const Fact* fact : facts_about(rule)) readers += "- " + describe(*fact) + "\n";
  if (!readers.empty()) text += "**What readers make of it.**\n\n" + readers + "\n";
  return text;
}

std::string rules_page() {
  std::ostringstream page;
  page << "# Rules\n\n"
          "Made from the rule table and the fixtures by `rules_page_test`; do not edit. "
          "`smurf-lint --explain ID` prints the same texts.\n";
  char family = 0;
  for (const Rule* rule : all_rules()) {
    if (rule->id[3] != family) {
      family = rule->id[3];
      page << "\n## " << family_title(rule->id)
           << "\n\n| id | name | severity | finds |\n|---|---|---|---|\n";
      for (const Rule* row : all_rules()) {
        if (row->id[3] != family) continue;
        page << "| [" << row->id << "](#" << row->name << ") | " << row->name << " | "
             << to_string(row->severity) << " | " << row->summary << " |\n";
      }
    }
    page << "\n<a id=\"" << rule->name << "\"></a>\n### " << rule->id << " " << rule->name << "\n\n"
         << rule->summary << " (" << to_string(rule->severity) << ")\n\n"
         << reasons(*rule) << "**What to do.** " << rule->remedy << "\n";
    if (const Tolerance& tolerance = rule->tolerance; !tolerance.meaning.empty()) {
      page << "\n**Tolerance.** " << tolerance.value << (tolerance.unit.empty() ? "" : " ")
           << tolerance.unit << ": " << tolerance.meaning << "\n";
    }
    page << "\n**Sources.** " << sources_of(*rule) << "\n";
    const std::string example = test::read_page(
        fs::path(SMURF_FIXTURES) / "rules" /
        (std::string(rule->id) + "-" + std::string(rule->name)) / "bad.expected.txt");
    if (!example.empty()) {
      // The first diagnostic is example enough.
      const std::size_t second = example.find("\n\n");
      page << "\n```text\n" << example.substr(0, second) << "\n```\n";
    }
  }
  return page.str();
}

}  // namespace

TEST_CASE("docs/rules.md is what the rule table says") {
  test::check_page("rules.md", rules_page());
}
