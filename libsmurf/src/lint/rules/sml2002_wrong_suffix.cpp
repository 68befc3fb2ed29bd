// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml2002_wrong_suffix_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.main.files || !model.is_complete) return;  // another rule reports a missing file
  for (const Spanned<std::string>& file : *model.main.files) {
    const std::string_view extension = path::extension(file.value);
    const std::string lower = path::to_lower(extension);
    std::string_view expected;
    if (lower == ".urdf") expected = ".urdf";
    if (lower == ".yml" || lower == ".yaml" || lower == ".json") expected = ".yml";
    if (expected.empty() || extension == expected) continue;
    Diagnostic& diagnostic =
        findings.report(file.span, "MARS does not read files that end in " + quoted(extension));
    if (expected == ".urdf") diagnostic.when(cases::kTheUrdf);
    diagnostic.help("rename the file so that it ends in " + quoted(expected));
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "finds no URDF and dereferences a null pointer",
     "smurf_parser SMURFParser.cpp:49-52, run", when(cases::kTheUrdf)},
    {&readers::mars, Effect::loses, "ignores the file", "smurf_parser SMURFParser.cpp:49-52, run"},
};

}  // namespace

extern constinit const Rule sml2002_wrong_suffix{
    .id = "SML2002",
    .name = "wrong-suffix",
    .severity = Severity::error,
    .summary = "`files` lists a file whose ending MARS does not recognise.",
    .remedy = "Rename the file to .yml or .urdf.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2002_wrong_suffix_file
