// SPDX-License-Identifier: BSD-3-Clause
#include "flatten/plain_values.hpp"

#include <cmath>
#include <set>

namespace smurf {
namespace {

Value scalar_value(yaml::View node) {
  switch (node.type()) {
  case yaml::ScalarType::null: return {};
  case yaml::ScalarType::boolean:
    if (const auto boolean = node.boolean()) return {*boolean};
    break;
  case yaml::ScalarType::integer:
  case yaml::ScalarType::number:
    if (const auto integer = node.integer()) return {*integer};
    if (const auto number = node.number(); number && std::isfinite(*number)) return {*number};
    break;
  case yaml::ScalarType::text: break;
  }
  return {std::string(node.text())};
}

}  // namespace

Value to_value(yaml::View node) {
  switch (node.kind()) {
  case yaml::Kind::null: return {};
  case yaml::Kind::scalar: return scalar_value(node);
  case yaml::Kind::mapping: return {to_object(node)};
  case yaml::Kind::sequence: break;
  }
  Value::List list;
  for (const yaml::View item : node) list.push_back(to_value(item));
  return {std::move(list)};
}

Value::Object to_object(yaml::View mapping) {
  Value::Object object;
  std::set<std::string_view> keys;
  for (const yaml::View member : mapping) {
    if (!keys.insert(member.key()).second) continue;
    object.push_back({std::string(member.key()), to_value(member)});
  }
  return object;
}

}  // namespace smurf
