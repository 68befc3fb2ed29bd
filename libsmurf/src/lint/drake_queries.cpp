// SPDX-License-Identifier: BSD-3-Clause
#include "lint/drake_queries.hpp"

#include <algorithm>

#include "base/floating.hpp"
#include "base/quoted.hpp"
#include "base/words.hpp"

namespace smurf::drake {
namespace {

/// Reads a number like `>>` of a C++ stream, which stops at the first character that cannot be part
/// of one, and does not read "nan" and "inf".
bool read_number(std::string_view& text, double& value) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\v\f"), text.size()));
  std::string_view digits = text;
  const bool has_plus = digits.starts_with('+');
  if (has_plus) digits.remove_prefix(1);
  const std::size_t first = !has_plus && digits.starts_with('-') ? 1 : 0;
  const char c = first < digits.size() ? digits[first] : '\0';
  if (c != '.' && (c < '0' || c > '9')) return false;
  const auto [end, error] = read_floating(digits, value);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return !text.starts_with('e') && !text.starts_with('E');
}

}  // namespace

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

std::vector<double> read_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (double value = 0; read_number(text, value);) numbers.push_back(value);
  return numbers;
}

Names::Names(const LinkedModel& model) : model_(model) {
  for (const xml::View element : model.robot->document.view()) {
    const std::string_view name = value_of(element, "name");
    if (name.empty() || is_passed_over(element)) continue;
    if (element.name() == "drake:joint") joints_.add(name, element);
    // Drake makes no joint of a floating joint.
    const bool is_joint = element.name() == "joint" && value_of(element, "type") != "floating";
    if (is_joint) joints_.add(name, element);
    if (element.name() == "frame") frames_.add(name, element);
    if (element.name() == "drake:collision_filter_group") groups_.add(name, element);
  }
  for (const std::string_view link : model.link_names.names()) {
    if (link != "world") frames_.add(link, {});
  }
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
