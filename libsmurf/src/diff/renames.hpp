// SPDX-License-Identifier: BSD-3-Clause
// Translates names of the old version to names of the new version.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diff/properties.hpp"

namespace smurf {

/// The renamed things, and the places of their names in the old version.
class Renames {
 public:
  /// `references` are sorted by place and must outlive this.
  explicit Renames(const std::vector<Reference>& references) : references_(references) {}

  /// The model of a name in a scene.
  void add(NameKind kind, std::string_view old_name, std::string_view new_name,
           ModelIndex model = ModelIndex{Reference::kNothing});
  /// Call it after matching all things of this kind.
  void close(NameKind kind) { closed_.insert(kind); }

  /// A text of the old version with the names of the new one.
  std::string translate(std::string_view text, Span place) const;
  /// Whether it contains a name of a kind that is not fully matched yet.
  bool is_open(Span place) const;
  const std::map<std::pair<NameKind, std::string>, std::string>& of_model(ModelIndex model) const;

 private:
  std::pair<std::size_t, std::size_t> find(Span place) const;
  const std::string* find(const Reference& reference) const;

  using Names = std::map<std::pair<NameKind, std::string>, std::string>;
  const std::vector<Reference>& references_;
  std::map<ModelIndex, Names> names_;
  std::set<NameKind> closed_;
};

}  // namespace smurf
