// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4402_install_dependency_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const SurroundingPackage& package : companions.surroundings.packages) {
    if (!package.is_ament) continue;
    std::set<std::string> used;
    for (const LaunchFile& launch : companions.surroundings.launch_files) {
      if (launch.package != package.name) continue;
      for (const LaunchNode& node : launch.nodes) {
        if (node.package.is_known) used.insert(node.package.text);
      }
      for (const LaunchDescription& one : launch.descriptions) {
        if (one.form == LaunchDescription::Form::command && one.program.text == "xacro")
          used.insert("xacro");
      }
    }
    std::vector<std::string_view> named;
    for (const auto& [name, place] : package.dependencies) {
      if (!is_ros_package(name)) named.push_back(name);
    }
    std::string missing;
    for (const std::string& one : used) {
      if (!is_ros_package(one) || package.dependencies.contains(one)) continue;
      if (const auto near = near_name(one, named)) {
        const Span place = package.dependencies.find(*near)->second;
        Diagnostic& found = findings.report(place, "the package depends on " + quoted(*near) +
                                                       ", but its launch files use " + quoted(one));
        found.severity = Severity::warning;
        found.help("write " + quoted(one));
        found.fixes.push_back({Applicability::unsafe, {{place, one}}});
        continue;
      }
      missing += (missing.empty() ? "" : ", ") + quoted(one);
    }
    if (missing.empty()) continue;
    findings
        .report(package.depend_span,
                "launch files use " + missing + ", which package.xml does not name")
        .help("add `<exec_depend>` for " + missing);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::ignores,
     "does not find the package on machines where rosdep installed the rest",
     "ament_index; rosdep"},
};

}  // namespace

extern constinit const Rule sml4402_install_dependency{
    .id = "SML4402",
    .name = "install-dependency",
    .severity = Severity::info,
    .summary = "A package uses programs of packages that its package.xml does not name.",
    .remedy = "Add `<exec_depend>` for each of them.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4402_install_dependency_file
