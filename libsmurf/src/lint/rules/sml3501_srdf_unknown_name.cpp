// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/ranges.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "lint/companions/srdf_queries.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3501_srdf_unknown_name_file {
namespace {

constexpr Circumstance kVariant{"variant"};

std::string subject_of(xml::View element) {
  const xml::View parent = element.parent();
  const bool is_inner = parent && parent.parent();
  const xml::View named = is_inner ? parent : element;
  const xml::Attribute* name = named.attribute("name");
  const bool is_own = name != nullptr && named.name() != "passive_joint";
  return is_own ? std::string(named.name()) + " " + quoted(name->value())
                : "`" + std::string(named.name()) + "`";
}

/// A pair of links has two different ones.
bool names(xml::View pair, std::string_view link) {
  return ranges::any_of(pair.attributes(),
                        [&](const xml::Attribute& one) { return one.value() == link; });
}

class Checker {
 public:
  Checker(const LinkedModel& model, const Companion& companion, Findings& findings)
      : model_(model), companion_(companion), srdf_(*companion.srdf), findings_(findings) {}

  void check(const Reference& one) {
    if (one.is_definition) return;
    const xml::View element(srdf_.document, xml::ElementId{one.place});
    if (one.kinds == NameKind::group) return check_group(one, element);
    if (one.is_known() && one.kind == one.kinds.first()) return;
    if (one.name.find("${") != std::string_view::npos ||
        one.name.find("$(") != std::string_view::npos) {
      return check_expression(one, element);
    }
    if (companion_.of_variants.contains(one.name)) {
      if (variants_.empty()) first_of_variants_ = one.span;
      variants_.insert(one.name);
      return;
    }
    const bool is_pair = element.name().ends_with("_collisions");
    const auto [known, is_new] = seen_.insert({{is_pair, one.name}, nullptr});
    if (!is_new) {
      if (known->second != nullptr) add_to(*known->second, one);
      return;
    }
    Meanings meanings;
    if (is_pair)
      meanings.is_impossible = [&](std::string_view name) { return names(element, name); };
    Diagnostic* found = check_reference(model_, one.kinds.first(), one.name, one.span,
                                        subject_of(element).c_str(), findings_, meanings);
    if (found == nullptr) return;
    if (is_pair) found->severity = Severity::warning;
    known->second = found;
  }

  void finish() {
    report_variants();
    for (const auto& [found, count] : more_) {
      found->note("the same " + std::string(found == expression_ ? "is true of " : "name is in ") +
                  counted(count, "more place"));
    }
  }

 private:
  /// One finding and one fix for all places of the name; pairs only cost a warning.
  void add_to(Diagnostic& first, const Reference& one) {
    ++more_[&first];
    if (first.fixes.empty()) return;
    const std::string text = first.fixes.front().edits.front().text;
    first.fixes.front().edits.push_back({one.span, text});
  }

  /// Xacro would have evaluated it.
  void check_expression(const Reference& one, xml::View element) {
    if (expression_ != nullptr) {
      ++more_[expression_];
      return;
    }
    expression_ = &findings_.report(one.span, subject_of(element) + " names " + quoted(one.name) +
                                                  ", but MoveIt does not evaluate expressions");
    expression_->help("name the file .srdf.xacro, and make the SRDF with xacro");
  }

  /// The SRDF is for other arguments, which only launch files may know.
  void report_variants() {
    if (variants_.empty()) return;
    const std::string names = listed(all_quoted(variants_));
    Diagnostic& found = findings_.report(
        first_of_variants_, "the SRDF does not fit `" + model_.urdf_path +
                                "`, as it is expanded here: it has no " + shortened(names, 200));
    found.when(kVariant);
    found.severity = Severity::info;
    found.help("set the arguments of the robot under `xacro` in .smurf-lint.yaml");
  }

  void check_group(const Reference& one, xml::View element) {
    if (srdf_.find_group(one.name) != nullptr) return;
    const auto [place, is_new] = groups_.insert({one.name, nullptr});
    if (!is_new) return add_to(*place->second, one);
    std::vector<std::string_view> known;
    for (const srdf::Group& group : srdf_.groups) {
      if (group.name) known.push_back(*group.name);
    }
    Diagnostic& found =
        findings_.report(one.span, subject_of(element) + " names the group " + quoted(one.name) +
                                       ", which this SRDF does not have");
    place->second = &found;
    if (const auto near = findings_.suggest(one.name, known)) {
      found.help("did you mean " + quoted(*near) + "?");
      found.fixes.push_back({Applicability::unsafe, {{one.span, std::string(*near)}}});
    } else if (!known.empty()) {
      found.help("add the group, or write " + choices(known));
    }
  }

  const LinkedModel& model_;
  const Companion& companion_;
  const srdf::Description& srdf_;
  Findings& findings_;
  using Place = std::pair<bool, std::string_view>;  ///< whether it is in a pair of links
  std::map<Place, Diagnostic*> seen_;               ///< the first finding about a name
  std::map<std::string_view, Diagnostic*> groups_;  ///< in the same way
  std::map<Diagnostic*, std::size_t> more_;
  Diagnostic* expression_ = nullptr;
  std::set<std::string_view> variants_;  ///< names that the robot has with other arguments
  Span first_of_variants_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const std::vector<Reference> references = companion_references(model, companions);
  for (const Companion& companion : companions.files) {
    if (!companion.srdf) continue;
    Checker checker(model, companion, findings);
    for (const Reference& one : references) {
      if (one.span.source == companion.srdf->document.source) checker.check(one);
    }
    checker.finish();
  }
}

using enum Effect;
constexpr Fact kFacts[] = {
    {&readers::moveit, takes, "gets the robot as the launch file expands it",
     "moveit2 rdf_loader.cpp", when(kVariant)},
    {&readers::moveit, loses, "ignores the pair, and checks the two links for collisions",
     "srdfdom model.cpp loadCollisionPairs", at("disable_collisions")},
    {&readers::moveit, loses, "ignores the pair", "srdfdom model.cpp loadCollisionPairs",
     at("enable_collisions")},
    {&readers::moveit, breaks, "drops the whole group, with all that names it",
     "srdfdom model.cpp loadGroups", at("group/group")},
    {&readers::moveit, breaks, "drops the member of the group", "srdfdom model.cpp loadGroups",
     at("group")},
    {&readers::moveit, breaks, "drops the joint from the state",
     "srdfdom model.cpp loadGroupStates", at("group_state/joint")},
    {&readers::moveit, breaks, "drops the state", "srdfdom model.cpp loadGroupStates",
     at("group_state")},
    {&readers::moveit, breaks, "drops the end effector", "srdfdom model.cpp loadEndEffectors",
     at("end_effector")},
    {&readers::moveit, breaks, "reports an error and ignores the element", "srdfdom model.cpp"},
};

}  // namespace

extern constinit const Rule sml3501_srdf_unknown_name{
    .id = "SML3501",
    .name = "srdf-unknown-name",
    .severity = Severity::error,
    .summary = "An SRDF names a link, joint or group that does not exist.",
    .remedy = "Correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3501_srdf_unknown_name_file
