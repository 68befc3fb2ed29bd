// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2012_section_order_file {
namespace {

using Order = std::map<std::string_view, std::pair<std::size_t, Span>>;

bool has_motors(const Sensor& sensor) {
  const bool by_id = sensor.id && !sensor.id->empty() && sensor.type &&
                     sensor_target(*sensor.type) == NameKind::motor;
  return by_id || (sensor.motors && !sensor.motors->empty());
}

bool comes_before(const Order& order, std::string_view user, std::string_view used) {
  const auto first = order.find(user);
  const auto second = order.find(used);
  return first != order.end() && second != order.end() &&
         first->second.first < second->second.first;
}

/// Entries of `user` refer to entries of the sections `used`.
void check_order(const LinkedModel& model, const Order& order, std::string_view user,
                 const std::vector<std::string_view>& used, Findings& findings) {
  std::string late;
  for (const std::string_view section : used) {
    if (comes_before(order, user, section)) late += (late.empty() ? "" : " and ") + quoted(section);
  }
  if (late.empty()) return;
  const Span place = order.at(user).second;
  Diagnostic& diagnostic = findings.report(place, "MARS reads " + quoted(user) + " before " + late +
                                                      " and does not find the entries that it "
                                                      "names");
  for (const std::string_view section : used) {
    if (!comes_before(order, user, section)) continue;
    diagnostic.label(order.at(section).second, "read later");
  }
  const Span listed = place_in_files(model, place.source);
  if (!listed.empty()) diagnostic.label(listed, "the file is listed here");
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
    check_order(model, order, "sensors", {"motors"}, findings);
  }
  std::vector<std::string_view> used;
  if (std::any_of(controllers.begin(), controllers.end(),
                  [&](const Controller& c) { return names_any(c.motors); })) {
    used.push_back("motors");
  }
  if (std::any_of(controllers.begin(), controllers.end(),
                  [&](const Controller& c) { return names_any(c.sensors); })) {
    used.push_back("sensors");
  }
  check_order(model, order, "controllers", used, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "reads sections in file order: a controller before its motors or sensors, or a sensor "
     "before its motors, does not find them and silently stays empty",
     "MARS smurf.cpp:223-228, 161-181, 465-480"},
};

}  // namespace

extern constinit const Rule sml2012_section_order{
    .id = "SML2012",
    .name = "section-order",
    .severity = Severity::error,
    .summary = "A section comes before the one whose names it uses.",
    .remedy = "Move the section, or its file in `files`, after the other.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2012_section_order_file
