// SPDX-License-Identifier: BSD-3-Clause
// docs/readers.md is made from the table of readers; this test fails when it is stale.
// SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <sstream>

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

void write_reader(std::ostream& page, const Reader& reader) {
  page << "\n## " << reader.title;
  if (reader.is_target) page << " (`" << reader.name << "`)";
  page << "\n\nBasis: " << reader.basis << ".";
  if (reader.like != nullptr) {
    page << " Other facts are those of " << reader.like->title << ".";
  }
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
  for (const auto& [family, fact] : reader.families) write_fact(page, family, fact);
  for (const Fact& fact : reader.unread) write_fact(page, "SML1", fact);
}

std::string readers_page() {
  std::ostringstream page;
  page
      << "# Readers\n\n"
         "What each program does with the defects that the rules find. Made from the facts in the "
         "rows of the rules by `readers_page_test`; do not edit.\n\n"
         "`smurf-lint --target LIST` judges findings by these facts. The first matching fact of a "
         "reader applies. `where` names the place of the finding, then the case of its rule or the "
         "circumstances that the reader sees, then the versions of the reader. A "
         "target without a release, such as `ros`, means the oldest one that is supported. Findings in parts of a URDF that the reader ignores are judged first (SML1xxx, "
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
