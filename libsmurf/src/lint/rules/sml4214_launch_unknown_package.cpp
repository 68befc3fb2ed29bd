// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4214_launch_unknown_package_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    for (const LaunchPackage& one : launch.misspelt_packages) {
      if (is_ros_package(one.name)) continue;  // SML4402: package.xml has the misspelling
      Diagnostic& found = findings.report(one.span, "the package " + quoted(one.name) +
                                                        " is neither here nor a dependency");
      found.help("did you mean " + quoted(one.similar) + "?");
      // In XML with entities, the place is the whole attribute.
      if (one.span.end - one.span.begin != one.name.size()) continue;
      found.fixes.push_back({Applicability::unsafe, {{one.span, one.similar}}});
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "ends the launch: the package is not found",
     "ament_index_python packages.py, launch_ros find_package.py"},
};

}  // namespace

extern constinit const Rule sml4214_launch_unknown_package{
    .id = "SML4214",
    .name = "launch-unknown-package",
    .severity = Severity::warning,
    .summary = "A launch file names a package that is not here, with a name like one that is.",
    .why = "A package is here if its folder is near the robot, or in a folder of packages.",
    .remedy = "Correct the name; if it is right, name the package in package.xml.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4214_launch_unknown_package_file
