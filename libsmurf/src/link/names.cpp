// SPDX-License-Identifier: BSD-3-Clause
// Name tables: where names are matched.
#include "smurf/linked.hpp"

namespace smurf {

void NameTable::add(std::string_view name, std::uint32_t index) {
  if (by_name_.emplace(name, index).second) names_.push_back(name);
}

std::optional<std::uint32_t> NameTable::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  if (found == by_name_.end()) return std::nullopt;
  return found->second;
}

const yaml::Document* LinkedModel::document(SourceId source) const {
  for (const ModelFile& file : files) {
    if (file.source == source && file.document) return &*file.document;
  }
  return nullptr;
}

}  // namespace smurf
