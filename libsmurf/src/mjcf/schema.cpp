// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/schema.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <string>

#include "base/text/words.hpp"

namespace smurf::mjcf {
namespace {

struct Row {
  std::size_t depth;
  std::string_view name;
  char count;
  std::string_view attributes;
};
constexpr Row kRows[] = {
#define SMURF_MJCF(depth, name, count, attributes) {depth, name, count, attributes},
#include "mjcf/schema.def"
#undef SMURF_MJCF
};

class Table {
 public:
  Table() {
    std::vector<Grammar*> open;
    for (const Row& row : kRows) {
      Grammar& one = all_.emplace_back();
      one.name = row.name;
      one.count = row.count;
      for (std::string_view rest = row.attributes; !rest.empty();) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        one.attributes.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
      open.resize(row.depth);
      if (!open.empty()) open.back()->children.push_back(&one);
      open.push_back(&one);
      if (row.count == 'R') one.children.push_back(&one);
    }
    add_bodies();
  }
  const Grammar& root() const { return all_.front(); }

 private:
  /// Adds `worldbody`, `frame` and `replicate`, which contain what a `body` contains. The schema
  /// knows none of their attributes.
  void add_bodies() {
    Grammar& root = all_.front();
    const auto body = std::find_if(all_.begin(), all_.end(),
                                   [](const Grammar& one) { return one.name == "body"; });
    Grammar* const inner = &*body;
    for (const std::string_view name : {"worldbody", "frame", "replicate"}) {
      Grammar& other = all_.emplace_back();
      other.name = name;
      for (const Grammar* child : inner->children) other.children.push_back(child);
      if (name == "worldbody") {
        std::replace(root.children.begin(), root.children.end(), static_cast<const Grammar*>(inner),
                     static_cast<const Grammar*>(&other));
      } else {
        made_.push_back(&other);
      }
    }
    for (Grammar& one : all_) {
      if (one.name != "body" && one.name != "worldbody" && one.name != "frame" &&
          one.name != "replicate")
        continue;
      for (const Grammar* other : made_) one.children.push_back(other);
    }
  }

  std::deque<Grammar> all_;
  std::vector<const Grammar*> made_;
};

}  // namespace

const Grammar* Grammar::child(std::string_view wanted) const {
  const auto found = std::find_if(children.begin(), children.end(),
                                  [&](const Grammar* one) { return one->name == wanted; });
  return found != children.end() ? *found : nullptr;
}

bool Grammar::has_attribute(std::string_view wanted) const {
  return std::find(attributes.begin(), attributes.end(), wanted) != attributes.end();
}

const Grammar& grammar() {
  static const Table kTable;
  return kTable.root();
}

}  // namespace smurf::mjcf
