// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ast/urdf_numbers.hpp"
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1449_mujoco_value_file {
namespace {

/// MuJoCo ignores it in a URDF.
constexpr Circumstance kUnread{"unread"};

/// The attributes of `compiler` that MuJoCo reads; it ignores others.
constexpr std::string_view kFlags[] = {"autolimits",    "balanceinertia", "strippath",
                                       "discardvisual", "fusestatic",     "usethread",
                                       "fitaabb",       "saveinertial",   "alignfree"};
constexpr std::string_view kNumbers[] = {"boundmass", "boundinertia", "settotalmass"};

bool is_number(std::string_view text) {
  const std::string lower = path::to_lower(text);
  const std::string_view bare =
      lower.starts_with('-') || lower.starts_with('+') ? std::string_view(lower).substr(1) : lower;
  if (const std::optional<double> value = parse_number(text)) {
    return *value == 0 || std::fabs(*value) >= std::numeric_limits<double>::min();
  }
  return parse_hexadecimal(text) || is_one_of(bare, {"nan", "inf", "infinity"});
}

/// Also true for an empty text, with which MuJoCo keeps the default.
bool is_at_most_one_number(std::string_view text) {
  std::size_t at = 0;
  const std::string_view first = next_word(text, at);
  return first.empty() || (is_number(first) && next_word(text, at).empty());
}

/// Kinds of numbers that MuJoCo reads from a setting.
enum class Kind : std::uint8_t { words, reals, integers };

/// A setting in another element: as many numbers, or one of several words.
struct Setting {
  std::string_view element, name;
  Kind kind = Kind::reals;
  std::size_t most = 1;         ///< numbers
  std::string_view words = {};  ///< separated by blanks
  int least = std::numeric_limits<int>::min(), largest = std::numeric_limits<int>::max();
};

constexpr std::string_view kOnOff = "enable disable";
constexpr Setting kSettings[] = {
    {"option", "timestep"},
    {"option", "density"},
    {"option", "viscosity"},
    {"option", "impratio"},
    {"option", "tolerance"},
    {"option", "ls_tolerance"},
    {"option", "noslip_tolerance"},
    {"option", "ccd_tolerance"},
    {"option", "sleep_tolerance"},
    {"option", "o_margin"},
    {"option", "iterations", Kind::integers},
    {"option", "ls_iterations", Kind::integers},
    {"option", "noslip_iterations", Kind::integers},
    {"option", "ccd_iterations", Kind::integers},
    {"option", "sdf_iterations", Kind::integers},
    {"option", "sdf_initpoints", Kind::integers},
    {"option", "actuatorgroupdisable", Kind::integers, 31, {}, 0, 30},
    {"option", "gravity", Kind::reals, 3},
    {"option", "wind", Kind::reals, 3},
    {"option", "magnetic", Kind::reals, 3},
    {"option", "o_solref", Kind::reals, 2},
    {"option", "o_solimp", Kind::reals, 5},
    {"option", "o_friction", Kind::reals, 5},
    {"option", "integrator", Kind::words, 0, "Euler RK4 implicit implicitfast"},
    {"option", "cone", Kind::words, 0, "pyramidal elliptic"},
    {"option", "jacobian", Kind::words, 0, "dense sparse auto"},
    {"option", "solver", Kind::words, 0, "PGS CG Newton"},
    {"size", "nkey", Kind::integers},
    {"size", "nuserdata", Kind::integers, 1, {}, 0},
    {"size", "njmax", Kind::integers, 1, {}, -1},
    {"size", "nconmax", Kind::integers, 1, {}, -1},
    {"size", "nstack", Kind::integers, 1, {}, -1},
    {"size", "nuser_body", Kind::integers, 1, {}, -1},
    {"size", "nuser_jnt", Kind::integers, 1, {}, -1},
    {"size", "nuser_geom", Kind::integers, 1, {}, -1},
    {"size", "nuser_site", Kind::integers, 1, {}, -1},
    {"size", "nuser_cam", Kind::integers, 1, {}, -1},
    {"size", "nuser_tendon", Kind::integers, 1, {}, -1},
    {"size", "nuser_actuator", Kind::integers, 1, {}, -1},
    {"size", "nuser_sensor", Kind::integers, 1, {}, -1}};

bool is_integer(std::string_view text, const Setting& setting) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::optional<std::int64_t> value = parse_integer(text);
  return value && setting.least <= *value && *value <= setting.largest;
}

bool is_a_word_of(std::string_view words, std::string_view text) {
  std::size_t at = 0;
  for (auto word = next_word(words, at); !word.empty(); word = next_word(words, at)) {
    if (word == text) return true;
  }
  return false;
}

/// The solver parameters `o_...` and lists of groups may have fewer numbers.
bool may_be_shorter(const Setting& setting) {
  return setting.name == "actuatorgroupdisable" || setting.name.starts_with("o_");
}

bool fits(const Setting& setting, std::string_view text) {
  if (setting.kind == Kind::words) return is_a_word_of(setting.words, text);
  std::size_t at = 0, count = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    ++count;
    const bool is_read = setting.kind == Kind::reals ? is_number(word) : is_integer(word, setting);
    if (!is_read) return false;
  }
  if (count == 0) return true;  // an empty text keeps the default
  return count == setting.most || (count < setting.most && may_be_shorter(setting));
}

bool is_readable(std::string_view name, std::string_view text) {
  if (ranges::contains(kFlags, name)) return is_one_of(text, {"true", "false"});
  if (ranges::contains(kNumbers, name)) return is_at_most_one_number(text);
  if (name == "inertiafromgeom") return is_one_of(text, {"true", "false", "auto"});
  if (name == "angle") return is_one_of(text, {"radian", "degree"});
  if (name == "coordinate") return text == "local";
  if (name == "inertiagrouprange") return fits({"compiler", name, Kind::integers, 2}, text);
  return name != "eulerseq" || text.size() == 3;
}

void report_unreadable(const xml::Attribute& at, Findings& findings) {
  findings.report(at.span(),
                  "MuJoCo cannot read " + quoted(at.value()) + " as " + quoted(at.name()));
}

/// Flags of `option`; MuJoCo ignores unknown names.
constexpr std::string_view kOptionFlags[] = {
    "constraint", "equality",    "frictionloss", "limit",        "contact",   "spring",   "damper",
    "gravity",    "clampctrl",   "warmstart",    "filterparent", "actuation", "refsafe",  "sensor",
    "midphase",   "eulerdamp",   "autoreset",    "nativeccd",    "island",    "override", "energy",
    "fwdinv",     "invdiscrete", "multiccd",     "sleep"};

void check_flags(const xml::View option, Findings& findings) {
  const xml::View flag = option.child("flag");
  if (!flag) return;
  for (const xml::Attribute& at : flag.attributes()) {
    const bool is_flag = ranges::contains(kOptionFlags, at.name());
    if (is_flag && !is_a_word_of(kOnOff, at.value())) report_unreadable(at, findings);
  }
}

/// A whole number of bytes with an optional suffix; "-1" stands for the default.
bool is_size_of_memory(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view suffix = text.substr(digits);
  constexpr std::string_view kSuffixes = "kKmMgGtTpPeE";
  return digits > 0 && (suffix.empty() ||
                        (suffix.size() == 1 && kSuffixes.find(suffix) != std::string_view::npos));
}

/// Whether there is enough memory depends on the machine.
void check_memory(const xml::View size, Findings& findings) {
  const xml::Attribute* at = size.attribute("memory");
  if (at == nullptr) return;
  const std::string_view text = trimmed(at->value());
  if (text == "-1") return;
  if (!is_size_of_memory(text)) return report_unreadable(*at, findings);
  Diagnostic& diagnostic =
      findings.report(at->span(), "the memory that MuJoCo reserves may be too small for the model, "
                                  "or too large for the machine");
  diagnostic.severity = Severity::info;
  diagnostic.when(kUncertain);
}

/// Attributes that MuJoCo has, or had, beside those above.
constexpr std::string_view kOthers[] = {
    "inertiafromgeom", "angle",       "coordinate", "inertiagrouprange", "eulerseq",
    "meshdir",         "texturedir",  "assetdir",   "convexhull",        "exactmeshinertia",
    "memory",          "apirate",     "collision",  "mpr_iterations",    "mpr_tolerance",
    "enableflags",     "disableflags"};

std::vector<std::string_view> attributes_of(std::string_view element) {
  std::vector<std::string_view> names(std::begin(kOthers), std::end(kOthers));
  if (element == "compiler") {
    names.insert(names.end(), std::begin(kFlags), std::end(kFlags));
    names.insert(names.end(), std::begin(kNumbers), std::end(kNumbers));
  }
  for (const Setting& setting : kSettings) {
    if (setting.element == element) names.push_back(setting.name);
  }
  if (element == "flag") names.assign(std::begin(kOptionFlags), std::end(kOptionFlags));
  return names;
}

void check_names(const xml::View element, Findings& findings) {
  for (const xml::Attribute& at : element.attributes()) {
    const auto meant = nearest(at.name(), attributes_of(element.name()));
    if (!meant) continue;
    findings
        .report(at.name_span(), quoted(element.name()) + " has no attribute " + quoted(at.name()))
        .when(kUnread)
        .help("did you mean " + quoted(*meant) + "?");
  }
}

/// Reports what MuJoCo does not look at: one finding for each kind of element.
void check_unread(const xml::View mujoco, Findings& findings) {
  std::set<std::string_view> seen;
  const auto report = [&](const xml::View element, std::string message) {
    if (!seen.insert(element.name()).second) return;
    findings.report(element.name_span(), std::move(message))
        .when(kUnread)
        .help("write it in an MJCF, such as `smurfs-flatten --format mjcf` makes");
  };
  for (const xml::View element : mujoco) {
    const std::string_view name = element.name();
    if (!is_one_of(name, {"compiler", "option", "size"})) {
      report(element, "MuJoCo reads no " + quoted(name) + " from a URDF");
      continue;
    }
    for (const xml::View child : element) {
      if (name == "option" && child.name() == "flag") {
        check_names(child, findings);
        continue;
      }
      report(child,
             "MuJoCo reads no " + quoted(child.name()) + " in " + quoted(name) + " of a URDF");
    }
    check_names(element, findings);
  }
}

void check_settings(const xml::View mujoco, Findings& findings) {
  for (const xml::View element : mujoco) {
    for (const Setting& setting : kSettings) {
      if (setting.element != element.name()) continue;
      const xml::Attribute* at = element.attribute(setting.name);
      if (at != nullptr && !fits(setting, at->value())) report_unreadable(*at, findings);
    }
    if (element.name() == "option") check_flags(element, findings);
    if (element.name() == "size") check_memory(element, findings);
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
    for (const std::string_view name : {"compiler", "option", "size"}) {
      check_repeated(mujoco, name, findings);
    }
    if (const xml::View option = mujoco.child("option")) check_repeated(option, "flag", findings);
    check_settings(mujoco, findings);
    check_unread(mujoco, findings);
  }
  const xml::View compiler = mujoco_compiler(model);
  if (!compiler) return;
  check_limits(model, compiler, findings);
  for (const xml::Attribute& at : compiler.attributes()) {
    if (is_readable(at.name(), at.value()) || is_xacro(at.value())) continue;
    report_unreadable(at, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::loses,
     "reads only `compiler`, `size` and `option` of the element `mujoco`", kRun, when(kUnread)},
    {&readers::mujoco, Effect::refuses,
     "reserves as much memory; its WebAssembly build ends the process", kRun, when(kUncertain)},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1449_mujoco_value{
    .id = "SML1449",
    .name = "mujoco-value",
    .severity = Severity::warning,
    .summary =
        "A setting for MuJoCo is repeated, is not read from a URDF, or has a value that MuJoCo cannot read.",
    .why = "A flag in the element `compiler` is read only as `true` or `false`.",
    .remedy = "Write one element, with a value that MuJoCo accepts.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1449_mujoco_value_file
