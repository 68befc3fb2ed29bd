// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "ast/companions/srdf_reader.hpp"
#include "base/text/suggest.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3504_srdf_unknown_element_file {
namespace {

constexpr Circumstance kRoot{"root"};

/// The known name that a name was probably meant to be; none for names that other programs read.
std::optional<std::string_view> meant_by(std::string_view name,
                                         const std::vector<std::string_view>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  return only_nearest(name, known);
}

void report(Span place, std::string_view kind, std::string_view name, std::string_view meant,
            Findings& findings) {
  Diagnostic& found =
      findings.report(place, "MoveIt does not know the " + std::string(kind) + " " + quoted(name));
  found.help("did you mean " + quoted(meant) + "?");
  if (kind == "attribute") {
    found.fixes.push_back({Applicability::unsafe, {{place, std::string(meant)}}});
  }
}

/// Whether srdfdom reads the element at another place.
std::string_view other_parent(std::string_view parent, std::string_view name) {
  for (const srdf::ElementSpec& one : srdf::all_element_specs()) {
    if (one.name == name && one.parent != parent && !one.parent.empty()) return one.parent;
  }
  return {};
}

void check_children(xml::View parent, Findings& findings);

void check_element(xml::View parent, xml::View element, Findings& findings) {
  const srdf::ElementSpec* spec = srdf::find_element_spec(parent.name(), element.name());
  if (spec != nullptr) {
    std::vector<std::string_view> known(spec->required.begin(), spec->required.end());
    known.insert(known.end(), spec->optional.begin(), spec->optional.end());
    for (const xml::Attribute& one : element.attributes()) {
      if (const auto meant = meant_by(one.name(), known)) {
        report(one.name_span(), "attribute", one.name(), *meant, findings);
      }
    }
    // The groups in a group are names only.
    if (parent.name() != "group" || element.name() != "group") {
      return check_children(element, findings);
    }
    for (const xml::View child : element) {
      findings
          .report(child.name_span(), "MoveIt does not read " + quoted(child.name()) +
                                         " in a group that is itself in a group")
          .help("move it into the group of that name");
    }
    return;
  }
  if (const std::string_view other = other_parent(parent.name(), element.name()); !other.empty()) {
    findings
        .report(element.name_span(),
                "MoveIt does not read " + quoted(element.name()) + " in " + quoted(parent.name()))
        .help("move it into " + quoted(other));
    return;
  }
  std::vector<std::string_view> known;
  for (const srdf::ElementSpec& one : srdf::all_element_specs()) {
    if (one.parent == parent.name()) known.push_back(one.name);
  }
  if (const auto meant = meant_by(element.name(), known)) {
    report(element.name_span(), "element", element.name(), *meant, findings);
  }
}

void check_children(xml::View parent, Findings& findings) {
  for (const xml::View child : parent) check_element(parent, child, findings);
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    const xml::View root = srdf.document.view();
    if (!root) return;
    if (root.name() == "robot") return check_children(root, findings);
    Diagnostic& found = findings.report(root.name_span(), "an SRDF begins with `robot`, not with " +
                                                              quoted(root.name()));
    found.severity = Severity::error;
    found.when(kRoot).help("write `robot`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::refuses, "refuses the file", "srdfdom 2.0.7 model.cpp initXml, run",
     when(kRoot)},
    {&readers::moveit, Effect::loses, "ignores it without a message", "srdfdom model.cpp"},
};

}  // namespace

extern constinit const Rule sml3504_srdf_unknown_element{
    .id = "SML3504",
    .name = "srdf-unknown-element",
    .severity = Severity::warning,
    .summary = "An element or attribute of an SRDF is misspelt or at a place where it is not read.",
    .remedy = "Correct the name, or move the element.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3504_srdf_unknown_element_file
