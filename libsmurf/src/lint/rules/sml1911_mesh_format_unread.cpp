// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_set>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1911_mesh_format_unread_file {
namespace {

constexpr Circumstance kMixedCase{"mixed case"};
constexpr Circumstance kAbsent{"no such file"};
constexpr Circumstance kObj{"obj"}, kStl{"stl"}, kMsh{"msh"}, kDae{"dae"}, kVtk{"vtk"}, kCdf{"cdf"},
    kGlb{"glb"}, kGltf{"gltf"}, kBobj{"bobj"}, kWrl{"wrl"}, kPly{"ply"}, kOff{"off"};
/// Those of which MuJoCo recognises only extensions in one case come first.
constexpr const Circumstance* kKnown[] = {&kObj, &kStl,  &kMsh,  &kDae, &kVtk, &kCdf,
                                          &kGlb, &kGltf, &kBobj, &kWrl, &kPly, &kOff};
constexpr std::size_t kOfMujoco = 3;

/// The format of a mesh, by its extension.
struct Format {
  std::string extension;                ///< in lower case; empty if there is none
  const Circumstance* known = nullptr;  ///< if facts are about it
  bool is_mixed = false;                ///< "base.Stl"

  friend bool operator<(const Format& a, const Format& b) {
    return std::tie(a.extension, a.is_mixed) < std::tie(b.extension, b.is_mixed);
  }
};

Format format_of(std::string_view filename) {
  const std::string_view written = path::extension(filename);
  if (written.size() < 2) return {};
  const std::string extension(written.substr(1));
  Format format{path::to_lower(extension)};
  const auto known =
      std::find_if(std::begin(kKnown), std::end(kKnown),
                   [&](const Circumstance* one) { return one->name == format.extension; });
  if (known == std::end(kKnown)) return format;
  format.known = *known;
  const bool has_lower = ranges::any_of(extension, [](char c) { return c >= 'a' && c <= 'z'; });
  format.is_mixed = known - std::begin(kKnown) < static_cast<std::ptrdiff_t>(kOfMujoco) &&
                    has_lower && extension != format.extension;
  return format;
}

std::string message(const std::string& what, const Format& format) {
  if (format.extension.empty()) return "the mesh of a " + what + " has no extension";
  return "the mesh of a " + what + " is a ." + format.extension + " file";
}

void check(const LinkedModel& model, Findings& findings) {
  std::unordered_set<std::string_view> existing;
  for (const MeshReference& mesh : model.meshes) {
    if (mesh.exists) existing.insert(mesh.filename);
  }
  // One finding per format, because a robot has dozens of meshes.
  std::map<std::pair<GeometryRole, Format>, std::vector<Span>> uses;
  std::set<std::pair<GeometryRole, Format>> opened;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.mesh() == nullptr || !use.mesh()->filename) return;
    const std::string& filename = *use.mesh()->filename;
    if (trimmed(filename).empty()) return;
    const std::pair key(use.role, format_of(filename));
    uses[key].push_back(use.mesh()->filename.span);
    if (existing.contains(filename)) opened.insert(key);
  });
  for (const auto& [key, places] : uses) {
    const auto& [role, format] = key;
    const std::string what = std::string(to_string(role));
    Diagnostic& diagnostic = findings.report(places.front(), message(what, format));
    if (format.known != nullptr) diagnostic.when(*format.known);
    if (!opened.contains(key)) diagnostic.when(kAbsent);
    if (format.is_mixed) diagnostic.when(kMixedCase);
    if (places.size() > 1) {
      diagnostic.note("the same applies to those of " + std::to_string(places.size() - 1) +
                      " more " + what + (places.size() > 2 ? "s" : ""));
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "reads it", kRun, when(kObj)},
    {&readers::pybullet, Effect::takes, "reads it", kRun, when(kDae)},
    {&readers::pybullet, Effect::takes, "reads it", kRun, when(kStl)},
    {&readers::pybullet, Effect::loses, "leaves the shape out", kRun, when(kVtk)},
    {&readers::pybullet, Effect::takes, "reads it", "Bullet UrdfFindMeshFile.h", when(kCdf)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot",
     "Bullet UrdfFindMeshFile.h, run"},
    {&readers::ros, Effect::loses, "has no loader for it: RViz and MoveIt show the link without it",
     "assimp 5.2", when(kBobj)},
    {&readers::ros, Effect::loses, "has no loader for it: RViz and MoveIt show the link without it",
     "assimp 5.2", when(kWrl)},
    {&readers::gazebo, Effect::loses, "has no loader for it", "sdformat stores it unchecked",
     when(kBobj)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kBobj)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kWrl)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kMsh)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kVtk)},
    {&readers::dart, Effect::refuses, "cannot load the shape, and refuses the file", kRun,
     when(kCdf)},
    {&readers::mujoco, Effect::refuses,
     "recognises an extension only when it is all lower case or all upper case", kRun,
     when(kMixedCase)},
    {&readers::mujoco, Effect::takes, "reads it", kRun, when(kObj)},
    {&readers::mujoco, Effect::takes, "reads it", kRun, when(kStl)},
    {&readers::mujoco, Effect::takes, "reads it", kRun, when(kMsh)},
    {&readers::mujoco, Effect::refuses, "has no decoder for it, and refuses the model", kRun},
    {&readers::drake, Effect::takes, "reads it", kRun, when(kObj)},
    {&readers::drake, Effect::takes, "reads it", "Drake make_convex_hull_mesh_impl.cc:279-291",
     when(kVtk)},
    {&readers::drake, Effect::takes, "reads it", kRun, when(kGltf)},
    {&readers::drake, Effect::refuses, "throws when it needs the hull of the mesh", kRun,
     at("collision")},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun,
     when(kBobj)},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun,
     when(kWrl)},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun,
     when(kMsh)},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun,
     when(kVtk)},
    {&readers::pinocchio, Effect::refuses, "cannot load the mesh, and refuses the shapes", kRun,
     when(kCdf)},
    {&readers::newton, Effect::ignores, "finds no file to read", kRun, when(kAbsent)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kObj)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kStl)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kDae)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kGlb)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kGltf)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kVtk)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kPly)},
    {&readers::newton, Effect::takes, "reads it", kRun, when(kOff)},
    {&readers::newton, Effect::refuses, "refuses the file: it cannot load the mesh", kRun},
    {&readers::isaac, Effect::takes, "reads it", kRun, when(kObj)},
    {&readers::isaac, Effect::takes, "reads it", kRun, when(kStl)},
    {&readers::isaac, Effect::takes, "reads it", kRun, when(kDae)},
    isaac_without_mesh(),
};

}  // namespace

extern constinit const Rule sml1911_mesh_format_unread{
    .id = "SML1911",
    .name = "mesh-format-unread",
    .severity = Severity::error,
    .summary = "A mesh is in a format that a target does not read.",
    .why = "URDF does not say which mesh formats a reader must support.",
    .remedy = "Convert the mesh; .obj is read by all of them.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1911_mesh_format_unread_file
