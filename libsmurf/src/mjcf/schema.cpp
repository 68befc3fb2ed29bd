// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/schema.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <limits>

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

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// "pos:3", as at the head of schema.def.
Value value_in(std::string_view text) {
  Value value;
  value.is_required = text.ends_with('!');
  if (value.is_required) text.remove_suffix(1);
  const std::size_t colon = std::min(text.find(':'), text.size());
  value.name = text.substr(0, colon);
  text.remove_prefix(std::min(colon + 1, text.size()));
  if (text.empty()) return value;
  if (text == "b") text = "false|true";
  if (text == "a") text = "false|true|auto";
  if (text == "e") text = "disable|enable";
  const bool is_integer = text.size() > 1 && text[0] == 'i' && is_digit(text[1]);
  if (is_integer) text.remove_prefix(1);
  if (text.find('|') != std::string_view::npos || !is_digit(text[0])) {
    value.kind = Value::Kind::word;
    value.words = split(text, '|');
    return value;
  }
  value.kind = is_integer ? Value::Kind::integer : Value::Kind::number;
  const auto count = [](std::string_view digits) {
    std::size_t number = 0;
    for (const char c : digits) number = 10 * number + static_cast<std::size_t>(c - '0');
    return number;
  };
  const bool is_open = text.ends_with('+');
  if (is_open) text.remove_suffix(1);
  const std::size_t dash = std::min(text.find('-'), text.size());
  value.least = count(text.substr(0, dash));
  value.most = dash < text.size() ? count(text.substr(dash + 1)) : value.least;
  if (is_open) value.most = std::numeric_limits<std::size_t>::max();
  return value;
}

/// "(site1+site2|body1)"
Need need_in(std::string_view text) {
  Need need;
  for (const std::string_view group : split(text.substr(1, text.size() - 2), '|'))
    need.groups.push_back(split(group, '+'));
  return need;
}

class Table {
 public:
  Table() {
    std::vector<Grammar*> open;
    for (const Row& row : kRows) {
      Grammar& one = all_.emplace_back();
      one.name = row.name;
      one.count = row.count;
      for (const std::string_view word : split(row.attributes, ' ')) {
        if (word.starts_with('(')) {
          one.needs.push_back(need_in(word));
        } else {
          one.attributes.push_back(value_in(word));
        }
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

const Value* Grammar::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Value& one) { return one.name == wanted; });
  return found != attributes.end() ? &*found : nullptr;
}

const Grammar& grammar() {
  static const Table kTable;
  return kTable.root();
}

}  // namespace smurf::mjcf
