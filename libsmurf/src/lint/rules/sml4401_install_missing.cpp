// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4401_install_missing_file {
namespace {

constexpr Circumstance kBuild{"build"};
constexpr Circumstance kName{"name"};

void check_fault(const SurroundingPackage& package, const InstallFault& one, Findings& findings) {
  switch (one.kind) {
  case InstallFault::Kind::not_installed:
    findings
        .report(one.span, "the folder " + quoted(one.what) + " is not installed, but " + one.other +
                              " needs a file in it")
        .help("add " + quoted(one.what) + " to the folders that are installed")
        .severity = package.is_ament ? Severity::warning : Severity::info;
    return;
  case InstallFault::Kind::no_folder: {
    Diagnostic& found = findings.report(one.span, "there is no folder " + quoted(one.what));
    found.severity = Severity::error;
    found.when(kBuild).help(one.other.empty() ? "correct the name, or delete it"
                                              : "did you mean " + quoted(one.other) + "?");
    return;
  }
  case InstallFault::Kind::glob_folder: {
    Diagnostic& found =
        findings.report(one.span, "the pattern matches " + quoted(one.what) +
                                      ", which is a folder in " + quoted(one.other));
    found.severity = Severity::error;
    found.when(kBuild).help("match files only, such as `*.stl`, and add an entry for the folder");
    return;
  }
  case InstallFault::Kind::glob_empty:
    findings
        .report(one.span,
                "no file matches " + quoted(one.what) + "; the folder has " + quoted(one.other))
        .help("correct the pattern");
    return;
  case InstallFault::Kind::wrong_package:
    findings
        .report(one.span, "files are installed for the package " + quoted(one.what) +
                              ", but this package is " + quoted(one.other))
        .help("write `share/" + one.other + "/...`");
    return;
  case InstallFault::Kind::no_xml: {
    Diagnostic& found = findings.report(one.span, "package.xml is not well-formed: " + one.what);
    found.severity = Severity::error;
    found.when(kBuild).help(one.other);
    found.note("launch files and what is installed are not checked");
    return;
  }
  case InstallFault::Kind::project_name: {
    Diagnostic& found =
        findings.report(one.span, "the project is " + quoted(one.what) +
                                      ", but package.xml names it " + quoted(one.other));
    found.severity = package.is_ament ? Severity::error : Severity::warning;
    found.when(kName)
        .label(package.name_span, "the name is here")
        .help("write the same name in both");
    return;
  }
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const SurroundingPackage& package : companions.surroundings.packages) {
    for (const InstallFault& one : package.faults) check_fault(package, one, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::breaks, "does not build the package", "CMake; setuptools",
     when(kBuild)},
    {&readers::ros, Effect::breaks, "does not build the package", "ament_package.cmake",
     when(kName)},
    {&readers::ros, Effect::breaks, "does not find the files after `colcon build`",
     "ament_index; resource_retriever"},
};

}  // namespace

extern constinit const Rule sml4401_install_missing{
    .id = "SML4401",
    .name = "install-missing",
    .severity = Severity::warning,
    .summary =
        "The build file of a package does not install what the robot or a launch file needs.",
    .why = "`package://` and `find-pkg-share` lead to the installed package, not to its sources.",
    .remedy = "Install the folders, in CMakeLists.txt or in `data_files` of setup.py.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4401_install_missing_file
