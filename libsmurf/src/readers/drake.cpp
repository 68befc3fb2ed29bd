// SPDX-License-Identifier: BSD-3-Clause
// Drake, which has its own URDF reader.
#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "readers/circumstances.hpp"

namespace smurf::readers::drake_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18",
     {&drake, refuses,
      "reads the numbers up to the first unreadable character, and refuses a scale of 0", kRun,
      at("mesh/@scale").when(cases::kEnoughRead, cases::kReadsZero)}},
    {"SML18",
     {&drake, changes, "reads the numbers up to the first unreadable character", kRun,
      when(cases::kEnoughRead)}},
    {"SML18",
     {&drake, refuses, "cannot read as many numbers as it needs, and refuses the file", kRun}},
};

constexpr std::string_view kIgnores = "does not look at it";

constexpr Fact kUnread[] = {
    {&drake, ignores, "does not read what `drake_ignore` marks", kRun, when(kDrakeIgnored)},
    {&drake, ignores, kIgnores, kRun, at("calibration")},
    {&drake, ignores, kIgnores, kRun, at("safety_controller")},
    {&drake, ignores, kIgnores, kRun, at("gazebo")},
    {&drake, ignores, kIgnores, kRun, at("joint/axis").when(kInFixed)},
    {&drake, ignores, kIgnores, kRun, at("joint/axis").when(kInFloating)},
    {&drake, ignores, kIgnores, kRun, at("joint/limit").when(kInFixed)},
    {&drake, ignores, kIgnores, kRun, at("joint/limit").when(kInFloating)},
    {&drake, ignores, kIgnores, kRun, at("joint/dynamics").when(kInFixed)},
    {&drake, ignores, kIgnores, kRun, at("joint/dynamics").when(kInFloating)},
};

/// Findings in links and joints with `drake_ignore="true"`.
void see(const LinkedModel& model, std::span<Diagnostic* const> found) {
  std::vector<Span> ignored;  // in the order of the file
  for (const xml::View element : model.robot->document.view()) {
    const xml::Attribute* mark = element.attribute("drake_ignore");
    if (mark != nullptr && mark->value() == "true") ignored.push_back(element.span());
  }
  if (ignored.empty()) return;
  for (Diagnostic* finding : found) {
    const std::uint32_t begin = finding->span.begin;
    const auto behind =
        std::upper_bound(ignored.begin(), ignored.end(), begin,
                         [](std::uint32_t place, const Span& span) { return place < span.begin; });
    if (behind == ignored.begin() || begin >= std::prev(behind)->end) continue;
    finding->when(kDrakeIgnored);
  }
}

}  // namespace

extern constinit const Reader drake{.name = "drake",
                                    .title = "Drake",
                                    .basis = "1.51.1 executed, the rest read at be259df (2026-08)",
                                    .like = &urdf,
                                    .version = "Drake 1.51.1",
                                    .families = kFamilies,
                                    .unread = kUnread,
                                    .see = see};

}  // namespace smurf::readers::drake_file
