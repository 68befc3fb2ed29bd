// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/drake_language.hpp"

namespace smurf::rules::sml1451_drake_language_file {
namespace {

constexpr Circumstance kDrakeElement{"element of Drake", &readers::drake};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const xml::Document& document = model.robot->document;
  std::size_t count = 0;
  Span first;
  for (const xml::Element& element : document.elements) {
    if (!drake::is_own_name(element.name())) continue;
    if (count++ == 0) first = element.name_span();
  }
  if (count == 0) return;
  Diagnostic& diagnostic = findings.report(first, "only Drake reads this element");
  diagnostic.when(kDrakeElement);
  if (count > 1) {
    diagnostic.note(std::to_string(count - 1) + " more in this file");
  }
  diagnostic.help("check the elements of Drake with `--target drake`");
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::ignores, "ignores the elements of Drake", "urdfdom, sdformat, run"},
    {&readers::drake, Effect::takes, "reads its own elements", kRun, when(kDrakeElement)},
};

}  // namespace

extern constinit const Rule sml1451_drake_language{
    .id = "SML1451",
    .name = "drake-language",
    .severity = Severity::info,
    .summary = "A robot has elements that only Drake reads.",
    .why = "smurf-lint checks them with `--target drake` only.",
    .remedy = "Check the file with `--target drake`, or leave the elements out.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1451_drake_language_file
