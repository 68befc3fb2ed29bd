// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/schema.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <utility>

namespace smurf::sdformat {
namespace {

struct Row {
  std::string_view type;  ///< empty: a row below one
  std::size_t depth;
  std::string_view name;
  char count;
  std::string_view kind;
  std::string_view attributes;
};
constexpr Row kRows[] = {
#define SMURF_SDF_TYPE(type, name, count, kind, attributes)                                        \
  {type, 0, name, count, kind, attributes},
#define SMURF_SDF(depth, name, count, kind, attributes) {"", depth, name, count, kind, attributes},
#include "sdf/schema.def"
#undef SMURF_SDF
#undef SMURF_SDF_TYPE
};

ValueKind kind_of(std::string_view word) {
  word = word.substr(0, word.find('['));
  constexpr std::pair<std::string_view, ValueKind> kWords[] = {
      {"any", ValueKind::any},
      {"text", ValueKind::text},
      {"bool", ValueKind::boolean},
      {"int", ValueKind::integer},
      {"double", ValueKind::number},
      {"float", ValueKind::single},
      {"time", ValueKind::numbers2},
      {"vector2d", ValueKind::numbers2},
      {"uint", ValueKind::unsigned_integer},
      {"vector3", ValueKind::numbers3},
      {"color", ValueKind::color},
      {"pose", ValueKind::pose}};
  const auto* found = std::find_if(std::begin(kWords), std::end(kWords),
                                   [&](const auto& one) { return one.first == word; });
  return found != std::end(kWords) ? found->second : ValueKind::none;
}

/// Of "double[0,1]": "0,1".
std::string_view range_of(std::string_view word) {
  const std::size_t at = word.find('[');
  return at == std::string_view::npos ? std::string_view()
                                      : word.substr(at + 1, word.size() - at - 2);
}

class Table {
 public:
  Table() {
    std::vector<Grammar*> open;
    for (const Row& row : kRows) {
      open.resize(row.depth);
      if (row.name.starts_with('@')) {
        uses_.push_back({open.back(), row.name.substr(1)});
        continue;
      }
      Grammar& one = all_.emplace_back();
      one.name = row.name;
      one.count = row.count;
      one.kind = kind_of(row.kind);
      one.range = range_of(row.kind);
      read_attributes(row.attributes, one);
      if (!row.type.empty()) types_.emplace(row.type, &one);
      if (!open.empty()) open.back()->children.push_back(&one);
      open.push_back(&one);
    }
    for (const auto& [where, type] : uses_) {
      const auto found = types_.find(type);
      if (found != types_.end()) where->children.push_back(found->second);
    }
  }
  const Grammar& root() const { return all_.front(); }

 private:
  /// "name! degrees:bool": one that is required, and one with a kind.
  static void read_attributes(std::string_view rest, Grammar& one) {
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      std::string_view word = rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
      AttributeRow& row = one.attributes.emplace_back();
      const std::size_t colon = word.find(':');
      if (colon != std::string_view::npos) row.kind = kind_of(word.substr(colon + 1));
      word = word.substr(0, colon);
      row.is_required = word.ends_with('!');
      row.name = word.substr(0, word.size() - (row.is_required ? 1 : 0));
    }
  }

  std::deque<Grammar> all_;
  std::map<std::string_view, const Grammar*> types_;
  std::vector<std::pair<Grammar*, std::string_view>> uses_;
};

}  // namespace

const Grammar* Grammar::child(std::string_view wanted) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const Grammar* one) { return one->name == wanted; });
  return found != children.end() ? *found : nullptr;
}

const AttributeRow* Grammar::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const AttributeRow& one) { return one.name == wanted; });
  return found != attributes.end() ? &*found : nullptr;
}

const Grammar& grammar() {
  static const Table kTable;
  return kTable.root();
}

}  // namespace smurf::sdformat
