// SPDX-License-Identifier: BSD-3-Clause
#include "ast/format.hpp"

#include <cmath>

#include "ast/model_reader.hpp"
#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/numbers/numbers.hpp"

namespace smurf {
namespace {

std::string type_of(const KeySpec& spec) {
  std::string text(describe(spec.type));
  if (text.starts_with("a ")) text.erase(0, 2);
  if (!spec.choices.empty()) {
    text = "one of";
    for (const std::string_view choice : spec.choices) text.append(" `").append(choice).append("`");
    return text;
  }
  const bool has_least = std::isfinite(spec.minimum);
  const bool has_most = std::isfinite(spec.maximum);
  if (spec.positive) text += " above 0";
  if (has_least && has_most) {
    text += " from " + format_number(spec.minimum) + " to " + format_number(spec.maximum);
  } else if (has_least && !spec.positive) {
    text += ", at least " + format_number(spec.minimum);
  } else if (has_most) {
    text += ", at most " + format_number(spec.maximum);
  }
  return text;
}

/// Entities are a separate part, because three lists of a scene contain them.
bool has_own_part(const KeySpec& spec) { return spec.members.first == all_entity_keys().data(); }

void add_key(FormatPart& part, const KeySpec& spec, const std::string& prefix) {
  const std::string path = prefix + std::string(spec.name);
  part.keys.push_back(
      {path, type_of(spec), spec.unit, spec.fallback, spec.read_by, spec.doc, spec.required});
  if (has_own_part(spec)) return;
  for (const KeySpec& member : spec.members.keys()) {
    add_key(part, member, path + (spec.type == ValueType::list ? "[]." : "."));
  }
}

FormatPart part_of(std::string_view name, std::string_view doc, std::span<const KeySpec> keys) {
  FormatPart part{.name = name, .doc = doc};
  for (const KeySpec& key : keys) add_key(part, key, "");
  return part;
}

std::string_view form_of(const SectionSpec& section) {
  switch (section.form) {
  case SectionForm::list: return "a list of entries";
  case SectionForm::list_or_mapping: return "a list of entries or a single entry";
  case SectionForm::named: return "a mapping from names to entries";
  }
  return "";
}

FormatPart part_of(const SectionSpec& section) {
  FormatPart part{.name = section.name,
                  .aliases = {section.aliases.begin(), section.aliases.end()},
                  .doc = section.doc,
                  .form = form_of(section),
                  .read_by = section.read_by};
  const std::span<const KeySpec> shared = sections::node_keys();
  for (const KeySpec* key : section.keys()) {
    const bool is_shared = key >= shared.data() && key < shared.data() + shared.size();
    if (is_shared) {
      part.more = "node";
    } else {
      add_key(part, *key, "");
    }
  }
  return part;
}

FormatPart main_part() {
  FormatPart part{.name = "main file",
                  .doc = "The .smurf file. It may contain sections of annotations itself; Phobos 2 "
                         "ignores those.",
                  .form = "a mapping",
                  .read_by = "MARS 1, MARS 2, MARS with envire, Phobos 2"};
  for (const Key<Model>& key : main_keys()) add_key(part, key.spec, "");
  return part;
}

}  // namespace

std::vector<FormatPart> describe_format() {
  std::vector<FormatPart> parts{main_part()};
  for (const SectionSpec* section : all_sections()) parts.push_back(part_of(*section));
  parts.push_back(part_of("node",
                          "Keys that entries of collision, visuals, link and nodes share: "
                          "each replaces a property of the node that MARS makes of the "
                          "URDF element.",
                          sections::node_keys()));
  parts.back().read_by = "MARS 1; MARS 2 in collision and link";
  parts.push_back(part_of("scene",
                          "The .smurfs file; a .smurfa (assembly) has the same keys, but "
                          "MARS ignores its physics, environment and lights.",
                          scene_keys()));
  parts.back().read_by = "MARS 1, MARS 2, Phobos 2";
  parts.push_back(part_of("entity", "One entry of `entities`.", all_entity_keys()));
  parts.back().read_by = "MARS 1, MARS 2, Phobos 2";
  for (FormatPart& part : parts) {
    if (part.form.empty()) part.form = "a mapping";
  }
  return parts;
}

}  // namespace smurf
