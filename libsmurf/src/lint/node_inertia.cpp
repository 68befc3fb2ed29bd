// SPDX-License-Identifier: BSD-3-Clause
#include "lint/node_inertia.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "link/shape_solids.hpp"
#include "lint/annotation_queries.hpp"
#include "lint/geometry_queries.hpp"
#include "lint/inertia_slips.hpp"

namespace smurf {
namespace {

/// The places of xx, yy, zz, xy, xz and yz above the diagonal, and of their mirror images.
constexpr std::array<std::array<std::size_t, 2>, 6> kPlaces = {
    {{0, 0}, {4, 4}, {8, 8}, {1, 3}, {2, 6}, {5, 7}}};

constexpr double kRounding = 1e-6;  // of the largest entry

/// A value that no file has.
template <class Value>
Field<Value> field(const Value& value) {
  return {std::optional<Value>(value), Span{}};
}

/// The shape that MARS makes of `physicmode` and `extend`; of a mesh, only its file tells.
std::optional<urdf::Shape> shape_of(yaml::View mapping) {
  const auto mode = text_at(mapping, "physicmode");
  const yaml::View extend = mapping.find("extend");
  if (!mode || !extend || !extend.is_mapping()) return std::nullopt;
  const double x = number_at(extend, "x").value_or(0);
  const double y = number_at(extend, "y").value_or(0);
  const double z = number_at(extend, "z").value_or(0);
  if (mode->value == "box") return urdf::Box{field(Vector3{x, y, z})};
  if (mode->value == "sphere") return urdf::Sphere{field(x)};
  if (mode->value == "cylinder") return urdf::Cylinder{field(x), field(y)};
  if (mode->value == "capsule") return urdf::Capsule{field(x), field(y)};
  return std::nullopt;
}

void add_body(const LinkedModel& model, yaml::View mapping, NodeInertia& node) {
  urdf::Geometry geometry;
  if (auto shape = shape_of(mapping)) {
    geometry.shape = std::move(*shape);
    node.solid = solid_of(model, geometry);
    const std::optional<Box> box = bounding_box(model, geometry);
    if (node.solid && box) node.extent = Extent{box->low, box->high};
  }
  const auto density = number_at(mapping, "density");
  if (density && *density > 0) {
    if (node.solid) node.mass = *density * node.solid->volume;
    return;
  }
  const auto mass = number_at(mapping, "mass");
  if (!mass || !(*mass > 0)) return;
  node.mass = mass;
  node.mass_place = within_quotes(model, mapping.find("mass").span());
}

std::optional<NodeInertia> read(const LinkedModel& model, std::string_view kind,
                                const Annotation& entry) {
  const yaml::View mapping = mapping_of(model, entry);
  if (!mapping || !mapping.is_mapping()) return std::nullopt;
  const auto flag = text_at(mapping, "inertia");
  // The node of an inertial of the URDF has an inertia, of which an entry may replace a part.
  const bool is_new = static_cast<bool>(mapping.find("parent"));
  if (flag ? flag->value == "false" : is_new) return std::nullopt;
  if (const auto shown = text_at(mapping, "noPhysical"); shown && shown->value == "true") {
    return std::nullopt;
  }
  NodeInertia node;
  double largest = 0;
  for (std::size_t i = 0; i < kNodeEntries.size(); ++i) {
    const yaml::View value = mapping.find(kNodeEntries[i]);
    if (!value) continue;
    node.values[i] = number_at(mapping, kNodeEntries[i]);
    if (!node.values[i]) return std::nullopt;
    node.places[i] = within_quotes(model, value.span());
    if (node.place.empty()) node.place = value.span();
    largest = std::max(largest, std::fabs(*node.values[i]));
  }
  const bool is_whole = node.values[0] && node.values[4] && node.values[8];
  if (node.place.empty() || !(is_new || is_whole)) return std::nullopt;
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    const auto [above, below] = kPlaces[i];
    const double a = node.values[above].value_or(0);
    const double b = node.values[below].value_or(0);
    node.tensor[i] = node.values[above] ? a : b;
    const bool is_known = is_new || (node.values[above] && node.values[below]);
    if (is_known && std::fabs(a - b) > kRounding * largest) node.is_symmetric = false;
  }
  node.title = subject(kind, entry).text();
  add_body(model, mapping, node);
  return node;
}

std::optional<Fix> edits_for(const NodeInertia& node, const Tensor& tensor) {
  constexpr int kDigits = 7;
  double scale = 0;
  for (const double entry : tensor) scale = std::max(scale, std::fabs(entry));
  Fix fix{Applicability::unsafe, {}};
  for (std::size_t i = 0; i < kPlaces.size(); ++i) {
    constexpr double kNoise = 1e-9;
    const double value = std::fabs(tensor[i]) < kNoise * scale ? 0 : tensor[i];
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t place = kPlaces[i][k];
      if (k == 1 && place == kPlaces[i][0]) continue;
      const double old = node.values[place].value_or(0);
      if (std::fabs(old - value) <= kNoise * scale) continue;
      if (!node.values[place]) return std::nullopt;
      fix.edits.push_back({node.places[place], format_rounded(value, kDigits)});
    }
  }
  return fix.edits.empty() ? std::nullopt : std::optional(std::move(fix));
}

/// A body of this mass that fills the shape, or the box around it.
Tensor full(const Solid& solid, double mass) {
  Tensor tensor = unit_inertia(solid);
  for (double& entry : tensor) entry *= mass;
  return tensor;
}

}  // namespace

std::vector<NodeInertia> node_inertias(const LinkedModel& model) {
  std::vector<NodeInertia> nodes;
  const auto add = [&](std::string_view kind, const auto& entries) {
    for (const Annotation& entry : entries) {
      if (auto node = read(model, kind, entry)) nodes.push_back(std::move(*node));
    }
  };
  const Annotations& all = model.annotations;
  add("node", all.nodes);
  add("link", all.links);
  add("collision", all.collisions);
  add("visual", all.visuals);
  return nodes;
}

std::string fault_of(const NodeInertia& node) {
  if (!node.is_symmetric) return "is not symmetric";
  const Vector3 moments = principal_of(node.tensor).moments;
  if (!is_positive_definite(moments) || triangle_excess(moments) > kImpossibleExcess) {
    return "is impossible for a body";
  }
  if (!node.mass || !node.extent || *node.mass < kSmallestPart) return {};
  const double half_trace = (moments[0] + moments[1] + moments[2]) / 2;
  const Tensor& t = node.tensor;
  const Body body{*node.mass, {}, {half_trace - t[0], half_trace - t[1], half_trace - t[2]}};
  constexpr double kSlack = 2;     // nodes have simplified shapes
  constexpr double kLeast = 0.01;  // as in SML1519
  if (excess_over(body, *node.extent) > kSlack) return "is too large for its mass and size";
  if (ratio_to_block(body, *node.extent) < kLeast) return "is very small for its mass and size";
  return {};
}

std::optional<NodeRepair> repair_of(const NodeInertia& node, const InertiaSource& source) {
  using From = InertiaSource::From;
  const bool is_of_shape = node.solid && source.from != From::nearest;
  double mass = node.mass.value_or(0);
  if (is_of_shape && source.from == From::density) mass = source.density * node.solid->volume;
  Tensor tensor{};
  std::string assumption = "the nearest tensor that a body can have";
  if (is_of_shape && mass > 0) {
    const bool is_box = source.from == From::box;
    const Solid solid = is_box ? block({node.extent->low, node.extent->high}) : *node.solid;
    tensor = full(solid, mass);
    assumption = std::string(is_box ? "the box around it" : "its shape") + ", filled with " +
                 format_rounded(mass, 4) + " kg, which is " +
                 format_rounded(mass / solid.volume, 3) + " kg/m3";
  } else if ((source.from != From::mass && source.from != From::nearest) ||
             is_nothing(node.tensor, mass)) {
    return std::nullopt;
  } else {
    tensor = nearest_possible(node.tensor);
  }
  auto fix = edits_for(node, tensor);
  if (!fix) return std::nullopt;
  if (node.mass && mass != *node.mass && !node.mass_place.empty()) {
    fix->edits.push_back({node.mass_place, format_rounded(mass, 6)});
  }
  return NodeRepair{std::move(*fix), "principal moments " + moments_of(node.tensor) + " become " +
                                         moments_of(tensor) + ": " + assumption};
}

}  // namespace smurf
