// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf_names.hpp"

#include "base/unique_names.hpp"
#include "write/scene_parts.hpp"

namespace smurf {

std::vector<std::string> sdf_names(const LinkedModel& model) {
  std::vector<std::string> names;
  std::vector<std::size_t> changed;
  UniqueNames unique;
  for (std::size_t link = 0; link < model.robot->links.size(); ++link) {
    const std::string& name = names.emplace_back(link_name(model, link));
    const bool is_reserved = name == "world" || (name.starts_with("__") && name.ends_with("__"));
    if (is_reserved || name.find("::") != std::string::npos) {
      changed.push_back(link);
    } else {
      unique.take(name);
    }
  }
  for (const std::size_t link : changed) {
    const std::string& name = names[link];
    std::string plain;
    for (std::size_t at = 0; at < name.size(); ++at) {
      const bool is_separator = name.compare(at, 2, "::") == 0;
      plain += is_separator ? '_' : name[at];
      if (is_separator) ++at;
    }
    names[link] = unique.add(plain + "_link");
  }
  return names;
}

}  // namespace smurf
