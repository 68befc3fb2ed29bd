// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4213_launch_malformed_file {
namespace {

using Kind = LaunchMistake::Kind;

constexpr Circumstance kWords{"words"};
constexpr Circumstance kUnset{"unset"};
constexpr Circumstance kValue{"value"};

const Circumstance& circumstance_of(Kind kind) {
  return kind == Kind::unset ? kUnset : kind == Kind::value ? kValue : kWords;
}

void check_mistakes(const LaunchFile& launch, Findings& findings) {
  std::set<std::pair<std::uint32_t, std::string_view>> told;
  for (const LaunchMistake& one : launch.mistakes) {
    if (one.kind == Kind::program) continue;  // SML4202
    // A file that includes this one may set its arguments.
    if (one.is_doubtful && launch.is_included) continue;
    if (!told.emplace(one.span.begin, one.message).second) continue;
    Diagnostic& found = findings.report(one.span, one.message);
    found.when(circumstance_of(one.kind)).help(one.help);
    if (one.is_doubtful) found.severity = Severity::warning;
    if (one.replacement.empty()) continue;
    found.fixes.push_back({Applicability::unsafe, {{one.span, one.replacement}}});
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    if (!launch.fault) return check_mistakes(launch, findings);
    const std::string_view form = launch.form == LaunchFile::Form::python ? "Python"
                                  : launch.form == LaunchFile::Form::yaml ? "YAML"
                                                                          : "XML";
    Diagnostic& found = findings.report(launch.fault->span, launch.fault->message);
    found.note("launch files must be well-formed " + std::string(form));
    found.help(launch.fault->help.empty() ? "correct the syntax here" : launch.fault->help);
  });
}

constexpr std::string_view kRun =
    "launch 1.0.7, 3.4.3 and 3.7.1, launch_ros 0.19.8, 0.26.6 and 0.28.0, run";

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "cannot read the launch file, and starts nothing", kRun,
     when(kWords)},
    {&readers::ros, Effect::breaks, "ends the launch, unless somebody gives the argument", kRun,
     when(kUnset)},
    {&readers::ros, Effect::breaks, "ends the launch at this action", kRun, when(kValue)},
    {&readers::ros, Effect::breaks, "cannot read the launch file, and starts nothing",
     "launch_xml and launch_yaml parser.py, ElementTree, PyYAML and ast of CPython 3.11, run"},
};

}  // namespace

extern constinit const Rule sml4213_launch_malformed{
    .id = "SML4213",
    .name = "launch-malformed",
    .severity = Severity::error,
    .summary = "A launch file is no Python, XML or YAML, or executing it ends with an error.",
    .why =
        "launch reads all of a file before it starts anything: one misspelt word ends it, and `default: true` of YAML is no text. An argument must be declared above its first use, and a condition is `true`, `false`, `1` or `0`, in any case.",
    .remedy = "Correct the file at the place.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4213_launch_malformed_file
