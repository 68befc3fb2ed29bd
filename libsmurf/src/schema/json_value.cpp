// SPDX-License-Identifier: BSD-3-Clause
#include "schema/json_value.hpp"

#include <cmath>
#include <string>

#include "base/numbers/bits.hpp"
#include "base/numbers/hash.hpp"

namespace smurf {
namespace {

constexpr std::size_t kBytesForNode = 64;  ///< comparing so many bytes costs about as one node

std::size_t mix(std::size_t seed, std::size_t hash) {
  constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;
  const std::uint64_t mixed = (static_cast<std::uint64_t>(seed) ^ hash) * kOdd;
  return static_cast<std::size_t>(mixed ^ (mixed >> 29U));
}

std::size_t hash_of_text(std::string_view text, std::size_t& visited) {
  visited += text.size() / kBytesForNode;
  return smurf::hash_of(text);
}

std::size_t hash_of_number(double number) {
  const auto bits = bit_cast<std::uint64_t>(number == 0 ? 0.0 : number);  // -0 equals 0
  char bytes[sizeof bits];
  for (std::size_t i = 0; i < sizeof bits; ++i) bytes[i] = static_cast<char>(bits >> (8 * i));
  return smurf::hash_of({bytes, sizeof bytes});
}

}  // namespace

std::size_t member_count(yaml::View mapping) {
  std::size_t count = 0;
  for (const yaml::View member : mapping) count += member.is_repeated() ? 0 : 1;
  return count;
}

JsonType json_type(yaml::View value) {
  switch (value.kind()) {
  case yaml::Kind::null: return JsonType::null;
  case yaml::Kind::sequence: return JsonType::list;
  case yaml::Kind::mapping: return JsonType::mapping;
  case yaml::Kind::scalar: break;
  }
  if (value.boolean()) return JsonType::boolean;
  return value.number() ? JsonType::number : JsonType::text;
}

bool has_type(yaml::View value, std::string_view type) {
  switch (json_type(value)) {
  case JsonType::null: return type == "null";
  case JsonType::boolean: return type == "boolean";
  case JsonType::text: return type == "string";
  case JsonType::list: return type == "array";
  case JsonType::mapping: return type == "object";
  case JsonType::number: break;
  }
  if (type == "number") return true;
  const double number = *value.number();
  return type == "integer" && std::isfinite(number) && std::trunc(number) == number;
}

std::size_t hash_of(yaml::View value, std::size_t& visited) {
  ++visited;
  const JsonType type = json_type(value);
  std::size_t hash = static_cast<std::size_t>(type) + 1;
  switch (type) {
  case JsonType::null: return hash;
  case JsonType::boolean: return mix(hash, *value.boolean() ? 1 : 0);
  case JsonType::number: return mix(hash, hash_of_number(*value.number()));
  case JsonType::text: return mix(hash, hash_of_text(value.text(), visited));
  case JsonType::list:
    for (const yaml::View item : value) hash = mix(hash, hash_of(item, visited));
    return hash;
  case JsonType::mapping: break;
  }
  for (const yaml::View member : value) {  // a sum, because the order does not count
    if (member.is_repeated()) continue;
    hash += mix(hash_of_text(member.key(), visited), hash_of(member, visited));
  }
  return hash;
}

bool are_equal(yaml::View a, yaml::View b, std::size_t& visited) {
  ++visited;
  const JsonType type = json_type(a);
  if (type != json_type(b)) return false;
  switch (type) {
  case JsonType::null: return true;
  case JsonType::boolean: return *a.boolean() == *b.boolean();
  case JsonType::number: return *a.number() == *b.number();
  case JsonType::text: visited += a.text().size() / kBytesForNode; return a.text() == b.text();
  case JsonType::list: {
    if (a.size() != b.size()) return false;
    auto other = b.begin();
    for (const yaml::View item : a) {
      if (!are_equal(item, *other++, visited)) return false;
    }
    return true;
  }
  case JsonType::mapping: break;
  }
  if (member_count(a) != member_count(b)) return false;
  for (const yaml::View member : a) {
    if (member.is_repeated()) continue;
    visited += b.size();
    const yaml::View other = b.find(member.key());
    if (!other || !are_equal(member, other, visited)) return false;
  }
  return true;
}

}  // namespace smurf
