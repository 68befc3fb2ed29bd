// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "base/path.hpp"
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.main.files) return;
  std::map<std::string, Span> first;
  for (const Spanned<std::string>& file : *model.main.files) {
    const auto [found, is_new] = first.emplace(path::normalize(file.value), file.span);
    if (is_new) continue;
    Diagnostic& diagnostic =
        findings.report(file.span, "MARS reads " + quoted(file.value) + " twice");
    diagnostic.labels.push_back({found->second, "listed here before"});
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "merges it twice: every motor, sensor and light exists two times, under one name",
     "smurf_parser SMURFParser.cpp:43-69, run"},
};

}  // namespace

extern constinit const Rule sml2009_file_listed_twice{.id = "SML2009",
                                                      .name = "file-listed-twice",
                                                      .severity = Severity::error,
                                                      .summary = "`files` lists one file twice.",
                                                      .remedy = "List the file once.",
                                                      .check_model = check,
                                                      .facts = kFacts};

}  // namespace smurf::rules
