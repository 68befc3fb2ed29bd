// SPDX-License-Identifier: BSD-3-Clause
// Long lists of a message, printed: as trees they take four times the memory of their text.
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
  /// What stands for the list in the message.
  Json add(std::string list) {
    texts_.push_back(std::move(list));
    return {{"", texts_.size() - 1}};
  }
  /// The text of a message with its lists, in parts that point into both.
  std::vector<std::string_view> insert_into(std::string_view message) const;

 private:
  std::vector<std::string> texts_;
};

}  // namespace smurf::lsp
