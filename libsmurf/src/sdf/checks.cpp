// SPDX-License-Identifier: BSD-3-Clause
// The elements that a file has, compared with schema.def.
#include "sdf/checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/quoted.hpp"
#include "sdf/meanings.hpp"
#include "sdf/schema.hpp"

namespace smurf::sdformat {
namespace {

/// How a value is wrong, and what to write.
struct Fault {
  std::string what;  ///< "not a number"
  std::string help;
};

/// A range in words, such as "at least 0" or "from 0 to 1".
std::string shown_range(std::string_view range) {
  const std::size_t comma = range.find(',');
  const std::string least(range.substr(0, comma)), most(range.substr(comma + 1));
  if (most.empty()) return "at least " + least;
  return least.empty() ? "at most " + most : "from " + least + " to " + most;
}

std::optional<Fault> scalar_fault(char type, std::string_view range, std::string_view text) {
  const bool is_whole = type == 'i' || type == 'u';
  const auto number = sdf::read_scalar(type, text);
  if (!number)
    return Fault{is_whole ? "not an integer" : "not a number, or too large or too small for one",
                 is_whole ? "write an integer such as `10`" : "write a number such as `0.5`"};
  if (!sdf::is_within(*number, range))
    return Fault{"outside of what SDF allows", "write a number " + shown_range(range)};
  return std::nullopt;
}

std::optional<Fault> fault_of(ValueKind kind, std::string_view range, std::string_view text) {
  const auto numbers = [&](std::size_t count) -> std::optional<Fault> {
    if (sdf::streamed_numbers(text, count).size() == count) return std::nullopt;
    return Fault{"not " + std::to_string(count) + " numbers",
                 "write " + std::to_string(count) + " numbers, with blanks between them"};
  };
  switch (kind) {
  case ValueKind::boolean:
    if (sdf::read_flag(text)) return std::nullopt;
    return Fault{"not a truth value", "write `true` or `false`"};
  case ValueKind::integer: return scalar_fault('i', range, text);
  case ValueKind::unsigned_integer: return scalar_fault('u', range, text);
  case ValueKind::single: return scalar_fault('f', range, text);
  case ValueKind::number: return scalar_fault('d', range, text);
  case ValueKind::numbers2: return numbers(2);
  case ValueKind::numbers3: return numbers(3);
  case ValueKind::color:
    if (colour_in(text)) return std::nullopt;
    return Fault{"not a colour", "write red, green, blue and alpha from 0 to 1, such as `1 0 0 1`"};
  case ValueKind::text:
    if (!text.empty()) return std::nullopt;
    return Fault{"not a text", "write one"};
  default: return std::nullopt;
  }
}

std::optional<Fault> pose_fault(View element, const Grammar& known) {
  const Fault euler{"not a pose", "write six numbers: x y z roll pitch yaw"};
  if (known.attribute("rotation_format") == nullptr)
    return is_plain_pose(text_of(element)) ? std::nullopt : std::optional(euler);
  if (pose_in(element)) return std::nullopt;
  if (attribute_of(element, "rotation_format") != "quat_xyzw") return euler;
  return Fault{"not a pose", "write x y z and the quaternion x y z w, without `degrees`"};
}

class Checker {
 public:
  Checker(int version, Reporter& reporter) : version_(version), reporter_(reporter) {}

  // The recursion is as deep as the file, whose depth is limited.
  void element(View element, const Grammar& known) {
    attributes(element, known);
    if (known.kind == ValueKind::any) return;
    value(element, known);
    required_children(element, known);
    check_meaning(element, known, reporter_);
    std::map<std::string_view, Span> once;
    for (const View child : element) {
      if (child.name().find(':') != std::string_view::npos) continue;  // for another program
      const Grammar* inner = known.child(child.name());
      if (inner == nullptr) {
        unknown(child, known);
        continue;
      }
      single(child, once);
      without_effect(child);
      this->element(child, *inner);
    }
  }

 private:
  void value(View element, const Grammar& known) {
    const std::string_view text = text_of(element);
    // An empty element is as good as none, unless there must be one.
    if (text.empty() && known.count != '!') return;
    const Span place = text.empty() ? element.name_span() : element.text_span();
    const auto fault = known.kind == ValueKind::pose ? pose_fault(element, known)
                                                     : fault_of(known.kind, known.range, text);
    if (fault) {
      reporter_.refuse(place,
                       text.empty()
                           ? quoted(element.name()) + " is empty, " + fault->what
                           : quoted(text) + " in " + quoted(element.name()) + " is " + fault->what,
                       fault->help);
      return;
    }
    if (text.find(',') == std::string_view::npos) return;
    if (const auto number = sdf::leading_number(text); known.kind == ValueKind::number && number) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, place,
                  "libsdformat reads " + quoted(text) + " as " + format_rounded(*number))
          .help("write a point instead of the comma");
    } else if (known.kind == ValueKind::pose) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, place,
                  "libsdformat reads the numbers of a pose up to a comma")
          .help("write points instead of commas");
    }
  }

  void attributes(View element, const Grammar& known) {
    for (const AttributeRow& row : known.attributes) attribute(element, known, row);
    for (const Attribute& one : element.attributes()) {
      if (known.attribute(one.name()) != nullptr ||
          one.name().find(':') != std::string_view::npos || one.name().starts_with("xmlns"))
        continue;
      if (one.name() == "frame" && known.name == "pose") {
        if (version_ <= 6 || one.value().empty()) continue;
        reporter_
            .report(rules::sml9314_ignored_by_sdformat, one.span(),
                    "since SDF 1.7, `frame` of a pose is `relative_to`, and `frame` has no effect")
            .help("write `relative_to`");
        continue;
      }
      if (element.name() == "include" || element.name() == "model" || element.name() == "sdf")
        continue;  // `merge`, and attributes that only other tools read
      std::vector<std::string_view> names;
      for (const AttributeRow& row : known.attributes) names.push_back(row.name);
      const auto near = reporter_.context().sink.suggest(one.name(), names);
      if (!near) continue;  // attributes of other tools are allowed everywhere
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, one.name_span(),
                  "libsdformat ignores " + quoted(one.name()) + " of " + quoted(element.name()))
          .help("did you mean " + quoted(*near) + "?");
    }
  }

  void attribute(View element, const Grammar& known, const AttributeRow& row) {
    const Attribute* one = element.attribute(row.name);
    if (one == nullptr || one->value().empty()) {
      // That of the file has been looked at.
      if (!row.is_required || known.name == "sdf") return;
      const Span place = one != nullptr ? one->span() : element.name_span();
      reporter_.refuse(place, quoted(element.name()) + " needs " + quoted(row.name), "write it");
      return;
    }
    if (row.name == "name" && version_ >= 8 && known.name != "plugin" &&
        one->value().find("::") != std::string_view::npos) {
      reporter_.refuse(one->value_span(), "since SDF 1.8, a name has no `::`",
                       "nest the element in a model, or write `_`");
      return;
    }
    if (const auto fault = fault_of(row.kind, "", one->value())) {
      reporter_.refuse(one->value_span(),
                       quoted(one->value()) + " in " + quoted(row.name) + " is " + fault->what,
                       fault->help);
    }
  }

  /// libsdformat adds what is missing, unless it is a part of a joint.
  void required_children(View element, const Grammar& known) {
    if (known.name != "joint" || known.kind != ValueKind::none) return;
    for (const Grammar* one : known.children) {
      const bool is_required = one->count == '!' || one->count == '+';
      if (!is_required || element.child(one->name)) continue;
      reporter_.refuse(element.name_span(), "`joint` needs `<" + std::string(one->name) + ">`",
                       one->name == "angle" ? "write it" : "name the link or the frame there");
    }
  }

  void unknown(View child, const Grammar& known) {
    // SML1458 names all of a sensor.
    for (View around = child.parent(); around; around = around.parent()) {
      if (around.name() == "sensor") return;
    }
    std::vector<std::string_view> names;
    for (const Grammar* one : known.children) names.push_back(one->name);
    const auto near = reporter_.context().sink.suggest(child.name(), names);
    if (!near) return;  // elements of plugins and of other versions are allowed everywhere
    reporter_
        .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                "libsdformat ignores " + quoted(child.name()) + " in " +
                    quoted(child.parent().name()))
        .help("did you mean " + quoted(*near) + "?");
  }

  void single(View child, std::map<std::string_view, Span>& once) {
    // Of others, such as sensors, there may be several, whatever their descriptions say.
    constexpr std::string_view kSingle[] = {
        "pose",     "inertial", "mass",     "inertia",  "geometry", "parent", "child",
        "axis",     "axis2",    "xyz",      "limit",    "lower",    "upper",  "effort",
        "velocity", "dynamics", "damping",  "friction", "radius",   "length", "size",
        "scale",    "static",   "material", "diffuse"};
    if (!ranges::contains(kSingle, child.name())) return;
    const auto [first, is_new] = once.emplace(child.name(), child.name_span());
    if (is_new) return;
    reporter_
        .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                "libsdformat reads the first " + quoted(child.name()) + " only")
        .help("delete one of the two")
        .label(first->second, "the first one");
  }

  /// Elements of SDF 1.6 are in files of later versions, too, where nothing tells that they are
  /// gone.
  void without_effect(View child) {
    constexpr int kLast = 6, kFirst = 5;
    if (child.name() == "initial_position" && version_ > kLast) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                  "since SDF 1.7, `initial_position` has no effect")
          .help("let a plugin set the position of the joint, and delete the element");
    }
    if (child.name() != "use_parent_model_frame" || !child.parent()) return;
    const bool is_wanted = sdf::read_flag(text_of(child)).value_or(false);
    if (is_wanted && version_ > kLast) {
      reporter_
          .report(
              rules::sml9314_ignored_by_sdformat, child.name_span(),
              "since SDF 1.7, `use_parent_model_frame` has no effect, so the axis is in the frame "
              "of the joint")
          .help("write `<xyz expressed_in=\"__model__\">`");
    } else if (!is_wanted && version_ < kFirst) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                  "until SDF 1.4, an axis is in the frame of the model, whatever "
                  "`use_parent_model_frame` says")
          .help("raise the version of the file to 1.5 or more");
    }
  }

  int version_;
  Reporter& reporter_;
};

}  // namespace

void check_elements(View root, int version, Reporter& reporter) {
  Checker(version, reporter).element(root, grammar());
}

}  // namespace smurf::sdformat
