// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

using Order = std::map<std::string_view, std::pair<std::size_t, Span>>;

bool has_motors(const Sensor& sensor) {
  const bool by_id = sensor.id && !sensor.id->empty() && sensor.type &&
                     sensor_target(*sensor.type) == NameKind::motor;
  return by_id || (sensor.motors && !sensor.motors->empty());
}

void check_pair(const Order& order, std::string_view user, std::string_view used,
                Findings& findings) {
  const auto first = order.find(user);
  const auto second = order.find(used);
  if (first == order.end() || second == order.end()) return;
  if (first->second.first > second->second.first) return;
  Diagnostic& diagnostic = findings.report(
      first->second.second, "MARS reads " + quoted(user) + " before " + quoted(used) +
                                " and finds none of the " + std::string(used) + " it names");
  diagnostic.labels.push_back({second->second.second, "comes too late"});
}

void check(const LinkedModel& model, Findings& findings) {
  Order order;
  std::size_t at = 0;
  for (const TopLevelKey& key : top_level_keys(model)) {
    order.emplace(key.value.key(), std::pair(at++, key.value.key_span()));
  }
  const auto& [sensors, controllers] =
      std::tie(model.annotations.sensors, model.annotations.controllers);
  const auto names_any = [](const Field<NameList>& list) { return list && !list->empty(); };
  if (std::any_of(sensors.begin(), sensors.end(), has_motors)) {
    check_pair(order, "sensors", "motors", findings);
  }
  if (std::any_of(controllers.begin(), controllers.end(),
                  [&](const Controller& c) { return names_any(c.motors); })) {
    check_pair(order, "controllers", "motors", findings);
  }
  if (std::any_of(controllers.begin(), controllers.end(),
                  [&](const Controller& c) { return names_any(c.sensors); })) {
    check_pair(order, "controllers", "sensors", findings);
  }
}

}  // namespace

extern constinit const Rule sml2012_section_order{
    .id = "SML2012",
    .name = "section-order",
    .severity = Severity::error,
    .summary = "A section stands before the one whose names it uses.",
    .why = "MARS works through the sections in the order in which it meets them, main file "
           "first. A controller before the motors or sensors, or a sensor of motors before "
           "the motors, finds none of its names and stays empty, without a message.",
    .remedy = "Move the section, or its file in `files`, behind the other.",
    .sources = "MARS smurf.cpp:223-228, 161-181, 465-480.",
    .check_model = check};

}  // namespace smurf::rules
