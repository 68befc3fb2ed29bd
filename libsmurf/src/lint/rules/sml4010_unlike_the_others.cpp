// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ast/keys.hpp"
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4010_unlike_the_others_file {
namespace {

constexpr Circumstance kBitmask{"bitmask"};
constexpr Circumstance kLink{"link"};
constexpr Circumstance kMinValue{"minValue"};
constexpr Circumstance kName{"name"};
constexpr Circumstance kP{"p"};
constexpr Circumstance kType{"type"};

/// A key that some reader needs, and keys that replace it.
struct Needed {
  const Circumstance* lack;  ///< its name is the key
  std::array<std::string_view, 3> instead;
  std::size_t fewest_others = 1;  ///< entries with the key, before one without it is reported

  std::string_view key() const { return lack->name; }
};
constexpr Needed kTypeOfMotor{&kType, {}};
constexpr Needed kOfPositionMotors[] = {
    {&kP, {}},
    {&kMinValue, {"minPosition", "maxValue", "maxPosition"}},
};
constexpr Needed kOfCollisions[] = {{&kLink, {}, 2}, {&kBitmask, {}, 2}};
constexpr Needed kOfLinks[] = {{&kLink, {}}, {&kName, {}}};

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads 0, so the motor does not follow its commands",
     "MARS SimMotor.cpp:352-407", when(kP)},
    {&readers::mars, Effect::changes, "lets the motor go half a turn, or 3.14 m, either way",
     "MARS MotorData.cpp", when(kMinValue)},
    {&readers::mars, Effect::loses, "matches by the name, and ignores the entry", "MARS smurf.cpp",
     when(kName)},
    {&readers::phobos, Effect::loses, "matches by the name, and ignores the entry",
     "Phobos core/robot.py", when(kName)},
    {&readers::mars2, Effect::refuses, "stops at a motor without it",
     "envire_smurf_loader Model.cpp:443-505", when(kType)},
    {&readers::mars2, Effect::refuses, "stops at an entry without it",
     "envire_smurf_loader Model.cpp:216-230", when(kLink)},
    {&readers::envire, Effect::changes, "reads 0, with which nothing collides",
     "rock-cpp/smurf Robot.cpp:53-83", when(kBitmask)},
};

bool has_key(yaml::View mapping, const Needed& needed) {
  const auto is_given = [&](std::string_view key) {
    const yaml::View value = key.empty() ? yaml::View() : mapping.find(key);
    return value && !value.is_null();
  };
  return is_given(needed.key()) ||
         std::any_of(needed.instead.begin(), needed.instead.end(), is_given);
}

/// A better explanation exists: the rest of the entry is in another file, or the key is misspelt.
bool is_excused(yaml::View mapping, const Needed& needed) {
  constexpr std::size_t kShort = 2;  // letters of such keys resemble each other by chance
  if (mapping.find("URI") || mapping.find("URIs")) return true;
  if (needed.key().size() > kShort) return has_misspelt(mapping, needed.key());
  return std::any_of(mapping.begin(), mapping.end(),
                     [&](yaml::View value) { return path::to_lower(value.key()) == needed.key(); });
}

/// Reports the entry without the needed key, when exactly one of `entries` lacks it.
template <class T, class Counts>
void check_entries(const LinkedModel& model, const std::vector<T>& entries, std::string_view what,
                   const Needed& needed, Findings& findings, Counts counts) {
  const T* odd = nullptr;
  std::size_t count = 0;
  for (const T& entry : entries) {
    if (!counts(entry)) continue;
    ++count;
    if (has_key(mapping_of(model, entry), needed)) continue;
    if (odd != nullptr) return;
    odd = &entry;
  }
  if (odd == nullptr || count <= needed.fewest_others) return;
  const yaml::View mapping = mapping_of(model, *odd);
  if (is_excused(mapping, needed)) return;
  const std::size_t others = count - 1;
  Diagnostic& diagnostic = findings.report(
      odd->name.written ? odd->name.span : odd->span,
      subject(what, *odd) + " has no " + quoted(needed.key()) + ", unlike " +
          (others == 1 ? "the other one" : "the " + std::to_string(others) + " others"));
  diagnostic.label(place_to_add(mapping, needed.key()), "add it after this key");
  diagnostic.when(*needed.lack);
  for (const Fact& fact : kFacts) {
    if (!fact.where.needs(*needed.lack)) continue;
    diagnostic.note(std::string(fact.reader->title) + " " + std::string(fact.makes));
  }
}

/// Only they have gains and bounds.
bool is_position_motor(const Motor& motor) {
  // An unknown type is reported; it may be any type.
  return motor.type &&
         (*motor.type == "PID" || *motor.type == "generic_bldc" || *motor.type == "1") &&
         !motor.mimic_motor.written;
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  const auto any = [](const Annotation&) { return true; };
  check_entries(model, all.motors, "motor", kTypeOfMotor, findings, any);
  for (const Needed& needed : kOfPositionMotors) {
    check_entries(model, all.motors, "motor", needed, findings, is_position_motor);
  }
  for (const Needed& needed : kOfCollisions) {
    check_entries(model, all.collisions, "collision entry", needed, findings, any);
  }
  for (const Needed& needed : kOfLinks) {
    check_entries(model, all.links, "link entry", needed, findings, any);
  }
}

}  // namespace

extern constinit const Rule sml4010_unlike_the_others{
    .id = "SML4010",
    .name = "unlike-the-others",
    .severity = Severity::warning,
    .summary = "One entry lacks a key that all other entries of its section have.",
    .why =
        "Some reader needs each of these keys. A single entry without the key is rarely intended.",
    .remedy = "Add the key.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml4010_unlike_the_others_file
