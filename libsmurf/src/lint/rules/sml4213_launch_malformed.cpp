// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4213_launch_malformed_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    if (!launch.fault) return;
    const std::string_view form = launch.form == LaunchFile::Form::python ? "Python"
                                  : launch.form == LaunchFile::Form::yaml ? "YAML"
                                                                          : "XML";
    Diagnostic& found = findings.report(launch.fault->span, launch.fault->message);
    found.note("launch files must be well-formed " + std::string(form));
    found.help(launch.fault->help.empty() ? "correct the syntax here" : launch.fault->help);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "cannot read the launch file, and starts nothing",
     "launch_xml and launch_yaml parser.py, read; ElementTree, PyYAML and ast of CPython 3.11, run"},
};

}  // namespace

extern constinit const Rule sml4213_launch_malformed{.id = "SML4213",
                                                     .name = "launch-malformed",
                                                     .severity = Severity::error,
                                                     .summary =
                                                         "A launch file is no Python, XML or YAML.",
                                                     .remedy = "Correct the syntax at the place.",
                                                     .check_companions = check,
                                                     .facts = kFacts};

}  // namespace smurf::rules::sml4213_launch_malformed_file
