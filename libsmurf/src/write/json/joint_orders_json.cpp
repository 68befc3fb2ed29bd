// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "smurf/write.hpp"
#include "write/text/json_printer.hpp"

namespace smurf {
namespace {

void add_places(JsonPrinter& json, std::string_view key, const std::vector<std::string>& from,
                const std::vector<std::string>& to) {
  json.key(key);
  json.begin_list();
  for (const auto& place : permutation(from, to)) {
    if (place) {
      json.integer(static_cast<std::int64_t>(*place));
    } else {
      json.null();
    }
  }
  json.end();
}

void add_names(JsonPrinter& json, std::string_view key, const std::vector<std::string>& names) {
  json.key(key);
  json.begin_list();
  for (const std::string& name : names) json.text(name);
  json.end();
}

}  // namespace

std::string write_joint_orders_json(std::span<const JointOrder> orders) {
  JsonPrinter json(std::numeric_limits<std::uint64_t>::max());
  json.begin_object(JsonPrinter::Layout::block);
  json.key("orders");
  json.begin_list(JsonPrinter::Layout::block);
  for (const JointOrder& order : orders) {
    json.begin_object();
    json.member("reader", order.reader->name);
    json.key("known");
    json.boolean(order.is_known);
    json.member("walk", order.walk);
    json.member("basis", order.basis);
    add_names(json, "joints", order.joints);
    json.key("indices");
    json.begin_list();
    for (const std::size_t index : order.indices) json.integer(static_cast<std::int64_t>(index));
    json.end();
    add_names(json, "bodies", order.bodies);
    json.end();
  }
  json.end();
  json.key("permutations");
  json.begin_list(JsonPrinter::Layout::block);
  for (const JointOrder& from : orders) {
    for (const JointOrder& to : orders) {
      if (&from == &to || !from.is_known || !to.is_known) continue;
      json.begin_object();
      json.member("from", from.reader->name);
      json.member("to", to.reader->name);
      add_places(json, "joints", from.joints, to.joints);
      add_places(json, "bodies", from.bodies, to.bodies);
      json.end();
    }
  }
  json.end();
  json.end();
  return *json.take();
}

}  // namespace smurf
