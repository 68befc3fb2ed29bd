// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/scope.hpp"

namespace smurf::xacro {

const Value* Locals::find(std::string_view name) const {
  for (const Locals* at = this; at != nullptr; at = at->outer) {
    for (auto one = at->names.rbegin(); one != at->names.rend(); ++one) {
      if (one->first == name) return &one->second;
    }
  }
  return nullptr;
}

Table::Entry* Table::own(std::string_view name) {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

Table::Found Table::find(std::string_view name) {
  for (Table* at = this; at != nullptr; at = at->parent_) {
    if (Entry* entry = at->own(name)) return {entry, at};
  }
  return {};
}

void Table::set(std::string_view name, const Value& value, bool is_unevaluated) {
  Entry& entry = entries_[name];
  entry.value = value;
  entry.is_unevaluated = is_unevaluated;
}

void Table::remove(std::string_view name) {
  for (Table* at = this; !at->is_root(); at = at->parent_) at->entries_.erase(name);
}

Table* Table::top() {
  Table* at = this;
  while (!at->is_root() && !at->parent_->is_root()) at = at->parent_;
  return at;
}

Table* Table::root() {
  Table* at = this;
  while (!at->is_root()) at = at->parent_;
  return at;
}

void Table::append_names(std::vector<std::string_view>& names) const {
  for (const Table* at = this; at != nullptr; at = at->parent_) {
    for (const auto& [name, entry] : at->entries_) {
      if (!name.starts_with('*')) names.push_back(name);
    }
  }
}

}  // namespace smurf::xacro
