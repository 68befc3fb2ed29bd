// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/collision_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "smurf-load-check/mesh.hpp"

namespace smurf::load_check {
namespace {

Pose translated(const Pose& X_WA, const Eigen::Vector3d& p_AB) {
  return X_WA * Pose{{p_AB[0], p_AB[1], p_AB[2]}, {}};
}

class ShapeBuilder {
 public:
  ShapeBuilder(Plan& plan, const ShapeFiles& files, DiagnosticSink& sink)
      : plan_(plan), files_(files), sink_(sink) {}

  ShapeCount run() {
    std::size_t left = kMostShapes;
    for (const LinkPlan& link : plan_.links) {
      const std::size_t count = plan_.link(link).collisions.size();
      if (count > left) {
        report_too_many(link);
        break;
      }
      left -= count;
      for (std::size_t i = 0; i < count; ++i) add(link, i);
    }
    report_denied();
    return count_;
  }

 private:
  /// Each shape may touch each other shape; robots made of spheres have a few hundred.
  static constexpr std::size_t kMostShapes = 1000;

  struct Denied {
    Span place;
    std::string reason;
  };

  void report_too_many(const LinkPlan& link) {
    const Field<std::string>& name = plan_.link(link).name;
    sink_.report(rules::sml6002_no_verdict,
                 name ? name.span : tag_name(plan_.model_of(link), plan_.link(link).element),
                 "the model has more than " + std::to_string(kMostShapes) +
                     " collision shapes; those from " + title(plan_.link(link)) +
                     " on are left out");
  }

  /// Reported once, at the first of them.
  void report_denied() {
    if (denied_.empty()) return;
    const std::string meshes =
        denied_.size() == 1 ? "a mesh was" : std::to_string(denied_.size()) + " meshes were";
    Diagnostic& diagnostic = sink_.report(rules::sml6107_shape_not_buildable, denied_.front().place,
                                          meshes + " not looked at");
    diagnostic.severity = Severity::warning;
    diagnostic.note(denied_.front().reason);
  }

  void add(const LinkPlan& link, std::size_t index) {
    const LinkedModel& model = plan_.model_of(link);
    const urdf::Collision& collision = plan_.link(link).collisions[index];
    ShapePlan plan;
    plan.instance = link.instance;
    plan.link = link.link;
    plan.collision = index;
    plan.body = link.body;
    plan.X_WS = link.X_WL * urdf::to_pose(collision.origin);
    plan.place = collision.name ? collision.name.span : tag_name(model, collision.element);
    plan.name = collision.name ? "collision " + smurf::quoted(*collision.name)
                               : "the collision of " + title(plan_.link(link));
    plan.bitmask = bitmask_of(model, collision);
    if (fill(model, collision.geometry, plan)) plan_.shapes.push_back(std::move(plan));
  }

  /// Data of the model that a collision needs.
  struct Lookup {
    std::map<std::string_view, std::int64_t> bitmasks;               ///< by collision
    std::unordered_map<std::uint32_t, const MeshReference*> meshes;  ///< by place
  };

  const Lookup& lookup(const LinkedModel& model) {
    const auto [entry, is_new] = lookups_.try_emplace(&model);
    Lookup& lookup = entry->second;
    if (!is_new) return lookup;
    for (const CollisionAnnotation& annotation : model.annotations.collisions) {
      if (annotation.name && annotation.bitmask) {
        lookup.bitmasks.emplace(*annotation.name, *annotation.bitmask);
      }
    }
    for (const MeshReference& mesh : model.meshes) lookup.meshes[mesh.span.begin] = &mesh;
    return lookup;
  }

  std::uint64_t bitmask_of(const LinkedModel& model, const urdf::Collision& collision) {
    constexpr std::uint64_t kDefault = 65535;  // MARS NodeData: coll_bitmask
    if (!collision.name) return kDefault;
    const auto& bitmasks = lookup(model).bitmasks;
    const auto found = bitmasks.find(*collision.name);
    return found == bitmasks.end() ? kDefault : static_cast<std::uint64_t>(found->second);
  }

  bool fill(const LinkedModel& model, const urdf::Geometry& geometry, ShapePlan& plan) {
    const auto refuse = [&](const Field<double>& size, std::string_view what) {
      return refuse_size(model, geometry, size.span, size.value_or(0), what, plan);
    };
    const auto are_positive = [&](const Field<double>& radius, const Field<double>& length) {
      return radius.value_or(0) > 0 && length.value_or(0) > 0;
    };
    if (const auto* box = std::get_if<urdf::Box>(&geometry.shape)) {
      const Vector3 size = box->size.value_or({0, 0, 0});
      const double smallest = *std::min_element(size.begin(), size.end());
      if (!(smallest > 0)) {
        return refuse_size(model, geometry, box->size.span, smallest, "an edge", plan);
      }
      plan.shape = BoxShape{to_eigen(size)};
    } else if (const auto* sphere = std::get_if<urdf::Sphere>(&geometry.shape)) {
      if (!(sphere->radius.value_or(0) > 0)) return refuse(sphere->radius, "a radius");
      plan.shape = SphereShape{*sphere->radius};
    } else if (const auto* cylinder = std::get_if<urdf::Cylinder>(&geometry.shape)) {
      if (!(cylinder->radius.value_or(0) > 0)) return refuse(cylinder->radius, "a radius");
      if (!are_positive(cylinder->radius, cylinder->length)) {
        return refuse(cylinder->length, "a length");
      }
      plan.shape = CylinderShape{*cylinder->radius, *cylinder->length};
    } else if (const auto* capsule = std::get_if<urdf::Capsule>(&geometry.shape)) {
      if (!(capsule->radius.value_or(0) > 0)) return refuse(capsule->radius, "a radius");
      if (!are_positive(capsule->radius, capsule->length)) {
        return refuse(capsule->length, "a length");
      }
      plan.shape = CapsuleShape{*capsule->radius, *capsule->length};
    } else if (const auto* mesh = std::get_if<urdf::Mesh>(&geometry.shape)) {
      return fill_mesh(model, *mesh, plan);
    } else {
      return false;  // no geometry, or an unknown one, which the linter reports
    }
    return true;
  }

  bool refuse_size(const LinkedModel& model, const urdf::Geometry& geometry, Span written,
                   double size, std::string_view what, const ShapePlan& plan) {
    const Span place = written.empty() ? tag_name(model, geometry.shape_element) : written;
    Diagnostic& diagnostic = sink_.report(rules::sml6107_shape_not_buildable, place,
                                          "ODE cannot build the shape of " + plan.name);
    diagnostic.caret = std::string(what) + " of " + format_rounded(size) + " m";
    return false;
  }

  bool fill_mesh(const LinkedModel& model, const urdf::Mesh& mesh, ShapePlan& plan) {
    const std::string path = path_of(model, mesh);
    if (path.empty()) {
      ++count_.missing_meshes;
      return false;
    }
    const MeshReading& read = read_once(path);
    if (read.is_denied) {
      denied_.push_back({mesh.filename.span, read.reason});
      return false;
    }
    if (!read.reason.empty()) {
      sink_
          .report(rules::sml6107_shape_not_buildable, mesh.filename.span,
                  "the mesh of " + plan.name + " cannot be read")
          .caret = read.reason;
      return false;
    }
    TriangleShape triangles = read.shape;
    const Eigen::Vector3d scale = to_eigen(mesh.scale.value_or({1, 1, 1}));
    for (Eigen::Vector3d& point : triangles.points) point = point.cwiseProduct(scale);
    if (plan.body == kWorld && triangles.triangles.size() <= triangles_left_) {
      triangles_left_ -= triangles.triangles.size();
      plan.shape = std::move(triangles);
    } else {
      stand_in(triangles, plan);
    }
    return true;
  }

  /// The box around the points, for moving meshes and for too many triangles, because collisions
  /// between triangle meshes are unreliable in ODE.
  void stand_in(const TriangleShape& triangles, ShapePlan& plan) {
    constexpr double kThinnest = 1e-4;  // m, so that the box of a flat mesh has a volume
    Eigen::Vector3d low = triangles.points.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& point : triangles.points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    plan.X_WS = translated(plan.X_WS, (low + high) / 2);
    plan.shape = BoxShape{(high - low).cwiseMax(kThinnest)};
    plan.is_stand_in = true;
    ++count_.stand_ins;
  }

  std::string path_of(const LinkedModel& model, const urdf::Mesh& mesh) {
    const auto& meshes = lookup(model).meshes;
    const auto found = meshes.find(mesh.filename.span.begin);
    return found != meshes.end() && found->second->exists ? found->second->path : "";
  }

  const MeshReading& read_once(const std::string& path) {
    const auto known = meshes_.find(path);
    if (known != meshes_.end()) return known->second;
    return meshes_.emplace(path, read_mesh(path, files_)).first->second;
  }

  Plan& plan_;
  const ShapeFiles& files_;
  DiagnosticSink& sink_;
  ShapeCount count_;
  std::size_t triangles_left_ = 1'000'000;  ///< each takes about 100 bytes in ODE
  std::map<std::string, MeshReading> meshes_;
  std::vector<Denied> denied_;
  std::unordered_map<const LinkedModel*, Lookup> lookups_;
};

}  // namespace

ShapeCount add_shapes(Plan& plan, const ShapeFiles& files, DiagnosticSink& sink) {
  return ShapeBuilder(plan, files, sink).run();
}

}  // namespace smurf::load_check
