// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/printed_lists.hpp"

#include "base/numbers/numbers.hpp"

namespace smurf::lsp {

std::vector<std::string_view> PrintedLists::insert_into(std::string_view message) const {
  constexpr std::string_view kPlace = R"({"":)";  // not in strings, which escape quotes
  std::vector<std::string_view> parts;
  std::size_t at = empty() ? std::string_view::npos : message.find(kPlace);
  while (at != std::string_view::npos) {
    const std::size_t number = at + kPlace.size();
    const std::size_t end = message.find('}', number);
    const auto index = parse_integer(message.substr(number, end - number));
    const bool is_place = index && *index >= 0 && static_cast<std::size_t>(*index) < texts_.size();
    parts.push_back(message.substr(0, is_place ? at : number));
    if (is_place) parts.push_back(texts_[static_cast<std::size_t>(*index)]);
    message.remove_prefix(is_place ? end + 1 : number);
    at = message.find(kPlace);
  }
  parts.push_back(message);
  return parts;
}

}  // namespace smurf::lsp
