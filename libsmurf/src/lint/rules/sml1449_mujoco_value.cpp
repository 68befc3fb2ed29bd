// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <string>

#include "ast/urdf_numbers.hpp"
#include "base/numbers.hpp"
#include "base/path.hpp"
#include "base/ranges.hpp"
#include "base/readers.hpp"
#include "base/words.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// The attributes of `compiler` that MuJoCo reads; it ignores others.
constexpr std::string_view kFlags[] = {"autolimits",    "balanceinertia", "strippath",
                                       "discardvisual", "fusestatic",     "usethread",
                                       "fitaabb",       "saveinertial",   "alignfree"};
constexpr std::string_view kNumbers[] = {"boundmass", "boundinertia", "settotalmass"};

bool is_number(std::string_view text) {
  const std::string lower = path::to_lower(text);
  const std::string_view bare =
      lower.starts_with('-') || lower.starts_with('+') ? std::string_view(lower).substr(1) : lower;
  return parse_number(text) || parse_hexadecimal(text) || bare == "nan" || bare == "inf";
}

/// Also true for an empty text, with which MuJoCo keeps the default.
bool is_at_most_one_number(std::string_view text) {
  std::size_t at = 0;
  const std::string_view first = next_word(text, at);
  return first.empty() || (is_number(first) && next_word(text, at).empty());
}

bool is_readable(std::string_view name, std::string_view text) {
  if (ranges::contains(kFlags, name)) return is_one_of(text, {"true", "false"});
  if (ranges::contains(kNumbers, name)) return is_at_most_one_number(text);
  if (name == "inertiafromgeom") return is_one_of(text, {"true", "false", "auto"});
  if (name == "angle") return is_one_of(text, {"radian", "degree"});
  if (name == "coordinate") return text == "local";
  return name != "eulerseq" || text.size() == 3;
}

/// What MuJoCo reads of other elements: as many numbers, or one of several words.
struct Setting {
  std::string_view element, name;
  std::size_t numbers = 1;
  std::string_view words = {};  ///< separated by blanks
};
constexpr Setting kSettings[] = {{"option", "timestep"},
                                 {"option", "density"},
                                 {"option", "viscosity"},
                                 {"option", "impratio"},
                                 {"option", "tolerance"},
                                 {"option", "ls_tolerance"},
                                 {"option", "noslip_tolerance"},
                                 {"option", "o_margin"},
                                 {"option", "iterations"},
                                 {"option", "ls_iterations"},
                                 {"option", "noslip_iterations"},
                                 {"option", "gravity", 3},
                                 {"option", "wind", 3},
                                 {"option", "magnetic", 3},
                                 {"option", "integrator", 0, "Euler RK4 implicit implicitfast"},
                                 {"option", "cone", 0, "pyramidal elliptic"},
                                 {"option", "jacobian", 0, "dense sparse auto"},
                                 {"option", "solver", 0, "PGS CG Newton"},
                                 {"size", "njmax"},
                                 {"size", "nconmax"},
                                 {"size", "nstack"},
                                 {"size", "nuserdata"},
                                 {"size", "nkey"}};

bool fits(const Setting& setting, std::string_view text) {
  std::size_t at = 0, count = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    ++count;
    if (setting.words.empty() && !is_number(word)) return false;
  }
  if (setting.words.empty()) return count == setting.numbers || count == 0;
  std::size_t next = 0;
  for (auto word = next_word(setting.words, next); !word.empty();
       word = next_word(setting.words, next)) {
    if (word == text) return true;
  }
  return false;
}

void check_settings(const xml::View mujoco, Findings& findings) {
  for (const xml::View element : mujoco) {
    for (const Setting& setting : kSettings) {
      if (setting.element != element.name()) continue;
      const xml::Attribute* at = element.attribute(setting.name);
      if (at == nullptr || fits(setting, at->value())) continue;
      findings.report(at->span(),
                      "MuJoCo cannot read " + quoted(at->value()) + " as " + quoted(at->name()));
    }
  }
}

/// Limits of joints say nothing of whether they hold, which only `autolimits` makes good.
void check_limits(const LinkedModel& model, const xml::View compiler, Findings& findings) {
  const xml::Attribute* at = compiler.attribute("autolimits");
  if (at == nullptr || at->value() != "false") return;
  const bool has_limit = ranges::any_of(model.robot->joints, [](const urdf::Joint& joint) {
    if (!joint.limit || joint.type == urdf::JointType::fixed) return false;
    const auto& limit = *joint.limit;
    return limit.lower.value_or(0) < limit.upper.value_or(0) || limit.effort.value_or(0) > 0;
  });
  if (has_limit) findings.report(at->span(), "MuJoCo refuses limits of joints with this setting");
}

/// Reports a repeated element that may occur only once.
void check_repeated(const xml::View parent, std::string_view name, Findings& findings) {
  bool is_first = true;
  for (const xml::View child : parent) {
    if (!is_same(child.name(), name)) continue;
    if (!is_first) {
      findings.report(child.name_span(), "a second " + quoted(name) + " in one " +
                                             quoted(parent.name()) + ", which MuJoCo refuses");
      return;
    }
    is_first = false;
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const xml::View root = model.robot->document.view();
  check_repeated(root, "mujoco", findings);
  if (const xml::View mujoco = root.child("mujoco")) {
    check_repeated(mujoco, "compiler", findings);
    check_settings(mujoco, findings);
  }
  const xml::View compiler = mujoco_compiler(model);
  if (!compiler) return;
  check_limits(model, compiler, findings);
  for (const xml::Attribute& at : compiler.attributes()) {
    if (is_readable(at.name(), at.value()) || is_xacro(at.value())) continue;
    findings.report(at.span(),
                    "MuJoCo cannot read " + quoted(at.value()) + " as " + quoted(at.name()));
  }
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1449_mujoco_value{
    .id = "SML1449",
    .name = "mujoco-value",
    .severity = Severity::warning,
    .summary = "A setting for MuJoCo is repeated, or has a value that MuJoCo cannot read.",
    .why = "A flag in the element `compiler` is read only as `true` or `false`.",
    .remedy = "Write one element, with a value that MuJoCo accepts.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
