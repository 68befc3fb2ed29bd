// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/text_search.hpp"

#include <algorithm>

namespace smurf::xacro {

TextSearch::TextSearch(std::string_view wanted, Meter& meter, Direction direction)
    : wanted_(wanted), meter_(meter), direction_(direction) {
  if (wanted.size() < 2) return;
  meter.scan(wanted.size());
  const Suffix one = largest_suffix(false);
  const Suffix other = largest_suffix(true);
  const Suffix& later = one.begin > other.begin ? one : other;
  middle_ = later.begin;
  period_ = later.period;
  is_periodic_ = true;
  for (std::size_t i = 0; i < middle_ && is_periodic_; ++i) {
    is_periodic_ = wanted_at(i) == wanted_at(i + period_);
  }
  if (!is_periodic_) period_ = std::max(middle_, wanted.size() - middle_) + 1;
}

TextSearch::Suffix TextSearch::largest_suffix(bool is_inverse) const {
  Suffix suffix;
  std::size_t candidate = 1;
  std::size_t same = 0;  // characters that the two have in common, within a period
  while (candidate + same < wanted_.size()) {
    const auto a = static_cast<unsigned char>(wanted_at(candidate + same));
    const auto b = static_cast<unsigned char>(wanted_at(suffix.begin + same));
    if (a == b) {
      if (++same == suffix.period) {
        candidate += same;
        same = 0;
      }
    } else if ((a < b) != is_inverse) {
      candidate += same + 1;
      same = 0;
      suffix.period = candidate - suffix.begin;
    } else {
      suffix = {candidate, 1};
      ++candidate;
      same = 0;
    }
  }
  return suffix;
}

template <class At>
std::size_t TextSearch::search(const At& at, std::size_t size) const {
  const std::size_t length = wanted_.size();
  std::size_t known = 0;  // characters at the begin that are known to match
  for (std::size_t place = 0; place + length <= size;) {
    std::size_t i = std::max(middle_, known);
    while (i < length && wanted_at(i) == at(place + i)) ++i;
    if (i < length) {
      place += i - middle_ + 1;
      known = 0;
      continue;
    }
    i = middle_;
    while (i > known && wanted_at(i - 1) == at(place + i - 1)) --i;
    if (i <= known) return place;
    place += period_;
    known = is_periodic_ ? length - period_ : 0;
  }
  return std::string_view::npos;
}

std::size_t TextSearch::find(std::string_view text, std::size_t from) const {
  if (direction_ == Direction::forwards) {
    if (from > text.size()) return std::string_view::npos;
    const std::string_view rest = text.substr(from);
    const std::size_t found = wanted_.empty() ? 0
                              : wanted_.size() == 1
                                  ? rest.find(wanted_[0])
                                  : search([&](std::size_t i) { return rest[i]; }, rest.size());
    meter_.step(1 + (std::min(found, rest.size()) + wanted_.size()) / 16);
    return found == std::string_view::npos ? found : from + found;
  }
  const std::size_t size = text.size();
  if (wanted_.empty()) return size;
  const std::size_t found = search([&](std::size_t i) { return text[size - 1 - i]; }, size);
  meter_.step(1 + (std::min(found, size) + wanted_.size()) / 16);
  return found == std::string_view::npos ? found : size - found - wanted_.size();
}

}  // namespace smurf::xacro
