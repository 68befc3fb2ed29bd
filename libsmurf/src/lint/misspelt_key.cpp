// SPDX-License-Identifier: BSD-3-Clause
#include "lint/misspelt_key.hpp"

#include <utility>
#include <vector>

#include "base/text/suggest.hpp"

namespace smurf {
namespace {

/// `my_physics` is a custom name, not a misspelling.
constexpr int kMostEdits = 2;

/// Words of other formats, and singulars, for keys of scenes and entities.
constexpr std::pair<std::string_view, std::string_view> kOtherWords[] = {
    {"entity", "entities"}, {"objects", "entities"},     {"models", "entities"},
    {"light", "lights"},    {"orientation", "rotation"}, {"rot", "rotation"},
    {"rpy", "rotation"},    {"quaternion", "rotation"},  {"translation", "position"},
    {"pos", "position"},    {"xyz", "position"},         {"radius", "extend"},
    {"size", "extend"},     {"extent", "extend"},        {"extents", "extend"},
};

/// Null if no reader has another word for it, or if the value does not fit.
const KeySpec* meant_by_other_word(yaml::View value, KeyRenames& renames,
                                   std::span<const KeySpec> keys) {
  for (const auto& [word, key] : kOtherWords) {
    if (value.key() != word || renames.has(key)) continue;
    const KeySpec* spec = find_key({keys}, key);
    if (spec == nullptr || value.is_null()) continue;
    const bool is_list = spec->type == ValueType::list;
    if (!is_list || value.is_sequence()) return spec;
  }
  return nullptr;
}

}  // namespace

bool takes_value(const KeySpec& spec, yaml::View value) {
  DiagnosticSink found;
  read_value(spec, value, {}, found);
  return found.diagnostics().empty();
}

const KeySpec* misspelt_key(yaml::View value, KeyRenames& renames, std::span<const KeySpec> keys) {
  std::vector<std::string_view> names;
  for (const KeySpec& spec : keys) {
    if (spec.name != "URI") names.push_back(spec.name);  // should not be suggested
  }
  if (const KeySpec* other = meant_by_other_word(value, renames, keys)) return other;
  const auto near = nearest(value.key(), names);
  if (!near || renames.has(*near)) return nullptr;
  if (edit_distance(value.key(), *near, kMostEdits) > kMostEdits) return nullptr;
  const KeySpec* spec = find_key({keys}, *near);
  return takes_value(*spec, value) ? spec : nullptr;
}

}  // namespace smurf
