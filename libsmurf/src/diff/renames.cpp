// SPDX-License-Identifier: BSD-3-Clause
#include "diff/renames.hpp"

#include <algorithm>

namespace smurf {

void Renames::add(NameKind kind, std::string_view old_name, std::string_view new_name,
                  ModelIndex model) {
  names_[model].try_emplace({kind, std::string(old_name)}, new_name);
}

const Renames::Names& Renames::of_model(ModelIndex model) const {
  static const Names kNothing;
  const auto found = names_.find(model);
  return found == names_.end() ? kNothing : found->second;
}

/// The references within a span.
std::pair<std::size_t, std::size_t> Renames::find(Span place) const {
  if (place.empty()) return {0, 0};
  const auto is_before = [](const Reference& one, std::pair<SourceId, std::uint32_t> at) {
    return std::pair(one.span.source, one.span.begin) < at;
  };
  const auto begin = std::lower_bound(references_.begin(), references_.end(),
                                      std::pair(place.source, place.begin), is_before);
  const auto end =
      std::lower_bound(begin, references_.end(), std::pair(place.source, place.end), is_before);
  return {static_cast<std::size_t>(begin - references_.begin()),
          static_cast<std::size_t>(end - references_.begin())};
}

const std::string* Renames::find(const Reference& reference) const {
  const auto names = names_.find(reference.model);
  if (names == names_.end()) return nullptr;
  const auto name = names->second.find({reference.kind, std::string(reference.name)});
  return name == names->second.end() ? nullptr : &name->second;
}

bool Renames::is_open(Span place) const {
  const auto [begin, end] = find(place);
  for (std::size_t i = begin; i < end; ++i) {
    if (!closed_.contains(references_[i].kind)) return true;
  }
  return false;
}

std::string Renames::translate(std::string_view text, Span place) const {
  std::string translated(text);
  if (names_.empty()) return translated;
  const auto [begin, end] = find(place);
  // Backwards, so that the positions before stay valid.
  for (std::size_t i = end; i > begin; --i) {
    const Reference& reference = references_[i - 1];
    const std::string* name = find(reference);
    if (name == nullptr) continue;
    if (reference.name == text) return *name;
    const std::size_t at = reference.span.begin - place.begin;
    const std::size_t quote = place.end - place.begin == text.size() + 2 ? 1 : 0;
    if (at < quote || at - quote > text.size()) continue;
    if (text.substr(at - quote, reference.name.size()) != reference.name) continue;
    translated.replace(at - quote, reference.name.size(), *name);
  }
  return translated;
}

}  // namespace smurf
