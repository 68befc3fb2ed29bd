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
    return "[" + std::string(id) + "](rules.md#" + std::string(rule->name) + ")";
  }
  return std::string(id) + std::string(7 - id.size(), 'x');
}

void write_fact(std::ostream& page, std::string_view rules, const Fact& fact) {
  page << "| " << link_to(rules) << " | "
       << (fact.where.empty() ? "" : "`" + std::string(fact.where) + "`") << " | "
       << to_string(fact.effect) << " | " << fact.makes << " | " << evidence_of(fact) << " |\n";
}

void write_reader(std::ostream& page, const Reader& reader) {
  page << "\n## " << reader.title;
  if (reader.is_target) page << " (`" << reader.name << "`)";
  page << "\n\nBasis: " << reader.basis << ".";
  if (reader.like != nullptr) {
    page << " What is not said here is as for " << reader.like->title << ".";
  }
  page << "\n\n| rule | where | effect | what it makes of it | source |\n|---|---|---|---|---|\n";
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
         "What each reader makes of what the rules find. Made from the facts in the rows of the "
         "rules by `readers_page_test`; do not edit.\n\n"
         "`smurf-lint --target LIST` judges findings by these facts. The first fact of a reader "
         "that fits a finding counts; `where` is a part of its path, or after `#` the case of its "
         "rule; first of all come the parts of a URDF that it does not look at (SML1xxx, but for what "
         "is wrong with the XML). What is misspelt is judged as what is missing as well, by the worse of the two. "
         "The effects, and the severity they give a finding:\n\n"
         "| effect | the reader ... | severity |\n|---|---|---|\n"
         "| takes | reads it as it is meant | as if no reader stumbled |\n"
         "| ignores | has no use for it, and nothing else changes | info |\n"
         "| changes | silently makes something else of it | warning |\n"
         "| loses | silently leaves a part of the robot out | warning |\n"
         "| breaks | reports an error and goes on with the rest | error |\n"
         "| refuses | does not load the file | error |\n"
         "| crashes | ends or hangs | error |\n\n"
         "The worst of the targets counts. When none of them stumbles over what others stumble "
         "over, an error becomes a warning and a warning an info. An error stays one while it is "
         "not known what a target makes of it, and the verdict on that target is then `not "
         "known`. Findings about which nothing is known of any reader stay as they are, and so "
         "does what no body can be: a negative mass, an impossible inertia, a joint from a link "
         "to itself.\n\n"
         "Readers that open the URDF only are not asked about annotations (SML3xxx, "
         "SML4xxx).\n";
  for (const Reader* reader : all_readers()) write_reader(page, *reader);
  return page.str();
}

}  // namespace

TEST_CASE("docs/readers.md is what the table of readers says") {
  test::check_page("readers.md", readers_page());
}
