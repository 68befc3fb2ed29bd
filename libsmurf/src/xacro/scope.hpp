// SPDX-License-Identifier: BSD-3-Clause
// Tables of properties, parameters and functions; each hangs below that of the caller.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "xacro/value.hpp"

namespace smurf::xacro {

/// Names of a lambda or of a comprehension.
struct Locals {
  const Locals* outer = nullptr;
  std::vector<std::pair<std::string_view, Value>> names;
  std::vector<Value> defaults;  ///< of the last parameters of a lambda

  const Value* find(std::string_view name) const;
};

class Table {
 public:
  struct Entry {
    Value value;
    bool is_unevaluated = false;  ///< a text that is evaluated when it is first used
    bool is_evaluating = false;
  };

  /// A table without parent is that of the functions.
  explicit Table(Table* parent = nullptr, bool is_namespace = false)
      : parent_(parent), is_namespace_(is_namespace) {}

  Table* parent() const { return parent_; }
  bool is_root() const { return parent_ == nullptr; }
  bool is_namespace() const { return is_namespace_; }

  /// The entry of this table; null if there is none.
  Entry* own(std::string_view name);
  /// The entry of this table or the nearest above, and its table.
  struct Found {
    Entry* entry = nullptr;
    Table* table = nullptr;
    explicit operator bool() const { return entry != nullptr; }
  };
  Found find(std::string_view name);
  /// `name` must live as long as the table.
  void set(std::string_view name, const Value& value, bool is_unevaluated = false);
  /// From this table and those above, except for functions.
  void remove(std::string_view name);
  /// The table of the whole robot.
  Table* top();
  Table* root();
  void append_names(std::vector<std::string_view>& names) const;

 private:
  Table* parent_;
  bool is_namespace_;
  std::unordered_map<std::string_view, Entry> entries_;
};

}  // namespace smurf::xacro
