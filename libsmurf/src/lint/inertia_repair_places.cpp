// SPDX-License-Identifier: BSD-3-Clause
// The repairs of inertias at the places where they were written, in URDF and in xacro files.
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "ast/urdf_attributes.hpp"
#include "base/text/counted.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "lint/inertia_repair.hpp"
#include "lint/queries.hpp"

namespace smurf {
namespace {

/// Bytes of a file. A file that several robots read is several sources.
struct Literal {
  std::string_view path;
  std::uint32_t begin = 0, end = 0;
  friend bool operator==(const Literal&, const Literal&) = default;
  friend bool operator<(const Literal& a, const Literal& b) {  // texts have no <=> in libc++ 14
    return std::tie(a.path, a.begin, a.end) < std::tie(b.path, b.begin, b.end);
  }
};

/// A new value of a literal, for one part of a robot.
struct Change {
  Literal literal;
  Edit edit;                   ///< in the file
  Edit made;                   ///< in the robot that xacro makes; the same without xacro
  std::string_view attribute;  ///< "ixx"
};

struct Repair {
  Diagnostic finding;
  std::vector<Change> changes;
  std::string refusal;  ///< "": it can be written
  Span blamed;          ///< the expression or literal to change by hand
};

/// The element after another one that ends at `at`: in a line of its own, if the other is.
std::string in_layout(std::string_view text, std::size_t at, const std::string& element) {
  const std::size_t line = text.substr(0, at).rfind('\n');
  const std::string_view before =
      line == std::string_view::npos ? text.substr(0, at) : text.substr(line + 1, at - line - 1);
  const std::size_t indent = before.find_first_not_of(" \t");
  const bool is_alone = line != std::string_view::npos && indent != std::string_view::npos &&
                        before.substr(indent).starts_with("<mass");
  if (!is_alone) return element;
  const bool has_return = line > 0 && text[line - 1] == '\r';
  return (has_return ? "\r\n" : "\n") + std::string(before.substr(0, indent)) + element;
}

/// The attribute of an inertial that has these bytes.
std::string_view attribute_at(const urdf::Robot& robot, Span span) {
  for (const urdf::Link& link : robot.links) {
    if (!link.inertial || span.begin < link.span.begin || span.end > link.span.end) continue;
    std::string_view found;
    const auto compare = [&](const urdf::AttributeSpec& spec, const auto& field) {
      if (field.span == span) found = spec.member_name();
    };
    urdf::for_each_field(urdf::kMass, *link.inertial, compare);
    urdf::for_each_field(urdf::kInertia, *link.inertial, compare);
    if (!found.empty()) return found;
  }
  return "inertia";
}

std::string first_line(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string line(text.substr(0, std::min(text.find('\n'), kLongest)));
  return line.size() < text.size() ? line + "..." : line;
}

class RepairPlaces {
 public:
  RepairPlaces(const SourceMap& sources, const xacro::Expansions& expansions,
               const std::function<bool(const std::string&)>& may_change)
      : sources_(sources), expansions_(expansions), may_change_(may_change) {}

  void add(const LinkedModel& model, const InertiaSource& source) {
    for (Diagnostic& finding : repair_inertias(model, source)) {
      Repair repair;
      for (Edit& edit : finding.fixes.front().edits) {
        if (edit.span.empty()) {
          edit.text = in_layout(sources_.text(edit.span.source), edit.span.begin, edit.text);
        }
        add_change(edit, model.robot ? attribute_at(*model.robot, edit.span) : "inertia", repair);
      }
      finding.span = origin_of(finding.span).span;
      repair.finding = std::move(finding);
      repairs_.push_back(std::move(repair));
    }
  }

  InertiaRepairs take() {
    find_other_users();
    while (refuse_next()) {
    }
    InertiaRepairs result;
    std::map<SourceId, std::vector<Edit>> made;
    for (Repair& repair : repairs_) {
      if (!repair.refusal.empty()) continue;
      for (const Change& change : repair.changes) {
        if (expansions_.contains(change.made.span.source)) {
          made[change.made.span.source].push_back(change.made);
        }
      }
    }
    for (auto& [source, edits] : made) {
      std::sort(edits.begin(), edits.end(),
                [](const Edit& a, const Edit& b) { return a.span.begin < b.span.begin; });
      result.expanded[sources_.path(expansions_.at(source).root)] =
          apply_edits(sources_.text(source), edits);
    }
    std::stable_sort(repairs_.begin(), repairs_.end(),
                     [&](const Repair& a, const Repair& b) { return place_of(a) < place_of(b); });
    for (Repair& repair : repairs_) {
      put(std::move(repair), repair.refusal.empty() ? result.repairs : result.refused);
    }
    return result;
  }

 private:
  std::pair<std::string_view, std::uint32_t> place_of(const Repair& repair) const {
    return {sources_.path(repair.finding.span.source), repair.finding.span.begin};
  }

  xacro::Origin origin_of(Span span) const {
    const auto expansion = expansions_.find(span.source);
    if (expansion != expansions_.end()) return expansion->second.origin_of(span);
    return {span, true, xacro::kNoFrame, {}};
  }

  /// A literal is changed in one source, however many have it.
  Span first_of(const Literal& literal, SourceId source) {
    return {files_.try_emplace(literal.path, source).first->second, literal.begin, literal.end};
  }

  void add_change(const Edit& edit, std::string_view attribute, Repair& repair) {
    const xacro::Origin origin = origin_of(edit.span);
    if (edit.span.empty() && expansions_.contains(edit.span.source)) {
      if (!repair.refusal.empty()) return;
      repair.blamed = origin.span;
      repair.refusal = "not written, because xacro makes this inertial; write " +
                       quoted(trimmed(edit.text)) + " into it";
      return;
    }
    if (!origin.is_exact) {
      if (!repair.refusal.empty()) return;
      repair.blamed = origin.span;
      repair.refusal = "not written, because " + quoted(attribute) + " is computed; change " +
                       quoted(first_line(sources_.text(origin.span))) + " so that it gives " +
                       edit.text;
      return;
    }
    const Span span = origin.span;
    if (!may_change_(sources_.path(span.source))) {
      repair.blamed = span;
      repair.refusal = "not written, because the file is outside of the project; override " +
                       quoted(attribute) + ", or name the file itself to change it";
    }
    const Literal literal{sources_.path(span.source), span.begin, span.end};
    repair.changes.push_back(
        {literal, {first_of(literal, span.source), edit.text}, edit, attribute});
    wanted_[literal].insert(edit.text);
    changed_.emplace(std::pair(edit.span.source, edit.span.begin), literal);
  }

  /// The changed literal that shares bytes with a span, or null.
  const Literal* literal_at(Span span) const {
    if (span.empty()) return nullptr;
    const std::string_view path = sources_.path(span.source);
    auto after = wanted_.lower_bound(Literal{path, span.end, 0});
    if (after == wanted_.begin()) return nullptr;
    const Literal& before = std::prev(after)->first;
    return before.path == path && before.end > span.begin ? &before : nullptr;
  }

  bool is_changed(SourceId source, const xacro::Leaf& leaf, const Literal& literal) const {
    const auto change = changed_.lower_bound({source, leaf.begin});
    return change != changed_.end() && change->first.first == source &&
           change->first.second < leaf.end && change->second == literal;
  }

  /// Parts of robots that come from a literal and do not get another value.
  void find_other_users() {
    for (const auto& [source, expansion] : expansions_) {
      for (const xacro::Leaf& leaf : expansion.leaves) {
        const Literal* literal = leaf.is_exact ? literal_at(leaf.origin) : nullptr;
        if (literal != nullptr && !is_changed(source, leaf, *literal)) kept_.insert(*literal);
        for (std::uint32_t i = 0; i < leaf.inputs; ++i) {
          const Literal* input = literal_at(expansion.inputs[leaf.first_input + i].place);
          if (input != nullptr) kept_.insert(*input);
        }
      }
    }
  }

  /// Refuses a repair that would change another part; the others that share its literals are then
  /// judged again. Returns whether there was one.
  bool refuse_next() {
    bool is_any = false;
    for (Repair& repair : repairs_) {
      const auto is_shared = [&](const Change& change) {
        return kept_.contains(change.literal) || wanted_.at(change.literal).size() > 1;
      };
      const auto shared = std::find_if(repair.changes.begin(), repair.changes.end(), is_shared);
      if (repair.refusal.empty() && shared != repair.changes.end()) {
        repair.blamed = shared->edit.span;
        repair.refusal = "not written, because other parts of the robots use the same number; "
                         "give " +
                         quoted(shared->attribute) + " of this link its own number, " +
                         shared->edit.text;
      }
      if (repair.refusal.empty()) continue;
      for (const Change& change : repair.changes) is_any |= kept_.insert(change.literal).second;
    }
    return is_any;
  }

  /// Adds a repair, unless the same is done for another link of the same macro.
  void put(Repair&& repair, std::vector<Diagnostic>& list) {
    const Span place = repair.finding.span;
    if (!done_.emplace(sources_.path(place.source), place.begin, place.end).second) return;
    Diagnostic& finding = repair.finding;
    finding.fixes.clear();
    if (repair.refusal.empty()) {
      Fix fix{Applicability::unsafe, {}};
      for (Change& change : repair.changes) {
        if (written_.insert(change.literal).second) fix.edits.push_back(std::move(change.edit));
      }
      if (fix.edits.empty()) return;
      finding.fixes.push_back(std::move(fix));
    } else {
      finding.notes.push_back(repair.refusal);
      finding.labels = {{repair.blamed, "change this"}};
    }
    list.push_back(std::move(finding));
  }

  const SourceMap& sources_;
  const xacro::Expansions& expansions_;
  const std::function<bool(const std::string&)>& may_change_;
  std::vector<Repair> repairs_;
  std::map<std::string_view, SourceId> files_;                     ///< the source that is changed
  std::map<Literal, std::set<std::string>> wanted_;                ///< new values
  std::map<std::pair<SourceId, std::uint32_t>, Literal> changed_;  ///< by place in the robot
  std::set<Literal> kept_;  ///< literals with a user that gets no new value
  std::set<Literal> written_;
  std::set<std::tuple<std::string_view, std::uint32_t, std::uint32_t>> done_;
};

}  // namespace

InertiaRepairs repair_inertias(std::span<const LinkedModel* const> models, const SourceMap& sources,
                               const xacro::Expansions& expansions, const InertiaSource& source,
                               const std::function<bool(const std::string&)>& may_change) {
  RepairPlaces places(sources, expansions, may_change);
  for (const LinkedModel* model : models) places.add(*model, source);
  return places.take();
}

}  // namespace smurf
