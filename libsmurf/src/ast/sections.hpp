// SPDX-License-Identifier: BSD-3-Clause
// The annotation sections as one table. A new section is one file in sections/ and one line in
// sections.def.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "ast/keys.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// What the value of a section is.
enum class SectionForm : std::uint8_t {
  list,             ///< a list of entries
  list_or_mapping,  ///< a list of entries, or one entry
  named             ///< a mapping from names to entries
};

struct SectionSpec {
  std::string_view name;                           ///< canonical: "motors"
  std::span<const std::string_view> aliases = {};  ///< other names of the same section: "motor"
  std::string_view entry;                          ///< what one entry is: "motor"
  std::string_view doc;                            ///< one sentence, for the schema
  SectionForm form = SectionForm::list;
  std::vector<const KeySpec*> (*keys)() = nullptr;
  /// Reads one entry (a mapping) and appends it.
  void (*read)(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) = nullptr;
};

std::span<const SectionSpec* const> all_sections();
/// By canonical name or alias; null for a user's own section.
const SectionSpec* find_section(std::string_view name);

/// Reads every section of a mapping; keys for which `is_taken` is true are left alone.
void read_sections(yaml::View root, bool (*is_taken)(std::string_view key), Annotations& out,
                   DiagnosticSink& sink);

namespace sections {

#define SMURF_SECTION(name) extern const SectionSpec name;
#include "ast/sections.def"
#undef SMURF_SECTION

/// How many entries the list or mapping has that holds `entry`.
inline std::size_t sibling_count(yaml::View entry) {
  const yaml::Document& document = entry.document();
  const yaml::NodeId parent = document.nodes[static_cast<std::size_t>(entry.id())].parent;
  return parent == yaml::kNoNode ? 1 : yaml::View(document, parent).size();
}

/// The usual `read` of a section: one table row per key, one vector of entries.
template <class T>
void read_into(std::span<const Key<T>> keys, MoreKeys more, std::string_view entry_name,
               yaml::View entry, Span section, std::vector<T>& entries, DiagnosticSink& sink) {
  if (entries.empty()) entries.reserve(sibling_count(entry));  // to grow would take twice the room
  T& item = entries.emplace_back();
  item.section = section;
  read_entry(keys, more, entry, item, entry_name, sink, Slips::reported);
}

/// The keys that describe a node of MARS: entries of `collision`, `visuals`, `link` and `nodes`
/// replace them one by one.
std::span<const KeySpec> node_keys();

}  // namespace sections
}  // namespace smurf
