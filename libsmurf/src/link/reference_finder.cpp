// SPDX-License-Identifier: BSD-3-Clause
#include "link/reference_finder.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// The name that MARS gives to the inertia of a link.
constexpr std::string_view kInertial = "inertial_";

bool is_naming(const KeySpec& row) {
  if (!row.names.kinds.empty() || row.names_in != nullptr) return true;
  const auto members = row.members.keys();
  return std::any_of(members.begin(), members.end(), is_naming);
}

bool is_known_key(const std::vector<const KeySpec*>& keys, std::string_view name) {
  return std::any_of(keys.begin(), keys.end(),
                     [&](const KeySpec* key) { return key->name == name; });
}

const yaml::Node& node_of(yaml::View view) {
  return view.document().nodes[static_cast<std::size_t>(view.id())];
}

template <class Entries, class Has>
NameTable table_of(const Entries& entries, Has has) {
  NameTable table;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (has(entries[i])) table.add(*entries[i].name, static_cast<std::uint32_t>(i));
  }
  return table;
}

}  // namespace

NamePlace place_of_name(yaml::View scalar) {
  const yaml::Node& own = node_of(scalar);
  const auto place = static_cast<std::uint32_t>(scalar.id());
  if (!own.is_alias()) {
    return {Reference::Notation::yaml, place, within_quotes(scalar), own.span};
  }
  const auto target = static_cast<std::size_t>(own.target());
  return {Reference::Notation::yaml, place, own.span, scalar.document().nodes[target].span};
}

NamePlace place_of_key(yaml::View member) {
  const Span key = member.key_span();
  const Span with_escapes{key.source, key.begin + 1, key.end - 1};  // only possible in quotes
  return {Reference::Notation::yaml_key, static_cast<std::uint32_t>(member.id()),
          within_quotes(key, member.key()).value_or(with_escapes), key};
}

NamePlace part_of(NamePlace place, std::size_t offset, std::size_t size) {
  place.span.begin += static_cast<std::uint32_t>(offset);
  place.span.end = place.span.begin + static_cast<std::uint32_t>(size);
  return place;
}

bool is_address(std::string_view word) {
  const std::string lower = path::to_lower(word);
  for (const std::string_view part : {"topic", "namespace", "service", "plugin"}) {
    if (lower.find(part) != std::string::npos) return true;
  }
  return false;
}

NameKinds kinds_in_word(std::string_view word) {
  if (is_address(word)) return {};
  const std::string lower = path::to_lower(word);
  const auto holds = [&](std::string_view part) { return lower.find(part) != std::string::npos; };
  if (holds("motor")) return NameKind::motor;
  if (holds("joint")) return NameKind::joint;
  if (holds("link") || holds("body") || holds("frame")) return NameKind::link;
  if (holds("collision")) return NameKind::collision;
  if (holds("visual")) return NameKind::visual;
  if (holds("material")) return NameKind::material;
  return holds("sensor") ? NameKinds(NameKind::sensor) : NameKinds();
}

std::optional<std::uint32_t> ReferenceFinder::find(NameKind kind, std::string_view name) {
  if (const NameTable* table = model_.names(kind)) return table->find(name);
  const Annotations& all = model_.annotations;
  switch (kind) {
  case NameKind::node:
    if (!nodes_) {
      nodes_ = table_of(all.nodes, [](const auto& one) { return one.name && one.parent.written; });
    }
    return nodes_->find(name);
  case NameKind::pose:
    if (!poses_) poses_ = table_of(all.poses, [](const auto& one) { return bool(one.name); });
    return poses_->find(name);
  case NameKind::group: return groups_.find(name);
  default: return std::nullopt;
  }
}

bool ReferenceFinder::resolve(Reference& reference) {
  for (NameKinds left = reference.kinds; !left.empty(); left = left.without(left.first())) {
    if (const auto item = find(left.first(), reference.name)) {
      reference.kind = left.first();
      reference.item = *item;
      return true;
    }
  }
  reference.kind = reference.kinds.first();
  return false;
}

void ReferenceFinder::keep(const Reference& reference) {
  const bool is_sound = reference.is_known() && reference.kind == reference.kinds.first();
  if (keeps_all() || !is_sound) found_.push_back(reference);
}

void ReferenceFinder::add(const Naming& naming, std::string_view name, const NamePlace& place) {
  if (naming.defines && !keeps_all()) return;
  Reference reference{.notation = place.notation,
                      .is_definition = naming.defines,
                      .is_vague = naming.is_vague,
                      .around = around_,
                      .kinds = naming.kinds,
                      .place = place.place,
                      .name = name,
                      .span = place.span,
                      .text = place.text};
  const bool is_node =
      naming.kinds.contains(NameKind::link) && naming.kinds.contains(NameKind::collision);
  if (resolve(reference)) {
  } else if (is_node && name.starts_with(kInertial)) {
    Reference link = reference;
    link.kinds = NameKind::link;
    link.name = name.substr(kInertial.size());
    link.span = part_of(place, kInertial.size(), link.name.size()).span;
    const bool is_entry = !naming.kinds.contains(NameKind::node);
    if (resolve(link) || is_entry) reference = link;
  } else if (is_node && !naming.kinds.contains(NameKind::node)) {
    return;  // the entry makes a new node
  }
  if (naming.defines && !reference.is_known()) reference.item = 0;
  keep(reference);
}

bool ReferenceFinder::add_if_known(NameKinds kinds, std::string_view name, const NamePlace& place) {
  for (NameKinds left = kinds; !left.empty(); left = left.without(left.first())) {
    if (!find(left.first(), name)) continue;
    add({kinds}, name, place);
    return true;
  }
  return false;
}

void ReferenceFinder::read_key(const KeySpec& row, yaml::View value, yaml::View entry) {
  const Naming naming = row.names_in != nullptr ? row.names_in(entry) : row.names;
  read_members(row.members, value);
  if (naming.kinds.empty()) return;
  const bool is_map = row.type == ValueType::number_map;
  if (value.is_scalar() && !is_map) {
    add(naming, value.text(), place_of_name(value));
  } else if (value.is_sequence() && !is_map) {
    for (const yaml::View item : value) {
      if (item.is_scalar()) add(naming, item.text(), place_of_name(item));
    }
  } else if (value.is_mapping() && is_map) {
    for (const yaml::View member : value) {
      if (!member.is_null() && !member.is_repeated()) {
        add(naming, member.key(), place_of_key(member));
      } else if (keeps_all()) {
        add_if_known(naming.kinds, member.key(), place_of_key(member));
      }
    }
  }
}

void ReferenceFinder::read_members(KeyTable members, yaml::View value) {
  if (members.size == 0 || value.is_scalar()) return;
  if (value.is_sequence()) {
    for (const yaml::View item : value) {
      if (item.is_mapping()) read_members(members, item);
    }
    return;
  }
  for (const yaml::View member : value) {
    const KeySpec* row = member.is_repeated() ? nullptr : find_key({members.keys()}, member.key());
    if (row != nullptr && is_naming(*row)) read_key(*row, member, value);
  }
}

void ReferenceFinder::read_entry(const Rows& all, const Rows& rows, yaml::View entry) {
  for (const yaml::View value : entry) {
    const std::string_view key = value.key();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const KeySpec* one) { return is_same(one->name, key); });
    if (row != rows.end() && !value.is_repeated()) {
      read_key(**row, value, entry);
    } else if (keeps_all() && (row != rows.end() || !is_known_key(all, value.key()))) {
      read_unknown(value, value.key());
    }
  }
}

void ReferenceFinder::read_section(const SectionSpec& section, yaml::View value) {
  const Rows rows = section.filtered_keys(is_naming);
  const Rows all = keeps_all() ? section.keys() : Rows();
  const bool is_list =
      section.form == SectionForm::named ? value.is_mapping() : value.is_sequence();
  if (is_list) {
    for (const yaml::View entry : value) {
      if (entry.is_mapping()) read_entry(all, rows, entry);
    }
  } else if (section.form == SectionForm::list_or_mapping && value.is_mapping()) {
    read_entry(all, rows, value);
  }
}

void ReferenceFinder::read_unknown(yaml::View value, std::string_view word) {
  const NameKinds kinds = kinds_in_word(word);
  if (value.is_scalar()) {
    if (!kinds.empty()) add_if_known(kinds, value.text(), place_of_name(value));
    return;
  }
  // Names in an alias are read at its anchor; an alias may also contain itself.
  if (node_of(value).is_alias()) return;
  for (const yaml::View member : value) {
    const bool is_member = value.is_mapping();
    if (is_member && !kinds.empty()) add_if_known(kinds, member.key(), place_of_key(member));
    read_unknown(member, is_member && member.key() != "name" ? member.key() : word);
  }
}

void ReferenceFinder::read_annotations() {
  for (const ModelFile& file : model_.files) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View value : root) {
      const SectionSpec* section = value.is_repeated() ? nullptr : find_section(value.key());
      if (section != nullptr) {
        read_section(*section, value);
      } else if (keeps_all()) {
        read_unknown(value, value.key());
      }
    }
  }
}

}  // namespace smurf
