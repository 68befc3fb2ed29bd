// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/robot_srdf.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"

namespace smurf {
namespace {

std::string stem(std::string_view file) {
  const std::string name(path::file_name(file));
  return name.substr(0, name.find('.'));
}

/// Null if there is none, or if several have the same claim.
const Companion* own_srdf(const LinkedModel& model, OwnCompanions& companions) {
  std::vector<const Companion*> found;
  for (const Companion& one : companions.of(model).files) {
    if (!one.srdf) continue;
    const bool has_name =
        one.srdf->name && model.robot->name && *one.srdf->name == *model.robot->name;
    if (has_name || is_tie(one.evidence)) found.push_back(&one);
  }
  for (const Companion* one : found) {
    if (stem(companions.sources().path(one->source)) == stem(model.urdf_path)) return one;
  }
  const bool is_sole =
      found.size() == 1 || (found.size() > 1 && found[0]->evidence < found[1]->evidence);
  return is_sole ? found.front() : nullptr;
}

void add(const srdf::GroupState& state, JointPositions& positions) {
  for (const srdf::StateJoint& joint : state.joints) {
    // A joint of several axes has several values, and no position here.
    const auto value = joint.value ? parse_number(*joint.value) : std::nullopt;
    if (joint.name && value && is_quantity(*value)) positions.emplace(*joint.name, *value);
  }
}

RobotSrdf taken_from(const LinkedModel& model, const srdf::Description& description,
                     std::string file) {
  RobotSrdf result{.file = std::move(file), .pairs = {}, .states = {}};
  for (const srdf::LinkPair& pair : description.pairs) {
    if (pair.is_enabled || !pair.link1 || !pair.link2) continue;
    const auto a = model.link_names.find(*pair.link1);
    const auto b = model.link_names.find(*pair.link2);
    if (a && b && *a != *b) result.pairs.insert(std::minmax<std::size_t>(*a, *b));
  }
  std::map<std::string_view, std::size_t> known;
  for (const srdf::GroupState& state : description.states) {
    if (!state.name) continue;
    const auto [at, is_new] = known.try_emplace(*state.name, result.states.size());
    if (is_new) result.states.emplace_back(*state.name, JointPositions());
    add(state, result.states[at->second].second);
  }
  return result;
}

}  // namespace

RobotSrdf robot_srdf(const LinkedModel& model, const std::string& given,
                     OwnCompanions& companions) {
  if (!given.empty()) {
    const auto named = companions.named(given, CompanionKind::srdf);
    if (named && named->srdf) return taken_from(model, *named->srdf, given);
    return {.file = given, .pairs = {}, .states = {}};
  }
  const Companion* found = own_srdf(model, companions);
  if (found == nullptr) return {};
  return taken_from(model, *found->srdf, std::string(companions.sources().path(found->source)));
}

}  // namespace smurf
