// SPDX-License-Identifier: BSD-3-Clause
// Reads sections by the table: known sections as typed entries, others as YAML values.
#include "ast/sections.hpp"

#include <algorithm>

#include "ast/wrong_type.hpp"
#include "base/findings/cases.hpp"

namespace smurf {
namespace {

constexpr const SectionSpec* kSections[] = {
#define SMURF_SECTION(name) &sections::name,
#include "ast/sections.def"
#undef SMURF_SECTION
};

void report_shape(const SectionSpec& section, const Circumstance& wanted, yaml::View value,
                  std::string_view expected, DiagnosticSink& sink) {
  report_wrong_type(wanted, value,
                    "the section `" + std::string(section.name) + "` must be " +
                        std::string(expected) + ", not " + describe(value),
                    sink);
}

void read_entries(const SectionSpec& section, yaml::View value, std::string_view expected,
                  Annotations& out, DiagnosticSink& sink) {
  for (const yaml::View entry : value) {
    if (entry.is_mapping()) {
      section.read(entry, value.key_span(), out, sink);
    } else {
      report_shape(section, cases::kEntryWanted, entry, expected, sink);
    }
  }
}

void read_section(const SectionSpec& section, yaml::View value, Annotations& out,
                  DiagnosticSink& sink) {
  if (value.is_null()) return;
  const bool is_named = section.form == SectionForm::named;
  const std::string_view expected =
      is_named ? "a mapping from names to mappings" : "a list of mappings";
  if (is_named ? value.is_mapping() : value.is_sequence()) {
    return read_entries(section, value, expected, out, sink);
  }
  if (section.form == SectionForm::list_or_mapping && value.is_mapping()) {
    return section.read(value, value.key_span(), out, sink);
  }
  report_shape(section, cases::kSectionWanted, value, expected, sink);
}

}  // namespace

std::span<const SectionSpec* const> all_sections() { return kSections; }

void append_sections(Annotations& to, Annotations& from) {
  for (const SectionSpec* section : kSections) section->list.append(to, from);
  sections::append_list(to.custom, from.custom);
}

void move_sections(Annotations& from, SourceId source, Annotations& to) {
  for (const SectionSpec* section : kSections) section->list.move(from, source, to);
  sections::move_list(from.custom, source, to.custom);
}

const SectionSpec* find_section(std::string_view name) {
  for (const SectionSpec* section : kSections) {
    const auto& aliases = section->aliases;
    if (section->name == name || std::find(aliases.begin(), aliases.end(), name) != aliases.end()) {
      return section;
    }
  }
  return nullptr;
}

std::size_t items_from(yaml::View item) {
  const yaml::Node& node = item.document().nodes[static_cast<std::size_t>(item.id())];
  const yaml::View parent(item.document(), node.parent);
  return parent.is_sequence() ? parent.size() - node.position() : 1;
}

std::vector<std::string_view> section_names() {
  std::vector<std::string_view> names;
  for (const SectionSpec* section : kSections) names.push_back(section->name);
  for (const SectionSpec* section : kSections) {
    names.insert(names.end(), section->aliases.begin(), section->aliases.end());
  }
  return names;
}

void read_sections(yaml::View root, bool (*is_taken)(std::string_view key), Annotations& out,
                   DiagnosticSink& sink) {
  for (const yaml::View value : root) {
    if (is_taken(value.key()) || value.is_repeated()) continue;
    if (const SectionSpec* section = find_section(value.key())) {
      read_section(*section, value, out, sink);
    } else {
      out.custom.push_back(
          {{std::string(value.key()), value.key_span()}, value.id(), value.span()});
    }
  }
}

}  // namespace smurf
