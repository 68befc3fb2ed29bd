// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_names.hpp"

#include <algorithm>
#include <set>

#include "base/files/path.hpp"
#include "base/text/unique_names.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {

namespace {

/// libsdformat reads `true` and `false` as 1 and 0 where they stand alone, so references break.
bool is_reserved(std::string_view name) {
  const std::string lower = path::to_lower(name);
  return name == "world" || lower == "true" || lower == "false" ||
         (name.starts_with("__") && name.ends_with("__"));
}

std::string without_separators(std::string_view name) {
  std::string plain;
  for (std::size_t at = 0; at < name.size(); ++at) {
    const bool is_separator = name.compare(at, 2, "::") == 0;
    plain += is_separator ? '_' : name[at];
    if (is_separator) ++at;
  }
  return plain;
}

/// Finds the links that nested models can have.
class NestedNames {
 public:
  explicit NestedNames(const LinkedModel& model) {
    for (const urdf::Link& link : model.robot->links) {
      if (link.name) taken_.insert(*link.name);
    }
    for (const urdf::Joint& joint : model.robot->joints) {
      if (joint.name) taken_.insert(*joint.name);
    }
  }

  bool has(std::string_view name) const {
    if (sdf_scope(name).empty()) return false;
    std::size_t begin = 0;
    for (std::size_t depth = 0; begin <= name.size(); ++depth) {
      const std::size_t end = std::min(name.find("::", begin), name.size());
      const std::string_view part = name.substr(begin, end - begin);
      const bool is_model = end < name.size();
      if (part.empty() || part.front() == ':' || is_reserved(part)) return false;
      if (depth > kMostModels) return false;
      if (is_model && taken_.contains(name.substr(0, end))) return false;
      begin = end + 2;
    }
    return true;
  }

 private:
  static constexpr std::size_t kMostModels = 32;  // around a link

  std::set<std::string_view> taken_;  ///< names that are no models
};

}  // namespace

std::string_view sdf_scope(std::string_view name) {
  const std::size_t end = name.rfind("::");
  return end == std::string_view::npos ? std::string_view() : name.substr(0, end);
}

std::string_view sdf_joint_scope(std::string_view joint, std::string_view parent,
                                 std::string_view child) {
  const std::string_view scope = sdf_scope(joint);
  const auto is_inside = [&](std::string_view link) {
    return link.starts_with(scope) && link.substr(scope.size()).starts_with("::");
  };
  return is_inside(parent) && is_inside(child) ? scope : std::string_view();
}

std::string_view sdf_local(std::string_view name, std::string_view scope) {
  return scope.empty() ? name : name.substr(scope.size() + 2);
}

std::string sdf_name(std::string_view name) {
  return is_reserved(name) ? std::string(name) + "_0" : without_separators(name);
}

std::vector<std::string> sdf_names(const LinkedModel& model,
                                   const std::vector<std::size_t>* bodies) {
  const NestedNames nested(model);
  // A frame is in the model of the body that it is attached to.
  const auto is_nested = [&](std::size_t link) {
    if (bodies == nullptr || (*bodies)[link] >= bodies->size()) return false;
    const std::string& name = link_name(model, link);
    const std::string& body = link_name(model, (*bodies)[link]);
    return nested.has(name) && nested.has(body) && sdf_scope(name) == sdf_scope(body);
  };
  std::vector<std::string> names;
  std::vector<std::size_t> changed;
  UniqueNames unique;
  for (std::size_t link = 0; link < model.robot->links.size(); ++link) {
    const std::string& name = names.emplace_back(link_name(model, link));
    if (is_reserved(name) || (name.find("::") != std::string::npos && !is_nested(link))) {
      changed.push_back(link);
    } else {
      unique.take(name);
    }
  }
  if (changed.empty()) return names;
  // Links and joints share one name space.
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.name) unique.take(sdf_name(*joint.name));
  }
  for (const std::size_t link : changed) {
    names[link] = unique.add(without_separators(names[link]) + "_link");
  }
  return names;
}

std::vector<std::string> sdf_names(const FlatScene& scene) {
  std::vector<std::string> names = safe_names(scene);
  UniqueNames unique;
  for (const std::string& name : names) unique.take(name);
  for (std::string& name : names) {
    if (is_reserved(name)) name = unique.add(sdf_name(name));
  }
  return names;
}

std::vector<std::size_t> sdf_bodies(const LinkedModel& model, bool as_libsdformat) {
  std::vector<std::size_t> bodies(model.robot->links.size());
  for (const LinkIndex link : model.tree.order) {
    const std::size_t at = to_size(link);
    bodies[at] = at;
    const auto& above = model.tree.parent_joint[at];
    if (!above || model.joint(*above).type != urdf::JointType::fixed) continue;
    if (!as_libsdformat && inertial_of(model.link(link))) continue;
    bodies[at] = bodies[to_size(*model.tree.joint_parent[to_size(*above)])];
  }
  return bodies;
}

namespace {

std::string shape_name(const Field<std::string>& name, std::string_view link, const char* kind,
                       std::size_t index) {
  if (name) return sdf_name(*name + kind);
  return sdf_name(std::string(link) + kind) + (index > 0 ? "_" + std::to_string(index) : "");
}

}  // namespace

SdfShapeNames sdf_shape_names(const LinkedModel& model, const std::vector<std::size_t>& bodies) {
  SdfShapeNames names;
  std::map<std::size_t, UniqueNames> taken;  // by body
  for (const LinkIndex index : model.tree.order) {
    const urdf::Link& link = model.link(index);
    const std::string_view link_name = link.name ? std::string_view(*link.name) : "";
    UniqueNames& in_body = taken[bodies[to_size(index)]];
    for (std::size_t i = 0; i < link.visuals.size(); ++i) {
      names.visuals.emplace(&link.visuals[i],
                            in_body.add(shape_name(link.visuals[i].name, link_name, "_visual", i)));
    }
    for (std::size_t i = 0; i < link.collisions.size(); ++i) {
      names.collisions.emplace(
          &link.collisions[i],
          in_body.add(shape_name(link.collisions[i].name, link_name, "_collision", i)));
    }
  }
  return names;
}

}  // namespace smurf
