// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/scope.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace smurf::xacro {

const Value* Locals::find(std::string_view name, Meter& meter) const {
  for (const Locals* at = this; at != nullptr; at = at->outer) {
    meter.step((at->names.size() + 7) / 8);
    for (auto one = at->names.rbegin(); one != at->names.rend(); ++one) {
      if (one->first == name) return &one->second;
    }
  }
  return nullptr;
}

std::size_t Table::hash_of(std::string_view name) {
  // Differs from run to run where addresses do, so that no file has names of one chain.
  static const char here = 0;
  const std::uint64_t key = (reinterpret_cast<std::uintptr_t>(&here) >> 4U) * 2 + 1;
  std::uint64_t hash = name.size();
  std::uint64_t word = 0;
  for (; name.size() > sizeof word; name.remove_prefix(sizeof word)) {
    std::memcpy(&word, name.data(), sizeof word);
    hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32U;
  }
  word = 0;
  for (const char c : name) word = word << 8U | static_cast<unsigned char>(c);
  hash = (hash ^ word) * (key * 0xbf58476d1ce4e5b9U);
  return static_cast<std::size_t>(hash ^ hash >> 32U);
}

Table::Entry* Table::own(std::string_view name, std::size_t hash) {
  if (chains_.empty()) return nullptr;
  for (Slot* at = chains_[hash & (chains_.size() - 1)]; at != nullptr; at = at->next) {
    if (at->hash == hash && at->name == name) return &at->entry;
  }
  return nullptr;
}

Table::Found Table::find(std::string_view name) {
  const std::size_t hash = hash_of(name);
  std::uint32_t levels = 0;
  for (Table* at = this; at != nullptr; at = at->parent_, ++levels) {
    if (Entry* entry = at->own(name, hash)) return {entry, at, levels};
  }
  return {};
}

void Table::grow() {
  const std::size_t size = std::max<std::size_t>(8, 4 * chains_.size());
  const std::span<Slot*> before = chains_;
  chains_ = {static_cast<Slot**>(arena_.take(size * sizeof(Slot*))), size};
  std::fill(chains_.begin(), chains_.end(), nullptr);
  for (Slot* at : before) {
    while (at != nullptr) {
      Slot* const next = at->next;
      Slot*& chain = chains_[at->hash & (size - 1)];
      at->next = chain;
      chain = at;
      at = next;
    }
  }
}

void Table::set(std::string_view name, const Value& value, bool is_unevaluated) {
  const std::size_t hash = hash_of(name);
  Entry* entry = own(name, hash);
  if (entry == nullptr) {
    if (count_++ >= chains_.size()) grow();
    Slot*& chain = chains_[hash & (chains_.size() - 1)];
    Slot& slot = arena_.make<Slot>();
    slot.name = name;
    slot.hash = hash;
    slot.next = chain;
    chain = &slot;
    entry = &slot.entry;
  }
  entry->value = value;
  entry->is_unevaluated = is_unevaluated;
}

void Table::remove(std::string_view name) {
  const std::size_t hash = hash_of(name);
  for (Table* at = this; !at->is_root(); at = at->parent_) {
    if (at->chains_.empty()) continue;
    Slot** link = &at->chains_[hash & (at->chains_.size() - 1)];
    while (*link != nullptr && (*link)->name != name) link = &(*link)->next;
    if (*link == nullptr) continue;
    *link = (*link)->next;
    --at->count_;
  }
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

void Table::append_names(std::vector<std::string_view>& names, bool with_functions) const {
  for (const Table* at = this; at != nullptr; at = at->parent_) {
    if (at->is_root() && !with_functions) return;
    for (const Slot* slot : at->chains_) {
      for (; slot != nullptr; slot = slot->next) {
        if (!slot->name.starts_with('*')) names.push_back(slot->name);
      }
    }
  }
}

}  // namespace smurf::xacro
