// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "base/text/suggest.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1651_package_unknown_file {
namespace {

/// The files lie in a package with another name.
constexpr Circumstance kOtherName{"other name"};
/// The folder of the package has its name, and stands above the URDF.
constexpr Circumstance kAbove{"folder above"};
constexpr std::string_view kScheme = "package://";

/// A fix that renames the package in all its addresses.
Fix rename(const std::vector<const MeshReference*>& uses, std::string_view name,
           const std::string& to) {
  Fix fix;
  for (const MeshReference* use : uses) {
    PathUses one{use->filename, {use}};
    const std::string filename =
        std::string(kScheme) + to + use->filename.substr(kScheme.size() + name.size());
    for (Edit& edit : rewrite(one, filename, Applicability::unsafe).edits) {
      fix.edits.push_back(std::move(edit));
    }
  }
  return fix;
}

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, std::vector<const MeshReference*>> packages;
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.is_package_guessed) packages[package_of(mesh.filename)].push_back(&mesh);
  }
  for (const auto& [name, uses] : packages) {
    const std::string& there = uses.front()->package_there;
    const std::string_view known[] = {there};
    Diagnostic& diagnostic =
        findings.report(uses.front()->span, "no package is called " + quoted(name));
    diagnostic.caret = "found from a folder above the URDF, whatever its name";
    if (uses.size() > 1) {
      diagnostic.note("the URDF names " + std::to_string(uses.size()) + " files of it");
    }
    const bool is_above = std::all_of(uses.begin(), uses.end(), [](const MeshReference* use) {
      return ("/" + use->path).ends_with("/" + use->filename.substr(kScheme.size()));
    });
    if (is_above) diagnostic.when(kAbove);
    if (there.empty()) {
      diagnostic.severity = Severity::info;
      diagnostic.when(kUncertain);
      diagnostic.help("write a package.xml with this name, or name its folder: `--package " +
                      std::string(name) + "=DIR`");
      continue;
    }
    diagnostic.when(kOtherName);
    const bool is_near = nearest(name, known).has_value();
    if (is_near) diagnostic.severity = Severity::error;
    diagnostic.help((is_near ? "did you mean " : "the files lie in the package ") + quoted(there) +
                    (is_near ? ", the name in the package.xml?" : ", by its package.xml"));
    diagnostic.fixes.push_back(rename(uses, name, there));
  }
}

constexpr std::string_view kShowsNothing = "finds no such package: RViz and MoveIt show nothing";

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses, kShowsNothing, "resource_retriever, by the name in package.xml",
     when(kOtherName)},
    {&readers::ros, Effect::loses, "shows nothing, unless another folder holds the package",
     "urdfdom opens no meshes, run; package folders depend on the machine"},
    {&readers::dart, Effect::refuses, "finds only packages whose folders it was given", kRun},
    {&readers::gazebo, Effect::loses, "finds no such package, and shows nothing",
     "sdformat keeps the address unchecked", when(kOtherName)},
    {&readers::drake, Effect::refuses, "knows no such package, and refuses the file", kRun},
    {&readers::pybullet, Effect::takes, "looks in the folders above the URDF", kRun, when(kAbove)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun, at("mesh")},
    {&readers::pinocchio, Effect::refuses, "finds only packages whose folders it was given", kRun,
     at("mesh")},
    {&readers::newton, Effect::takes, "looks three folders above the URDF, too", kRun,
     when(kAbove)},
    newton_without_mesh(at("mesh")),
    {&readers::isaac, Effect::takes, "looks for the rest of the path in the folders above the URDF",
     kRun},
};

}  // namespace

extern constinit const Rule sml1651_package_unknown{
    .id = "SML1651",
    .name = "package-unknown",
    .severity = Severity::warning,
    .summary = "A file is named by `package://` with the name of no known package.",
    .why =
        "ROS looks packages up by the name in their package.xml. The folder of the file does not matter.",
    .remedy = "Write the name in the package.xml, or name the folder with `--package NAME=DIR`.",
    .sources = "cartographer_ros issue 19, tianracer issue 8.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1651_package_unknown_file
