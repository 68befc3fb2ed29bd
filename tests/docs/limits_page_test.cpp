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
         "What a file may demand. Reaching a limit is a finding at its place, never a crash or a "
         "hang. Made from the table in `libsmurf/include/smurf/limits.hpp` by "
         "`limits_page_test`; do not edit.\n\n"
         "Every tool takes `--limit NAME=N`, with several separated by commas:\n\n"
         "    smurf-lint --limit yaml-depth=150,xml-depth=95 model.smurf\n\n"
         "A configuration cannot raise a limit, because it comes with the files that the limits "
         "are there for; configurations, schemas and what is in a COLLADA file have the usual "
         "values. When one annotation file, URDF or mesh is named, the models around it are looked "
         "at to find those that use it. There, a file of more than 8 MB, 50,000 values of YAML or "
         "100,000 elements and attributes of XML is passed over, and none of its contents is "
         "reported; a model that does use the file is then checked within the usual limits.\n\n"
         "XML entities are never expanded, so they need no limit. The time and memory of "
         "a simulation are bounded by `smurf-load-check --time-limit`.\n\n"
         "| limit | usually | at most | of what | more is | why |\n|---|---|---|---|---|---|\n";
  for (const LimitInfo& info : kLimits) {
    page << "| `" << info.name << "` | " << Limits{}.*info.value << " | " << info.most << " | "
         << info.counts << " | ";
    if (info.diagnostic.empty()) {
      page << "refused (exit code 2)";
    } else {
      page << "[" << info.diagnostic << "](rules.md#" << find_rule(info.diagnostic)->name << ")";
    }
    page << " | " << info.reason << " |\n";
  }
  return page.str();
}

}  // namespace

TEST_CASE("docs/limits.md is what the table of limits says") {
  test::check_page("limits.md", limits_page());
}
