// SPDX-License-Identifier: BSD-3-Clause
// The annotation sections as one table. A new section is one file in sections/ and one line in
// sections.def.
#pragma once

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "ast/keys.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// What the value of a section is.
enum class SectionForm : std::uint8_t {
  list,             ///< a list of entries
  list_or_mapping,  ///< a list of entries or a single entry
  named             ///< a mapping from names to entries
};

struct SectionSpec {
  std::string_view name;                           ///< canonical: "motors"
  std::span<const std::string_view> aliases = {};  ///< other names of the same section: "motor"
  std::string_view entry;                          ///< what one entry is: "motor"
  std::string_view doc;                            ///< one sentence, for the schema
  std::string_view read_by;                        ///< the programs, as text
  SectionForm form = SectionForm::list;
  /// All rows of an entry, or those that `takes` is true for.
  std::vector<const KeySpec*> (*filtered_keys)(KeyFilter takes) = nullptr;
  /// Reads one entry (a mapping) and appends it.
  void (*read)(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) = nullptr;
  /// What it has appended, in file order.
  std::vector<const Annotation*> (*entries)(const Annotations& annotations) = nullptr;

  std::vector<const KeySpec*> keys() const { return filtered_keys(nullptr); }
};

std::span<const SectionSpec* const> all_sections();
/// By canonical name or alias; null for a user's own section.
const SectionSpec* find_section(std::string_view name);

/// Reads every section of a mapping; keys for which `is_taken` is true are left alone.
void read_sections(yaml::View root, bool (*is_taken)(std::string_view key), Annotations& out,
                   DiagnosticSink& sink);

/// How many items of a list are left from this one on, whatever they are; 1 outside of a list.
std::size_t items_from(yaml::View item);

namespace sections {

#define SMURF_SECTION(name) extern const SectionSpec name;
#include "ast/sections.def"
#undef SMURF_SECTION

/// Reserves memory for the rest of the list, because growing step by step needs up to three times
/// the size for a while. A hostile list full of nulls gets no more than it has filled.
template <class T>
void make_room(yaml::View entry, std::vector<T>& entries) {
  constexpr std::size_t kFirst = 1U << 14U;
  if (entries.size() < entries.capacity()) return;
  entries.reserve(entries.size() + std::min(items_from(entry), std::max(entries.size(), kFirst)));
}

/// The `read` of most sections: one table row per key, one vector of entries.
template <class T>
void read_into(std::span<const Key<T>> keys, MoreKeys more, std::string_view entry_name,
               yaml::View entry, Span section, std::vector<T>& entries, DiagnosticSink& sink) {
  make_room(entry, entries);
  T& item = entries.emplace_back();
  item.section = section;
  read_entry(keys, more, entry, item, entry_name, sink, Slips::reported);
}

/// What the names in `id` of a sensor of this type are; none when MARS takes no `id`.
NameKinds measured_by(std::string_view type);

/// The `entries` of most sections.
template <auto Member>
std::vector<const Annotation*> entries_of(const Annotations& annotations) {
  std::vector<const Annotation*> entries;
  entries.reserve((annotations.*Member).size());
  for (const Annotation& entry : annotations.*Member) entries.push_back(&entry);
  return entries;
}

/// The keys that describe a node of MARS: entries of `collision`, `visuals`, `link` and `nodes`
/// replace them one by one.
std::span<const KeySpec> node_keys();

}  // namespace sections
}  // namespace smurf
