// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/imported_robot.hpp"
#include "lint/mesh_queries.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1610_mesh_uri_scheme_file {
namespace {

constexpr Circumstance kModel{"model"};
constexpr Circumstance kNetwork{"of the network"};
constexpr Circumstance kFound{"found"};
constexpr Circumstance kAbsolute{"absolute"};  ///< `file:///...`
/// `file:///$(find PACKAGE)/...`, expanded
constexpr Circumstance kFourSlashes{"four slashes"};

bool has_foreign_scheme(std::string_view path) {
  return path.find("://") != std::string_view::npos && !path.starts_with("package://");
}

/// One finding for meshes, because exporters write all alike, and one for textures, which readers
/// can do without.
void report(const MeshReference& reference, Findings& findings) {
  const bool is_absolute = reference.filename.starts_with("file:///");
  const std::string scheme = reference.filename.substr(0, reference.filename.find("://") + 3);
  // Not the whole path: that of `$(find PACKAGE)` is absolute.
  Diagnostic& finding = findings.report_habit(
      reference.span,
      reference.is_texture
          ? "some readers find no texture by a path that begins with " + quoted(scheme)
          : "MuJoCo and MARS refuse paths of meshes that begin with " + quoted(scheme),
      "such paths", reference.is_texture ? 1 : 0);
  const bool is_found = reference.exists && !lies_outside(reference);
  if (reference.filename.starts_with("model://")) finding.when(kModel);
  if (reference.filename.starts_with("http")) finding.when(kNetwork);
  if (is_found) finding.when(kFound);
  if (is_absolute) finding.when(kAbsolute);
  if (reference.filename.starts_with("file:////")) finding.when(kFourSlashes);
  if (!reference.exists || !is_absolute) return;
  // Where `$(find PACKAGE)` stands behind it in a xacro, only these two readers mind.
  finding.severity = is_found ? Severity::info : Severity::warning;
  if (is_found) return;
  finding.note("it lies outside of the project, and was not looked up")
      .note("absolute paths lead to nothing on other machines")
      .help("write `package://NAME/PATH`, or a path relative to the URDF");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const MeshReference& reference : model.meshes) {
    // In an SDF, it is how a mesh is named.
    if (reference.filename.starts_with("model://") && is_of_other_language(model)) continue;
    // SML1009 reports what was not expanded, and has the cure.
    if (reference.filename.find("$(") != std::string::npos) continue;
    if (has_foreign_scheme(reference.filename)) report(reference, findings);
  }
}

constexpr Where kOpened = when(kAbsolute, kFound);

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::takes, "opens the file", kRun, kOpened},
    {&readers::drake, Effect::takes, "looks for it as for a package", kRun, when(kModel, kFound)},
    {&readers::pybullet, Effect::takes, "does without a texture", kRun, at("texture")},
    {&readers::pinocchio, Effect::takes, "does not look at textures", kRun,
     at("texture").unless(kNetwork)},
    {&readers::dart, Effect::takes, "opens the file", kRun, kOpened},
    {&readers::ros, Effect::takes, "opens the file", "resource_retriever", kOpened},
    {&readers::gazebo, Effect::takes, "opens the file", "sdformat keeps the address, run", kOpened},
    {&readers::isaac, Effect::takes, "opens the file", kRun, when(kFound).unless(kModel)},
    {&readers::isaac, Effect::refuses, "refuses the address of a texture", kRun,
     at("texture").unless(kAbsolute)},
    {&readers::pybullet, Effect::takes, "opens the file", kRun, when(kFound)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::mars, Effect::loses,
     "treats the scheme as a part of the path, and shows the link without it",
     "MARS smurf.cpp:1080-1113, run", at("visual")},
    {&readers::mars, Effect::refuses, "treats the scheme as a part of the path",
     "MARS misc.cpp:112-131"},
    {&readers::dart, Effect::refuses, "has no retriever for the scheme, and refuses the file", kRun,
     when(kModel)},
    {&readers::dart, Effect::refuses,
     "finds no file, or no retriever for the scheme, and refuses the model", kRun},
    kMujocoLooksBeside,
    {&readers::mujoco, Effect::refuses, "treats the scheme as a part of the path", kRun},
    ros_without_mesh(),
    {&readers::gazebo, Effect::loses, "does not look for the file, and may leave the shape out",
     "sdformat parser_urdf.cc:2416-2431"},
    {&readers::phobos, Effect::loses, "keeps a mesh that it cannot open", kRun},
    {&readers::pinocchio, Effect::takes, "opens the file", kRun, kOpened},
    {&readers::pinocchio, Effect::takes, "looks in the folders of packages that it was given", kRun,
     when(kModel, kFound)},
    {&readers::pinocchio, Effect::refuses,
     "looks for it in the folder where the program runs, and refuses the shapes", kRun,
     when(kFound)},
    {&readers::pinocchio, Effect::refuses, "does not find the mesh, and refuses the shapes", kRun},
    newton_without_mesh(when(kModel)),
    {&readers::newton, Effect::refuses, "refuses a URI with four slashes", kRun,
     when(kFourSlashes)},
    {&readers::newton, Effect::takes, "opens the file", kRun, kOpened},
    newton_without_mesh(when(kAbsolute)),
    {&readers::newton, Effect::refuses,
     "refuses a file of a relative URI, and one that it cannot download", kRun},
    isaac_without_mesh(),
};

}  // namespace

extern constinit const Rule sml1610_mesh_uri_scheme{
    .id = "SML1610",
    .name = "mesh-uri-scheme",
    .severity = Severity::error,
    .summary = "A mesh path has a scheme that some readers do not support.",
    .why = "Most readers know `package://` and `file://` only.",
    .remedy = "Write a path relative to the URDF.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1610_mesh_uri_scheme_file
