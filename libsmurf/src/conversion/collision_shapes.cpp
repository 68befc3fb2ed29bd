// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/collision_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "convert/xml_edits.hpp"
#include "mesh/fitted_shapes.hpp"
#include "render/printable.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostParts = 32;
/// Parts and lighter meshes that gain or lose more than this part of the volume are tried again,
/// finer.
constexpr double kEnough = 0.05;
/// Of CoACD, the coarsest first; 0.05 is its default.
constexpr double kConcavities[] = {0.05, 0.02, 0.01};
/// A finer division that is not better by this factor is not followed by a still finer one.
constexpr double kBetter = 0.8;

/// As fine as half of all public collision meshes (docs/rules/sml16.md, mesh-triangles).
constexpr std::size_t kFewTriangles = 1000;
/// How far a lighter mesh may be from its original, as a part of its size.
constexpr double kNear = 0.001;
constexpr double kFar[] = {0.01, 0.003, 0.001};

CollisionBody body_of(const ConvexMesh& hull) {
  CollisionBody body{hull.points, {}};
  for (const auto& triangle : hull.triangles)
    body.indices.insert(body.indices.end(), triangle.begin(), triangle.end());
  return body;
}

std::string obj_of(const CollisionBody& body) {
  std::string text;
  for (const Vector3& point : body.points) {
    text += 'v';
    for (const double x : point) text += ' ' + shortest(static_cast<float>(x));
    text += '\n';
  }
  for (std::size_t i = 0; i + 2 < body.indices.size(); i += 3) {
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) text += ' ' + std::to_string(body.indices[i + k] + 1);
    text += '\n';
  }
  return text;
}

void add_box(const ConvexMesh& hull, NewShapes& made) {
  const FittedBox box = fitted_box(hull);
  made.about.volume = box.volume();
  made.shapes.push_back(
      {"", new_element("box", {{"size", numbers_text(box.size)}}), box.X_MB, true, ""});
}

void add_capsule(const ConvexMesh& hull, bool has_capsules, NewShapes& made) {
  const FittedCapsule capsule = fitted_capsule(hull);
  made.about.volume = capsule.volume();
  const std::string radius = format_number(capsule.radius);
  const std::string ball = new_element("sphere", {{"radius", radius}});
  if (!(capsule.length > 0)) {
    made.shapes.push_back({"", ball, {capsule.X_MC.position, {}}, true, ""});
    return;
  }
  const Attributes sizes{{"radius", radius}, {"length", format_number(capsule.length)}};
  made.shapes.push_back(
      {"", new_element(has_capsules ? "capsule" : "cylinder", sizes), capsule.X_MC, true, ""});
  if (has_capsules) return;
  for (const auto& [ending, z] :
       {std::pair{"_top", capsule.length / 2}, std::pair{"_bottom", -capsule.length / 2}}) {
    made.shapes.push_back({"", ball, capsule.X_MC * Pose{{0, 0, z}, {}}, true, ending});
  }
}

std::string_view name_of(CollisionShapes shapes) {
  switch (shapes) {
  case CollisionShapes::hull: return "the convex hull";
  case CollisionShapes::boxes: return "a box";
  case CollisionShapes::capsules: return "a capsule";
  case CollisionShapes::lighter: return "a lighter mesh";
  default: return "convex parts";
  }
}

/// "+3.1 %", "-0.5 %", "+230 %".
std::string percent(double part) {
  const double tenths = std::round(part * 1000);
  const std::string text = format_rounded(std::fabs(tenths) / 10, tenths < 1000 ? 4 : 3);
  return (tenths < 0 ? "-" : "+") + text + " %";
}

}  // namespace

bool CollisionRequest::changes_something() const {
  return std::any_of(choices.begin(), choices.end(), [](const CollisionChoice& choice) {
    return choice.shapes != CollisionShapes::keep;
  });
}

std::string describe(const ReplacedCollision& replaced) {
  std::string text = replaced.shapes == CollisionShapes::parts
                         ? counted(replaced.parts, "convex part")
                         : std::string(name_of(replaced.shapes));
  const std::string before = counted(replaced.vertices_before, "vertex", "vertices");
  if (replaced.vertices_after > 0) {
    text += "; " + before + " become " + std::to_string(replaced.vertices_after);
  } else {
    text += " around " + before;
  }
  // An open surface encloses nothing, before and after.
  if (!replaced.gain && replaced.shapes == CollisionShapes::lighter) return text;
  return text + (replaced.gain ? ", volume " + percent(*replaced.gain)
                               : ", volume " + format_rounded(replaced.volume * 1000, 3) +
                                     " l, where that of the open mesh is not known");
}

std::string CollisionShaper::new_file(const MeshReference& mesh, const std::string& ending) {
  const std::string file = render::safe_file_name(path::file_name(mesh.path));
  const std::string stem = file.substr(0, file.size() - path::extension(file).size()) + ending;
  std::string name = stem + ".obj";
  // Some systems do not distinguish cases.
  for (std::size_t number = 2; !names_.insert(path::to_lower(name)).second; ++number)
    name = stem + "_" + std::to_string(number) + ".obj";
  return path::join(request_.folder, name);
}

void CollisionShaper::add_mesh(const MeshReference& mesh, const CollisionBody& body,
                               const std::string& ending, const std::string& name_ending,
                               NewShapes& made) {
  const std::string file = new_file(mesh, ending);
  made.files.push_back({file, obj_of(body)});
  made.shapes.push_back({file, "", {}, false, name_ending});
  made.about.vertices_after += body.points.size();
}

void CollisionShaper::add_lighter(const MeshReference& mesh, const CollisionBody& body,
                                  std::optional<double> volume, NewShapes& made) {
  CollisionBody after;
  for (const double far : kFar) {
    LighterMesh lighter = request_.lighten({body.points, body.indices, kFewTriangles, kNear, far});
    if (!lighter.problem.empty()) {
      (lighter.is_for_no_mesh ? problem_ : made.about.kept) = lighter.problem;
      return;
    }
    after = {std::move(lighter.points), std::move(lighter.indices)};
    // A coarse surface takes much from thin walls.
    if (!volume || std::fabs(volume_of(after) / *volume - 1) <= kEnough) break;
  }
  if (after.indices.empty() || after.indices.size() >= body.indices.size()) {
    made.about.kept = "meshoptimizer finds no triangle to spare";
    return;
  }
  add_mesh(mesh, after, "_lighter", "", made);
  if (volume) made.about.volume = volume_of(after);
}

std::vector<ConvexMesh> CollisionShaper::parts_of(const CollisionBody& body, const ConvexMesh& hull,
                                                  std::optional<double> volume, std::string& kept) {
  std::vector<BodyPiece> pieces = volume ? closed_pieces(body) : std::vector<BodyPiece>();
  const bool is_closed = !pieces.empty();
  // As one, CoACD would make voxels of several surfaces, in which thin walls become thick.
  if (pieces.size() < 2 || pieces.size() > kMostParts / 2)
    return divided(body, hull, volume, is_closed, kMostParts, kept);
  std::vector<ConvexMesh> hulls;
  double gaps = 0;
  for (const BodyPiece& piece : pieces) {
    std::optional<ConvexMesh> around = convex_mesh(piece.body.points);
    if (!around) return divided(body, hull, volume, is_closed, kMostParts, kept);
    gaps += std::max(0.0, around->volume - piece.volume);
    hulls.push_back(std::move(*around));
  }
  std::vector<ConvexMesh> parts;
  const auto spare = static_cast<double>(kMostParts - pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double share = gaps > 0 ? std::max(0.0, hulls[i].volume - pieces[i].volume) / gaps : 0;
    const auto most = 1 + static_cast<std::size_t>(spare * share);
    std::vector<ConvexMesh> some{hulls[i]};
    if (most > 1) some = divided(pieces[i].body, hulls[i], pieces[i].volume, true, most, kept);
    if (some.empty()) return {};
    for (ConvexMesh& part : some) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<ConvexMesh> CollisionShaper::divided(const CollisionBody& body, const ConvexMesh& hull,
                                                 std::optional<double> volume, bool is_closed,
                                                 std::size_t most_parts, std::string& kept) {
  // A mesh that is as convex as the parts may be is its hull.
  if (volume && hull.volume <= *volume * (1 + kEnough / 2)) return {hull};
  if (const auto tell = std::exchange(tell_, nullptr)) tell();
  std::vector<ConvexMesh> best;
  double best_gain = HUGE_VAL;
  for (const double concavity : kConcavities) {
    DividedMesh wanted{body.points, body.indices, most_parts, concavity, is_closed};
    ConvexParts found = request_.divide(wanted);
    if (!found.problem.empty() && !found.is_for_no_mesh && wanted.is_closed) {
      wanted.is_closed = false;
      found = request_.divide(wanted);
    }
    if (!found.problem.empty()) {
      if (!best.empty()) break;
      (found.is_for_no_mesh ? problem_ : kept) = found.problem;
      return {};
    }
    std::vector<ConvexMesh> parts;
    for (const std::vector<Vector3>& points : found.parts) {
      if (auto part = convex_mesh(points)) parts.push_back(std::move(*part));
    }
    if (parts.empty()) continue;
    const double gain = volume ? std::fabs(volume_of_union(parts) / *volume - 1) : 0;
    const bool is_better = gain < kBetter * best_gain;
    if (gain < best_gain) {
      best = std::move(parts);
      best_gain = gain;
    }
    if (!is_better || best_gain <= kEnough || best.size() >= most_parts) break;
  }
  if (best.empty()) kept = "CoACD finds no part with a volume";
  return best;
}

NewShapes CollisionShaper::make(const MeshReference& mesh, const Vector3& scale,
                                CollisionShapes shapes, std::optional<double> volume,
                                bool has_capsules) {
  NewShapes made;
  made.about.mesh = mesh.filename;
  made.about.shapes = shapes;
  made.about.place = mesh.span;
  const MeshTriangles triangles = read_triangles_of(mesh.path, files_, limits_);
  made.about.vertices_before = triangles.points.size();
  if (!triangles.reason.empty()) {
    made.about.kept = triangles.reason;
    return made;
  }
  const CollisionBody body = body_of(triangles, scale);
  const std::optional<ConvexMesh> hull = convex_mesh(body.points);
  if (!hull) {
    made.about.kept = "all its points lie in one plane";
    return made;
  }
  switch (shapes) {
  case CollisionShapes::boxes: add_box(*hull, made); break;
  case CollisionShapes::capsules: add_capsule(*hull, has_capsules, made); break;
  case CollisionShapes::hull:
    add_mesh(mesh, body_of(*hull), "_hull", "", made);
    made.about.volume = hull->volume;
    break;
  case CollisionShapes::lighter: add_lighter(mesh, body, volume, made); break;
  default: {
    const std::vector<ConvexMesh> parts = parts_of(body, *hull, volume, made.about.kept);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string ending = "_part_" + std::to_string(i + 1);
      add_mesh(mesh, body_of(parts[i]), ending, i == 0 ? "" : ending, made);
    }
    made.about.parts = parts.size();
    made.about.volume = volume_of_union(parts);
  }
  }
  if (volume && *volume > 0) made.about.gain = made.about.volume / *volume - 1;
  return made;
}

}  // namespace smurf
