// SPDX-License-Identifier: BSD-3-Clause
#include "lint/drake_queries.hpp"

#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf::drake {

std::string_view value_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element ? element.attribute(attribute) : nullptr;
  return found == nullptr ? std::string_view() : found->value();
}

bool is_passed_over(xml::View element) {
  const std::string_view name = element.name();
  if (name == "link" || name == "joint" || name == "drake:joint") {
    return value_of(element, "drake_ignore") == "true";
  }
  return name == "drake:collision_filter_group" && value_of(element, "ignore") == "true";
}

std::vector<xml::View> own_joints(const LinkedModel& model) {
  std::vector<xml::View> joints;
  if (!model.robot) return joints;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() == "drake:joint" && !is_passed_over(element)) joints.push_back(element);
  }
  return joints;
}

std::set<std::string_view> names_in(const std::vector<xml::View>& elements,
                                    std::string_view attribute) {
  std::set<std::string_view> names;
  for (const xml::View element : elements) names.insert(value_of(element, attribute));
  return names;
}

std::set<std::string_view> names_in(const std::vector<xml::View>& elements, std::string_view child,
                                    std::string_view attribute) {
  std::set<std::string_view> names;
  for (const xml::View element : elements) {
    names.insert(value_of(element.child(child), attribute));
  }
  return names;
}

bool is_simple(xml::View transmission) {
  const xml::View type = transmission.child("type");
  const std::string_view text = type ? type.text() : value_of(transmission, "type");
  return text.find("SimpleTransmission") != std::string_view::npos;
}

bool has_empty_part(xml::View element) {
  if (element.name() != "drake:joint") return false;
  const auto is_empty = [](xml::View part, std::string_view name) {
    const xml::Attribute* found = part ? part.attribute(name) : nullptr;
    return found != nullptr && found->value().empty();
  };
  return is_empty(element, "type") || is_empty(element.child("parent"), "link") ||
         is_empty(element.child("child"), "link");
}

Names::Names(const LinkedModel& model) : model_(model) {
  for (const xml::View element : model.robot->document.view()) {
    const std::string_view name = value_of(element, "name");
    if (name.empty()) continue;
    if (is_passed_over(element)) {
      if (element.name() == "link") ignored_.insert(name);
      continue;
    }
    if (element.name() == "drake:joint" && !has_empty_part(element)) joints_.add(name, element);
    // Drake makes no joint of a floating joint.
    const bool is_joint = element.name() == "joint" && value_of(element, "type") != "floating";
    if (is_joint) joints_.add(name, element);
    const bool is_frame = element.name() == "frame" && value_of(element, "link") != "world";
    if (is_frame) frames_.add(name, element);
    if (element.name() == "drake:collision_filter_group") groups_.add(name, element);
  }
  for (const std::string_view link : model.link_names.names()) {
    if (link != "world") frames_.add(link, {});
  }
  find_loops();
}

void Names::find_loops() {
  std::map<std::string_view, std::string_view> above;  // a link that stands for the same tree
  const auto tree_of = [&](std::string_view link) {
    for (auto at = above.find(link); at != above.end(); at = above.find(link)) link = at->second;
    return link;
  };
  for (const xml::View joint : model_.robot->document.view()) {
    if (this->joint(value_of(joint, "name")).id() != joint.id() || has_empty_part(joint)) continue;
    const std::string_view parent = tree_of(value_of(joint.child("parent"), "link"));
    const std::string_view child = tree_of(value_of(joint.child("child"), "link"));
    if (parent == child) {
      loops_.insert(joint.id());
    } else {
      above[child] = parent;
    }
  }
}

xml::View Names::earlier_frame(xml::View frame) const {
  const xml::View first = frames_.find(value_of(frame, "name"));
  return first && first.id() != frame.id() ? first : xml::View();
}

void Names::report_ignored(std::string_view link, Span place, Findings& findings) {
  findings.report(place, "Drake ignores the link " + quoted(link) + ", and does not find it here")
      .help("delete `drake_ignore` at the link, or add it here");
}

void Names::Table::add(std::string_view name, xml::View element) {
  if (elements.emplace(name, element).second) names.push_back(name);
}

xml::View Names::Table::find(std::string_view name) const {
  const auto found = elements.find(name);
  return found == elements.end() ? xml::View() : found->second;
}

bool Names::is_body(std::string_view name) const {
  return name != "world" && model_.link_names.contains(name);
}

bool Names::is_frame(std::string_view name) const {
  if (frames_.elements.contains(name)) return true;
  // Drake creates these frames for joints with an origin.
  for (const std::string_view suffix : {"_parent", "_child"}) {
    if (!name.ends_with(suffix)) continue;
    if (joints_.elements.contains(name.substr(0, name.size() - suffix.size()))) return true;
  }
  return false;
}

void Names::report_unknown(std::string_view kind, std::string_view name, Span place,
                           const std::string& subject, Findings& findings) const {
  const std::string noun(kind);
  Diagnostic& diagnostic = findings.report(
      place, subject + " names the " + noun + " " + quoted(name) + ", which " +
                 (name == "world" ? "is the world in Drake" : "the model does not have"));
  if (name == "world") return;
  diagnostic.caret = "no such " + noun;
  const Table& table = kind == "joint" ? joints_ : kind == "frame" ? frames_ : groups_;
  if (const auto near = findings.suggest(name, table.names)) {
    diagnostic.help("did you mean " + quoted(*near) + "?");
  }
}

}  // namespace smurf::drake
