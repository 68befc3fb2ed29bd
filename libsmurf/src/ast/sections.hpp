// SPDX-License-Identifier: BSD-3-Clause
// The annotation sections as one table. A new section needs one file in sections/, one line in
// sections.def and its list in Annotations.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "ast/keys.hpp"
#include "smurf/model.hpp"

namespace smurf {

/// The type of the value of a section.
enum class SectionForm : std::uint8_t {
  list,             ///< a list of entries
  list_or_mapping,  ///< a list of entries or a single entry
  named             ///< a mapping from names to entries
};

/// What is done with the list of a section, whatever the type of its entries.
struct SectionList {
  /// The entries that were read, in file order.
  std::vector<const Annotation*> (*entries)(const Annotations& annotations);
  void (*append)(Annotations& to, Annotations& from);
  /// Moves the entries of one file, which are adjacent.
  void (*move)(Annotations& from, SourceId source, Annotations& to);
};

struct SectionSpec {
  std::string_view name;                           ///< canonical: "motors"
  std::span<const std::string_view> aliases = {};  ///< other names of the same section: "motor"
  std::string_view entry;                          ///< the noun for an entry: "motor"
  std::string_view doc;                            ///< one sentence, for the schema
  std::string_view read_by;                        ///< names of the programs
  SectionForm form = SectionForm::list;
  /// All rows of an entry, or those for which `takes` is true.
  std::vector<const KeySpec*> (*filtered_keys)(KeyFilter takes) = nullptr;
  /// Reads one entry (a mapping) and appends it.
  void (*read)(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) = nullptr;
  SectionList list;

  std::vector<const KeySpec*> keys() const { return filtered_keys(nullptr); }
};

std::span<const SectionSpec* const> all_sections();
/// Finds a section by canonical name or alias; null for a custom section.
const SectionSpec* find_section(std::string_view name);

/// Reads every section of a mapping, except for keys for which `is_taken` is true.
void read_sections(yaml::View root, bool (*is_taken)(std::string_view key), Annotations& out,
                   DiagnosticSink& sink);

/// Lists are concatenated in the order of the files; mappings keep all their files.
void append_sections(Annotations& to, Annotations& from);
/// Moves the entries of one file.
void move_sections(Annotations& from, SourceId source, Annotations& to);

/// The number of items of a list from this one on; 1 outside of a list.
std::size_t items_from(yaml::View item);

namespace sections {

#define SMURF_SECTION(name)                                                                        \
  namespace name##_file {                                                                          \
    extern const SectionSpec name;                                                                 \
  }                                                                                                \
  using name##_file::name;
#include "ast/sections.def"
#undef SMURF_SECTION

/// Reserves memory for the rest of the list, because growing step by step needs up to three times
/// the size. Reserves at most the current size, because a hostile list may contain only nulls.
template <class T>
void make_room(yaml::View entry, std::vector<T>& entries) {
  constexpr std::size_t kFirst = 1U << 14U;
  if (entries.size() < entries.capacity()) return;
  entries.reserve(entries.size() + std::min(items_from(entry), std::max(entries.size(), kFirst)));
}

/// The `read` function of most sections: one table row per key, one vector of entries.
template <class T>
void read_into(std::span<const Key<T>> keys, MoreKeys more, std::string_view entry_name,
               yaml::View entry, Span section, std::vector<T>& entries, DiagnosticSink& sink) {
  make_room(entry, entries);
  T& item = entries.emplace_back();
  item.section = section;
  read_entry(keys, more, entry, item, entry_name, sink, Slips::reported);
}

/// The kind of the names in `id` of a sensor of this type; none if MARS does not read `id`.
NameKinds measured_by(std::string_view type);

template <class T>
void append_list(std::vector<T>& to, std::vector<T>& from) {
  if (to.empty()) {  // nearly always: a section is in one file
    to = std::move(from);
    return;
  }
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

template <class T>
void move_list(std::vector<T>& from, SourceId source, std::vector<T>& to) {
  const auto is_here = [&](const T& entry) { return entry.span.source == source; };
  const auto begin = std::find_if(from.begin(), from.end(), is_here);
  const auto end = std::find_if_not(begin, from.end(), is_here);
  if (begin == from.begin() && end == from.end()) {
    to = std::move(from);
    from.clear();
  } else {
    to.assign(std::make_move_iterator(begin), std::make_move_iterator(end));
    from.erase(begin, end);
  }
}

/// The list of a section as a member of Annotations.
template <auto Member>
constexpr SectionList list_of() {
  return {[](const Annotations& annotations) {
            std::vector<const Annotation*> entries;
            entries.reserve((annotations.*Member).size());
            for (const Annotation& entry : annotations.*Member) entries.push_back(&entry);
            return entries;
          },
          [](Annotations& to, Annotations& from) { append_list(to.*Member, from.*Member); },
          [](Annotations& from, SourceId source, Annotations& to) {
            move_list(from.*Member, source, to.*Member);
          }};
}

/// The keys that describe a node of MARS. Entries of `collision`, `visuals`, `link` and `nodes`
/// replace them individually.
std::span<const KeySpec> node_keys();

}  // namespace sections
}  // namespace smurf
