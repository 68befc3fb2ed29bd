// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf_names.hpp"

#include "base/path.hpp"
#include "base/unique_names.hpp"
#include "write/scene_parts.hpp"

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

}  // namespace

std::string sdf_name(std::string_view name) {
  return is_reserved(name) ? std::string(name) + "_0" : without_separators(name);
}

std::vector<std::string> sdf_names(const LinkedModel& model) {
  std::vector<std::string> names;
  std::vector<std::size_t> changed;
  UniqueNames unique;
  for (std::size_t link = 0; link < model.robot->links.size(); ++link) {
    const std::string& name = names.emplace_back(link_name(model, link));
    if (is_reserved(name) || name.find("::") != std::string::npos) {
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

}  // namespace smurf
