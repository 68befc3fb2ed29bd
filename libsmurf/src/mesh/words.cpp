// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/words.hpp"

#include <algorithm>

namespace smurf {
std::string_view Words::rest_of_line() {
  while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  at_ = std::min(text_.find('\n', at_), text_.size());
  std::size_t end = at_;
  while (end > begin && is_blank(text_[end - 1])) --end;
  return text_.substr(begin, end - begin);
}

std::string_view Words::next_line() {
  if (at_ < text_.size() && text_[at_] == '\n') {
    ++at_;
    ++line_;
  }
  return rest_of_line();
}

}  // namespace smurf
