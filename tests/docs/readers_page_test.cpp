// SPDX-License-Identifier: BSD-3-Clause
// docs/readers.md is made from the table of readers; this test fails when it is stale.
// SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include "docs/page.hpp"
#include "smurf/readers.hpp"

using namespace smurf;

namespace {

/// "[SML1408](rules.md#bounds-equal)", or "SML18xx" for a whole family.
std::string link_to(std::string_view id) {
  const Rule* rule = find_rule(id);
  if (rule != nullptr) {
    return test::link_to(*rule);
  }
  return std::string(id) + std::string(7 - id.size(), 'x');
}

void write_fact(std::ostream& page, std::string_view rules, const Fact& fact) {
  page << "| " << link_to(rules) << " | " << describe(fact.where) << " | " << to_string(fact.effect)
       << " | " << fact.makes << " | " << evidence_of(fact) << " |\n";
}

/// A defect that people make, and its case in tests/verdicts/executed.tsv.
struct Defect {
  const char* title;
  const char* name;
};
constexpr Defect kDefects[] = {
    {"the mesh of a collision is missing",
     "link.arm.collision=plain-mesh/link.arm.collision.geometry.mesh@filename:missing"},
    {"its package is not known",
     "link.arm.collision=plain-mesh/link.arm.collision.geometry.mesh@filename:package"},
    {"it is a COLLADA file",
     "link.arm.collision=plain-mesh/link.arm.collision.geometry.mesh@filename:dae"},
    {"`scale` is one number", "link.arm.collision=mesh/link.arm.collision.geometry.mesh@scale:one"},
    {"`<colision>`", "link.arm.collision:misspelt"},
    {"`mass value=\"1.5 \"`", "link.arm.inertial.mass@value:trailing"},
    {"a decimal comma in a mass", "link.arm.inertial.mass@value:comma"},
    {"a moving link of mass 0", "link.wheel~massless"},
    {"a moving link without `inertial`", "link.wheel~without-inertial"},
    {"moments that no body has", "link.wheel~triangle"},
    {"a negative moment", "link.wheel~negative-moment"},
    {"a revolute joint without `limit`", "joint.shoulder.limit:dropped"},
    {"a limit without `effort`", "joint.shoulder.limit@effort:dropped"},
    {"`effort=\"0\"`", "joint.shoulder.limit@effort:zero"},
    {"an axis of length 0", "joint.shoulder.axis@xyz:zero"},
    {"two joints of one name", "joint.shoulder@name:as-rail"},
    {"a child that does not exist", "joint.shoulder.child@link:unknown"},
    {"two roots", "joint.plate_bolt:dropped"},
    {"a link with two parents", "tree:second-parent-fixed"},
    {"`mimic` of an unknown joint", "joint.knuckle.mimic@joint:unknown"},
    {"a spherical joint", "joint.shoulder@type:spherical"},
    {"`robot version=\"1.1\"`", "robot@version:1.1"},
    {"a material without a name", "link.arm.visual.material@name:dropped"},
    {"a colour above 1", "link.arm.visual.material.color@rgba:large"},
};

std::vector<std::string> split(const std::string& line, const std::string& separator) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = line.find(separator, begin)) != std::string::npos;) {
    parts.push_back(line.substr(begin, end - begin));
    begin = end + separator.size();
  }
  parts.push_back(line.substr(begin));
  return parts;
}

std::string without_patch(const std::string& reader) {
  const std::size_t end = reader.rfind('.');
  const std::string shorter = reader.substr(0, end);
  return shorter.find('.') == std::string::npos ? reader : shorter;
}

/// What the readers made of a robot with one of these defects.
void write_disagreements(std::ostream& page) {
  std::ifstream table(SMURF_ROOT "/tests/verdicts/executed.tsv");
  std::string line, versions;
  std::getline(table, line);
  std::getline(table, versions);
  std::getline(table, line);
  std::map<std::string, std::vector<std::string>> rows;
  while (std::getline(table, line)) {
    const std::vector<std::string> cells = split(line, "\t");
    rows[cells.front()] = cells;
  }
  page
      << "\n## What readers disagree on\n\n"
         "One robot, each time with one defect, as the readers were seen to load it: `refuses` and "
         "`crashes` as below, `other` is another robot than the undamaged one, silently or "
         "with a message, and `same` the same robot. MuJoCo and PyBullet look at no visuals here "
         "unless they are told to. For Drake, the meshes were OBJ files, because it refuses STL. "
         "All 7,829 robots stand in `tests/verdicts/executed.tsv`.\n\n| defect |";
  const std::vector<std::string> readers = split(versions.substr(2), ", ");
  for (const std::string& reader : readers) {
    std::string name = reader.substr(0, reader.find(' '));
    if (const auto dash = name.find('-'); dash != std::string::npos && name != "urdf-loader") {
      name.resize(dash);  // a second version of a reader is named after it
    }
    page << " " << name << " " << without_patch(reader.substr(reader.find(' ') + 1)) << " |";
  }
  page << "\n|---|";
  for (std::size_t i = 0; i < readers.size(); ++i) page << "---|";
  page << "\n";
  for (const Defect& defect : kDefects) {
    REQUIRE_MESSAGE(rows.contains(defect.name), defect.name);
    page << "| " << defect.title << " |";
    const std::vector<std::string>& cells = rows[defect.name];
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const bool is_plain = cells[i] == "refuses" || cells[i] == "crashes" || cells[i] == "same";
      page << " " << (is_plain ? cells[i] : "other") << " |";
    }
    page << "\n";
  }
}

/// "87 of 93 facts were run"
void write_share(std::ostream& page, const Reader& reader) {
  std::size_t all = 0, run = 0;
  const auto count = [&](const Fact& fact) {
    ++all;
    if (evidence_of(fact).find("run") != std::string::npos) ++run;
  };
  for (const Rule* rule : all_rules()) {
    for (const Fact& fact : rule->facts) {
      if (fact.reader == &reader) count(fact);
    }
  }
  for (const auto& [family, fact] : reader.families) count(fact);
  for (const Fact& fact : reader.unread) count(fact);
  if (all > 0) page << " Of its " << all << " facts, " << run << " were run, the others read.";
}

void write_reader(std::ostream& page, const Reader& reader) {
  page << "\n## " << reader.title;
  if (reader.is_target) page << " (`" << reader.name << "`)";
  page << "\n\nBasis: " << reader.basis << ".";
  if (reader.like != nullptr) {
    page << " Other facts are those of " << reader.like->title << ".";
  }
  write_share(page, reader);
  for (const auto releases : {reader.earlier, reader.releases}) {
    for (const Reader* release : releases) {
      page << "\n\n`" << release->name << "`: " << release->basis << ".";
    }
  }
  page << "\n\n| rule | where | effect | what the reader does | source |\n|---|---|---|---|---|\n";
  for (const Rule* rule : all_rules()) {
    for (const Fact& fact : rule->facts) {
      if (fact.reader == &reader) write_fact(page, rule->id, fact);
    }
  }
  for (const auto& [family, fact] : reader.families) write_fact(page, family.id(), fact);
  for (const Fact& fact : reader.unread) write_fact(page, "SML1", fact);
}

std::string readers_page() {
  std::ostringstream page;
  page << "# Readers\n\n"
          "What each program does with the defects that the rules find. Made from the facts in the "
          "rows of the rules by `readers_page_test`; do not edit.\n";
  write_disagreements(page);
  page
      << "\n## Facts\n\n"
         "`smurf-lint --target LIST` judges findings by these facts. The first matching fact of a "
         "reader applies. `where` names the place of the finding, then the case of its rule or the "
         "circumstances that the reader sees, then the versions of the reader. A "
         "target without a release, such as `ros`, means the oldest one that its developers support. Findings in parts of a URDF that the reader ignores are judged first (SML1xxx, "
         "except for malformed XML). A misspelt name is judged as both misspelt and missing; the "
         "worse effect applies. The effects, and the severities that they give a finding:\n\n"
         "| effect | the reader ... | severity |\n|---|---|---|\n"
         "| takes | reads it as intended | as if no reader had a problem |\n"
         "| ignores | does not use it, and nothing else changes | info |\n"
         "| changes | silently builds something else | warning |\n"
         "| loses | silently leaves a part of the robot out | warning |\n"
         "| breaks | reports an error and continues with the rest | error |\n"
         "| refuses | does not load the file | error |\n"
         "| crashes | ends or hangs | error |\n\n"
         "The worst effect among the targets applies. When all targets read a construct that other "
         "readers fail on, an error becomes a warning and a warning becomes an info. A finding "
         "stays an error while its effect on a target is unknown; the verdict is then `not known`. "
         "Findings without any fact keep their severity, and so do impossible bodies: a negative "
         "mass, an impossible inertia, a joint from a link to itself.\n\n"
         "Readers that open the URDF only are not judged by findings in annotations (SML3xxx, "
         "SML4xxx).\n";
  for (const Reader* reader : all_readers()) write_reader(page, *reader);
  return page.str();
}

}  // namespace

TEST_CASE("docs/readers.md is what the table of readers says") {
  test::check_page("readers.md", readers_page());
}
