// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/urdf_numbers.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/drake_checks.hpp"
#include "lint/queries.hpp"
#include "readers/drake_language.hpp"

namespace smurf::rules::sml1450_drake_element_file {
namespace {

using drake::AttributeSpec;
using drake::ElementSpec;
using drake::Occurs;
using drake::Range;
using drake::Value;

/// The table of Drake's language applied to a robot, from the root on.
class Checker {
 public:
  Checker(const drake::Names& names, Findings& findings) : names_(names), findings_(findings) {}

  // The recursion is as deep as the table: no element contains an element of the same name.
  void children(xml::View parent) {
    const auto specs = drake::children_of(parent.name());
    std::uint64_t seen = 0;  // one bit per index of `specs`
    std::vector<xml::View> foreign;
    for (const xml::View child : parent) {
      const auto spec = ranges::find_if(
          specs, [&](const ElementSpec& one) { return is_same(one.name, child.name()); });
      if (spec == specs.end()) {
        if (drake::is_own_name(child.name())) foreign.push_back(child);
        continue;
      }
      const std::uint64_t bit = std::uint64_t{1} << (spec - specs.begin());
      const bool is_repeated = (seen & bit) != 0;
      seen |= bit;
      if (drake::is_passed_over(child)) continue;
      if (is_repeated && spec->occurs != Occurs::any) {
        if (drake::is_own_name(child.name())) unread(child, "Drake reads the first one only");
      } else {
        element(parent, child, *spec);
      }
    }
    for (std::size_t i = 0; i < specs.size(); ++i) {
      const bool is_missing = (seen >> i & 1) == 0 && specs[i].occurs == Occurs::once;
      if (is_missing) missing(parent, specs[i].name, foreign);
    }
    if (parent.name() == "drake:curves") return;  // where Drake refuses unknown elements
    for (const xml::View child : foreign) unknown(parent, child, specs);
  }

 private:
  void element(xml::View parent, xml::View child, const ElementSpec& spec) {
    if (spec.occurs == Occurs::never) return refused(child);
    if (parent.name() == "drake:joint" && !drake::is_read_in(parent, child.name())) {
      unread(child, "Drake does not read it in a joint of this type");
      return;
    }
    if (drake::has_empty_part(child)) {
      unread(child, "Drake leaves out a joint with an empty type or an empty name of a link");
      return;
    }
    // Drake makes actuators of simple transmissions only, and does not read the others.
    if (child.name() == "transmission" && !drake::is_simple(child)) return;
    missing_attributes(child, spec);
    for (const AttributeSpec& attribute : spec.attributes) this->attribute(child, attribute);
    drake::check_meaning(child, names_, findings_);
    children(child);
  }

  Diagnostic& unread(xml::View element, std::string note) {
    Diagnostic& diagnostic =
        findings_.report(element.name_span(), quoted(element.name()) + " has no effect here");
    diagnostic.note(std::move(note));
    diagnostic.when(drake::kUnread);
    return diagnostic;
  }

  void refused(xml::View element) {
    Diagnostic& diagnostic =
        findings_.report(element.name_span(), "Drake refuses " + quoted(element.name()));
    diagnostic.help(element.name() == "drake:soft_hydroelastic"
                        ? "write `drake:compliant_hydroelastic`"
                        : "a texture of a URDF is written `<texture filename=\"...\"/>`");
  }

  /// A transmission whose type is an element also belongs to ros_control: SML1448.
  static bool is_reported_elsewhere(xml::View parent) {
    return parent.name() == "transmission" && parent.child("type");
  }

  /// A misspelling of it is part of this finding, and therefore removed from `foreign`.
  void missing(xml::View parent, std::string_view name, std::vector<xml::View>& foreign) {
    if (is_reported_elsewhere(parent)) return;
    Diagnostic& diagnostic =
        findings_.report(parent.name_span(), quoted(parent.name()) + " has no " + quoted(name));
    const std::string_view known[] = {name};
    const auto slip = ranges::find_if(
        foreign, [&](xml::View child) { return nearest(child.name(), known).has_value(); });
    if (slip == foreign.end()) return;
    diagnostic.label(slip->name_span(), "this one is misspelt");
    foreign.erase(slip);
  }

  void unknown(xml::View parent, xml::View child, std::span<const ElementSpec> specs) {
    std::vector<std::string_view> known;
    for (const ElementSpec& spec : specs) known.push_back(spec.name);
    Diagnostic& diagnostic =
        unread(child, "Drake does not look for it in " + quoted(parent.name()));
    if (const auto near = nearest(child.name(), known)) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
    }
  }

  void attribute(xml::View element, const AttributeSpec& spec) {
    const xml::Attribute* attribute = element.attribute(spec.name);
    if (attribute == nullptr || is_xacro(attribute->value())) return;  // SML1009
    switch (spec.value) {
    case Value::text: return;
    case Value::choice: return choice(element, *attribute);
    case Value::number: return numbers(element, *attribute, 1, spec.range);
    case Value::vector: return numbers(element, *attribute, 3, spec.range);
    default: return name(element, *attribute, spec.value);
    }
  }

  void missing_attributes(xml::View element, const ElementSpec& spec) {
    std::vector<std::string_view> absent;
    for (const AttributeSpec& one : spec.attributes) {
      const bool is_absent = one.is_required && element.attribute(one.name) == nullptr;
      if (is_absent) absent.push_back(one.name);
    }
    if (absent.empty()) return;
    std::string names;
    for (const std::string_view name : absent) {
      names += (names.empty() ? " has no " : " and no ") + quoted(name);
    }
    Diagnostic& diagnostic = findings_.report(element.name_span(), quoted(element.name()) + names);
    for (const xml::Attribute& at : element.attributes()) {
      const bool is_known = ranges::any_of(
          spec.attributes, [&](const AttributeSpec& one) { return one.name == at.name(); });
      if (!is_known && nearest(at.name(), absent)) {
        diagnostic.label(at.name_span(), "this one is misspelt");
      }
    }
  }

  static std::string title(xml::View element, const xml::Attribute& attribute) {
    return "the " + quoted(attribute.name()) + " of " + quoted(element.name());
  }

  void choice(xml::View element, const xml::Attribute& attribute) {
    if (attribute.value() == "true" || attribute.value() == "false") return;
    findings_.report(attribute.value_span(),
                     title(element, attribute) + " must be `true` or `false`");
  }

  void numbers(xml::View element, const xml::Attribute& attribute, std::size_t count, Range range) {
    const std::vector<double> read = read_leading_numbers(attribute.value());
    const std::string subject = title(element, attribute);
    if (read.size() != count) {
      Diagnostic& diagnostic =
          findings_.report(attribute.value_span(),
                           subject + " must be " + (count == 1 ? "one number" : "three numbers"));
      diagnostic.caret = "Drake reads " + std::to_string(read.size());
      return;
    }
    const bool is_positive = range == Range::positive;
    for (const double number : read) {
      if (range == Range::all || number > 0 || (number == 0 && !is_positive)) continue;
      findings_.report(attribute.value_span(),
                       subject + (is_positive ? " must be positive" : " must not be negative"));
      return;
    }
  }

  void name(xml::View element, const xml::Attribute& attribute, Value value) {
    const std::string_view name = attribute.value();
    const std::string subject = quoted(element.name());
    const Span place = attribute.value_span();
    if (value == Value::joint) {
      if (!names_.joint(name)) names_.report_unknown("joint", name, place, subject, findings_);
    } else if (value == Value::frame) {
      if (!names_.is_frame(name)) names_.report_unknown("frame", name, place, subject, findings_);
    } else if (value == Value::group) {
      // Drake ignores an empty name; `::` refers to the groups of another model.
      const bool is_judged = !name.empty() && name.find("::") == std::string_view::npos;
      if (!is_judged || names_.group(name)) return;
      names_.report_unknown("collision filter group", name, place, subject, findings_);
    } else if (value == Value::body && name == "world") {
      names_.report_unknown("link", name, place, subject, findings_);
    } else if (name != "world") {
      if (names_.is_ignored(name)) return names_.report_ignored(name, place, findings_);
      check_reference(names_.model(), NameKind::link, name, place, subject.c_str(), findings_);
    }
  }

  const drake::Names& names_;
  Findings& findings_;
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  Checker(drake::Names(model), findings).children(model.robot->document.view());
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::loses, "does not read it, and loads the file", kRun,
     when(drake::kUnread)},
    {&readers::drake, Effect::crashes, "ends the process", kRun, when(drake::kTooShort)},
    {&readers::drake, Effect::refuses, "refuses the file",
     "Drake detail_urdf_parser.cc:1296-1377; 1.51.1 does not read it",
     at("drake:distance_constraint")},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1450_drake_element{
    .id = "SML1450",
    .name = "drake-element",
    .severity = Severity::error,
    .summary =
        "An element that only Drake reads lacks a part, has a wrong value, or names an unknown "
        "thing.",
    .remedy = "Write the element as the page \"Parsing Models\" of Drake's documentation says.",
    .sources = "The tests of Drake's own parser.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1450_drake_element_file
