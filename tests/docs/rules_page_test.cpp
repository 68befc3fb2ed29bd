// SPDX-License-Identifier: BSD-3-Clause
// docs/rules.md and docs/rules/*.md are made from the rule table and the fixtures; this test fails
// when they are stale. SMURF_UPDATE_SNAPSHOTS=1 writes them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "docs/page.hpp"
#include "smurf/readers.hpp"
#include "smurf/render.hpp"
#include "support/expected_reports.hpp"

namespace fs = std::filesystem;
using namespace smurf;
using test::heading_of, test::page_of;

namespace {

/// Pages by name.
const std::map<std::string, std::string>& page_titles() {
  static const std::map<std::string, std::string> kTitles = {
      {"sml0", "SML0xxx: files, YAML, encodings, limits"},
      {"sml10", "SML10xx: XML and xacro"},
      {"sml11", "SML11xx: elements and attributes of URDF"},
      {"sml12", "SML12xx: the tree of links and joints"},
      {"sml13", "SML13xx: names"},
      {"sml14", "SML14xx: joints, transmissions, extensions"},
      {"sml15", "SML15xx: masses and inertias"},
      {"sml16", "SML16xx: shapes and meshes"},
      {"sml17", "SML17xx: materials"},
      {"sml18", "SML18xx: numbers"},
      {"sml19", "SML19xx: what single programs do not support"},
      {"sml2", "SML2xxx: the main file"},
      {"sml3", "SML3xxx: references of annotations, xacro, ros2_control, MoveIt, Gazebo"},
      {"sml4", "SML4xxx: values of annotations, launch files, installation, frames"},
      {"sml5", "SML5xxx: scenes and assemblies"},
      {"sml6", "SML6xxx: the load check"},
      {"sml7", "SML7xxx: readers that disagree"},
      {"sml8", "SML8xxx: losses in a conversion"},
      {"sml9", "SML9xxx: configuration and suppressions"}};
  return kTitles;
}

/// The reason of the rule, and the facts about readers.
std::string reasons(const Rule& rule) {
  std::string text;
  if (!rule.why.empty()) text += "**Why it matters.** " + std::string(rule.why) + "\n\n";
  std::string readers;
  for (const Fact* fact : facts_about(rule)) readers += "- " + describe(*fact) + "\n";
  if (!readers.empty()) text += "**What readers make of it.**\n\n" + readers + "\n";
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string fixture_of(const Rule& rule) {
  return std::string(rule.id) + "-" + std::string(rule.name);
}

/// The first file that the finding names: " --> robot.urdf:20:19".
std::string file_of(const std::string& finding) {
  const std::size_t arrow = finding.find("--> ");
  if (arrow == std::string::npos) return {};
  const std::size_t begin = arrow + 4;
  return finding.substr(begin, finding.find(':', begin) - begin);
}

/// The lines that are in `good` but not in `bad`, with one line around them; "" if there are none
/// or many.
std::string new_lines(const std::string& bad, const std::string& good) {
  const std::vector<std::string> before = lines_of(bad);
  const std::vector<std::string> after = lines_of(good);
  const std::set<std::string> known(before.begin(), before.end());
  std::set<std::size_t> shown;
  std::size_t count = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (known.contains(after[i])) continue;
    ++count;
    for (std::size_t k = i == 0 ? 0 : i - 1; k <= std::min(i + 1, after.size() - 1); ++k) {
      shown.insert(k);
    }
  }
  constexpr std::size_t kMost = 8;
  if (count == 0 || count > kMost) return {};
  std::string text;
  std::size_t last = 0;
  for (const std::size_t i : shown) {
    if (!text.empty() && i > last + 1) text += "...\n";
    text += after[i] + "\n";
    last = i;
  }
  return text;
}

/// The first finding of the bad fixture, and the corresponding lines of the good one.
std::string example_of(const Rule& rule) {
  const std::string report = test::read_page(test::expected_report(fixture_of(rule)));
  if (report.empty()) return {};
  const std::string finding = report.substr(0, report.find("\n\n"));
  std::string text = "\n```text\n" + finding + "\n```\n";
  const std::string file = file_of(finding);
  const fs::path folder = fs::path(SMURF_FIXTURES) / "rules" / fixture_of(rule);
  const std::string bad = test::read_page(folder / "bad" / file);
  const std::string good = test::read_page(folder / "good" / file);
  const std::string lines = new_lines(bad, good);
  if (bad.empty() || lines.empty()) return text;
  const bool is_xml = file.ends_with(".urdf") || file.ends_with(".svg");
  return text + "\nNot reported:\n\n```" + (is_xml ? "xml" : "yaml") + "\n" + lines + "```\n";
}

void write_rule(std::ostream& page, const Rule& rule) {
  page << "\n### " << rule.id << " " << rule.name << "\n\n"
       << rule.summary << " (" << to_string(rule.severity) << ")\n\n"
       << reasons(rule) << "**What to do.** " << rule.remedy << "\n";
  const std::vector<std::string> cures = cures_of(rule);
  if (!cures.empty()) page << "\n";
  for (const std::string& cure : cures) page << "- " << cure << "\n";
  if (const Tolerance& tolerance = rule.tolerance; !tolerance.meaning.empty()) {
    page << "\n**Tolerance.** " << tolerance.value << (tolerance.unit.empty() ? "" : " ")
         << tolerance.unit << ": " << tolerance.meaning << "\n";
  }
  page << example_of(rule) << "\n**Sources.** " << sources_of(rule) << "\n";
}

/// A row of the index, with the anchors that links use.
void write_row(std::ostream& page, const Rule& rule) {
  const std::string anchor = heading_of(rule);
  page << "| <a id=\"" << rule.name << "\"></a><a id=\"" << anchor << "\"></a>[" << rule.id
       << "](rules/" << page_of(rule) << ".md#" << anchor << ") | " << rule.name << " | "
       << to_string(rule.severity) << " | " << rule.summary << " |\n";
}

std::string index_page() {
  std::ostringstream page;
  page << "# Rules\n\n"
          "Made from the rule table and the fixtures by `rules_page_test`; do not edit. "
          "`smurf-lint --explain ID` prints the text of a rule.\n";
  std::string current;
  for (const Rule* rule : all_rules()) {
    if (page_of(*rule) != current) {
      current = page_of(*rule);
      page << "\n## " << page_titles().at(current)
           << "\n\n| id | name | severity | finds |\n|---|---|---|---|\n";
    }
    write_row(page, *rule);
  }
  return page.str();
}

std::string family_page(const std::string& name) {
  std::ostringstream page;
  page << "# " << page_titles().at(name)
       << "\n\nMade from the rule table and the fixtures by `rules_page_test`; do not edit. "
          "[All rules](../rules.md).\n";
  for (const Rule* rule : all_rules()) {
    if (page_of(*rule) == name) write_rule(page, *rule);
  }
  return page.str();
}

}  // namespace

TEST_CASE("docs/rules.md is what the rule table says") {
  test::check_page("rules.md", index_page());
}

TEST_CASE("docs/rules/*.md are what the rule table says") {
  for (const auto& [name, title] : page_titles()) {
    test::check_page("rules/" + name + ".md", family_page(name));
  }
}
