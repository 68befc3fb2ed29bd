// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "lint/mesh_queries.hpp"

namespace smurf::rules::sml1630_mesh_units_file {
namespace {

constexpr double kTiny = 0.001;  // m; what nobody sees
constexpr double kScenery = 20;  // times as long as a part of a robot may be: 1 km

/// Whether a link is of a static model of SDF, such as a building, which may be large.
bool is_static_scenery(const LinkedModel& model, const urdf::Link& link) {
  if (model.language != Language::sdf || !link.name) return false;
  const auto index = model.link_names.find(*link.name);
  const auto joint = index ? model.tree.parent_joint[*index] : std::nullopt;
  if (!joint) return false;
  const auto parent = model.tree.joint_parent[to_size(*joint)];
  if (!parent || model.robot->links[to_size(*parent)].name.value_or("") != "world") return false;
  return model.robot->joints[to_size(*joint)].type == urdf::JointType::fixed;
}

double extent(const Box& box) {
  const Vector3 size = box.size();
  return std::max({size[0], size[1], size[2]});
}

/// Meshes that look wrong in the same way, by the size of the first.
struct Suspects {
  const OpenedMesh* first = nullptr;
  double extent = 0;
  std::size_t files = 0;
};

/// What the header of a COLLADA says about the unit.
void add_header_unit(const MeshFacts& facts, bool is_huge, Diagnostic& diagnostic) {
  if (facts.format != MeshFormat::collada) return;
  const double unit = facts.unit_meters.value_or(1);
  if (is_huge && unit == 1) {
    diagnostic.note(facts.unit_meters ? "its header says that its unit is the metre"
                                      : "its header has no `unit`, which means the metre");
  } else if (!is_huge && unit < 1) {
    diagnostic.note("its header says that its unit is " + format_rounded(unit, 4) +
                    " m, which most readers apply besides `scale`");
  }
}

void report(const Suspects& suspects, bool is_huge, Findings& findings) {
  if (suspects.first == nullptr) return;
  const urdf::Mesh& mesh = *suspects.first->uses.front().mesh();
  Diagnostic& diagnostic = findings.report(
      mesh.filename.span, "the mesh is " + format_rounded(suspects.extent, 3) + " m long");
  diagnostic.caret = is_huge ? "in millimetres?" : "scaled twice?";
  if (mesh.scale) {
    diagnostic.label(mesh.scale.span, "with this scale");
  } else if (is_huge) {
    diagnostic.help("write scale=\"0.001 0.001 0.001\" if the file is in millimetres");
  }
  add_header_unit(suspects.first->facts, is_huge, diagnostic);
  if (suspects.files > 1) {
    diagnostic.note("this applies to " + std::to_string(suspects.files) + " mesh files");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<OpenedMesh> meshes = opened_meshes(model);
  Suspects huge;
  Suspects tiny;
  for (const OpenedMesh& mesh : meshes) {
    const std::optional<Box> box = bounding_box(model, mesh.uses.front().geometry);
    if (!box) continue;
    const double size = extent(*box);
    const bool is_scenery = is_static_scenery(model, mesh.uses.front().link);
    if (size <= findings.tolerance() * (is_scenery ? kScenery : 1) && (size >= kTiny || size == 0))
      continue;
    Suspects& suspects = size > findings.tolerance() ? huge : tiny;
    if (suspects.first == nullptr) suspects = {&mesh, size, 0};
    ++suspects.files;
  }
  report(huge, true, findings);
  report(tiny, false, findings);
}

}  // namespace

extern constinit const Rule sml1630_mesh_units{
    .id = "SML1630",
    .name = "mesh-units",
    .severity = Severity::warning,
    .summary = "A mesh is longer than 50 m or shorter than 1 mm with its scale.",
    .why =
        "URDF lengths are in metres, and CAD programs write millimetres: the robot is a thousand times too large or, when it is scaled twice, too small to see.",
    .remedy = "Correct `scale`, or export the mesh in metres.",
    .sources =
        "40 of 322 public URDFs scale by 0.001; rerun issue 11290 and pinocchio issue 1370 are "
        "such cases.",
    .check_model = check,
    .tolerance = {.value = 50, .unit = "m", .meaning = "how large a mesh may be"},
    .about = About::robot};

}  // namespace smurf::rules::sml1630_mesh_units_file
