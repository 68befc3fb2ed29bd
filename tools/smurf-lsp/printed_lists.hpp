// SPDX-License-Identifier: BSD-3-Clause
// The long lists of a message as text, because JSON trees take four times the memory.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf-lsp/json.hpp"

namespace smurf::lsp {

class PrintedLists {
 public:
  bool empty() const { return texts_.empty(); }
  void clear() { texts_.clear(); }
  /// Keeps a list and returns its placeholder for the message.
  Json add(std::string list) {
    texts_.push_back(std::move(list));
    return {{"", texts_.size() - 1}};
  }
  /// The text of a message with its lists in place of the placeholders. The parts point into
  /// `message` and into the lists.
  std::vector<std::string_view> insert_into(std::string_view message) const;

 private:
  std::vector<std::string> texts_;
};

}  // namespace smurf::lsp
