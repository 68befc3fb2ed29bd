// SPDX-License-Identifier: BSD-3-Clause
// Tables of properties, parameters and functions; each hangs below that of the caller.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "xacro/arena.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {

/// Names of a lambda or of a comprehension.
struct Locals {
  const Locals* outer = nullptr;
  std::vector<std::pair<std::string_view, Value>> names;
  std::vector<Value> defaults;  ///< of the last parameters of a lambda

  const Value* find(std::string_view name, Meter& meter) const;
};

class Table {
 public:
  struct Entry {
    Value value;
    bool is_unevaluated = false;  ///< a text that is evaluated when it is first used
    bool is_evaluating = false;
  };

  /// A table without parent is that of the functions.
  explicit Table(Arena& arena, bool is_namespace = false)
      : arena_(arena), is_namespace_(is_namespace) {}
  explicit Table(Table& parent, bool is_namespace = false)
      : arena_(parent.arena_), parent_(&parent), is_namespace_(is_namespace) {}

  Table* parent() const { return parent_; }
  bool is_root() const { return parent_ == nullptr; }
  bool is_namespace() const { return is_namespace_; }

  /// The entry of this table; null if there is none.
  Entry* own(std::string_view name) { return own(name, hash_of(name)); }
  /// The entry of this table or the nearest above, and its table.
  struct Found {
    Entry* entry = nullptr;
    Table* table = nullptr;
    std::uint32_t levels = 0;  ///< tables that were searched
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
  /// Of this table and those above; functions are in the root.
  void append_names(std::vector<std::string_view>& names, bool with_functions) const;

 private:
  /// In the arena: most tables are of one call, and nearly all names are looked up in several.
  struct Slot {
    std::string_view name;
    std::size_t hash = 0;
    Slot* next = nullptr;
    Entry entry;
  };

  static std::size_t hash_of(std::string_view name);
  Entry* own(std::string_view name, std::size_t hash);
  void grow();

  Arena& arena_;
  Table* parent_ = nullptr;
  bool is_namespace_ = false;
  std::span<Slot*> chains_;  ///< a power of two
  std::size_t count_ = 0;
};

}  // namespace smurf::xacro
