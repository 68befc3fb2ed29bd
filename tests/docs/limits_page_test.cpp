// SPDX-License-Identifier: BSD-3-Clause
// docs/limits.md is made from the table of limits; this test fails when it is stale.
// SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <sstream>

#include "docs/page.hpp"
#include "smurf/limits.hpp"
#include "smurf/lint.hpp"

using namespace smurf;

namespace {

std::string limits_page() {
  std::ostringstream page;
  page
      << "# Limits\n\n"
         "The tools limit the size and the depth of their input. Exceeding a limit is a finding at "
         "its place, never a crash or a hang. This page is made from the table in "
         "`libsmurf/include/smurf/limits.hpp` by `limits_page_test`; do not edit.\n\n"
         "Every tool has the option `--limit NAME=N`; separate several limits by commas:\n\n"
         "    smurf-lint --limit yaml-depth=150,xml-depth=95 model.smurf\n\n"
         "`--limit help` lists the limits. A configuration cannot raise them, because it comes with "
         "the files that the limits guard against. Configurations, schemas and COLLADA files always "
         "have the defaults.\n\n"
         "When one annotation file, URDF or mesh is named, smurf-lint searches the models around it "
         "for those that use it. In this search it ignores files of more than 8 MB, 50,000 values of "
         "YAML or 100,000 elements and attributes of XML, without a report. A model that uses the "
         "file is then checked with the limits below.\n\n"
         "Behind the limits there is a clock: a file that takes more than 120 seconds of processor "
         "time, with all that it loads, is left, and reported as "
      << test::link_to(*find_rule("SML0002"))
      << ". `--max-seconds N` (`max_seconds=` in Python) changes that; 0 means no end. In editors, "
         "a request ends after 30 seconds.\n\n"
         "XML entities are never expanded, so they need no limit. `smurf-load-check --time-limit` "
         "and `--memory-limit` bound a simulation.\n\n"
         "| limit | default | at most | of what | an excess is | why |\n|---|---|---|---|---|---|\n";
  for (const LimitInfo& info : kLimits) {
    page << "| `" << info.name << "` | " << Limits{}.*info.value << " | " << info.most << " | "
         << info.counts << " | ";
    if (info.diagnostic.empty()) {
      page << (info.name == "suggestions" ? "a note in the finding" : "refused (exit code 2)");
    } else {
      page << test::link_to(*find_rule(info.diagnostic));
    }
    page << " | " << info.reason << " |\n";
  }
  return page.str();
}

}  // namespace

TEST_CASE("docs/limits.md is what the table of limits says") {
  test::check_page("limits.md", limits_page());
}
