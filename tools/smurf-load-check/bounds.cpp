// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/bounds.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "common/cli/command.hpp"

namespace smurf::load_check {
namespace {

std::size_t index_of(std::string_view name) {
  const auto* found = std::find_if(kBounds.begin(), kBounds.end(),
                                   [&](const BoundInfo& info) { return info.name == name; });
  return static_cast<std::size_t>(found - kBounds.begin());
}

}  // namespace

Bounds::Bounds() {
  for (std::size_t i = 0; i < kBounds.size(); ++i) limits_[i] = kBounds[i].limit;
}

double Bounds::operator[](std::string_view name) const {
  assert(index_of(name) < kBounds.size());
  return limits_[index_of(name)];
}

std::optional<std::string> Bounds::set(std::string_view assignment) {
  const std::size_t equals = std::min(assignment.find('='), assignment.size());
  const std::string_view name = assignment.substr(0, equals);
  const std::size_t index = index_of(name);
  if (index == kBounds.size()) {
    std::vector<std::string_view> known;
    for (const BoundInfo& info : kBounds) known.push_back(info.name);
    return tools::none_of(name, known);
  }
  if (equals == assignment.size()) return "'" + std::string(name) + "' has no value: NAME=VALUE";
  const auto value = parse_number(assignment.substr(equals + 1));
  if (!value || !(*value >= 0)) {
    return "'" + std::string(assignment.substr(equals + 1)) + "' is not a number of at least 0";
  }
  limits_[index] = *value;
  return std::nullopt;
}

const BoundInfo& bound_info(std::string_view name) {
  assert(index_of(name) < kBounds.size());
  return kBounds[index_of(name)];
}

}  // namespace smurf::load_check
