// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1459_plugin_unknown_name_file {
namespace {

/// What the text of an element names, by the end of its own name: `leftJoint`, `body_name`.
NameKinds kinds_of(std::string_view element) {
  std::string word = path::to_lower(element);
  std::erase(word, '_');
  if (word.ends_with("name")) word.erase(word.size() - 4);
  if (word.ends_with("joint")) return NameKind::joint;
  if (word.ends_with("link") || word.ends_with("body") || word == "robotbaseframe") {
    return NameKind::link;
  }
  return {};
}

/// The words of an element's name before the kind of thing that it names: `emitter` of
/// `emitter_link_name`; none if it ends in none of the kinds.
std::optional<std::string> owner_of(std::string_view element,
                                    std::initializer_list<std::string_view> kinds) {
  std::string word = path::to_lower(element);
  std::erase(word, '_');
  if (word.ends_with("name")) word.erase(word.size() - 4);
  for (const std::string_view kind : kinds) {
    if (word.ends_with(kind)) return word.substr(0, word.size() - kind.size());
  }
  return std::nullopt;
}

/// Whether a sibling says that the element names a part of another model: `emitter_robot_name`
/// beside `emitter_link_name`, `child_model` beside `child_link`.
bool is_of_another_model(xml::View element, std::string_view own_model) {
  const auto owner = owner_of(element.name(), {"joint", "link", "body"});
  if (!owner) return false;
  for (const xml::View sibling : element.parent()) {
    const auto named = owner_of(sibling.name(), {"robot", "model"});
    if (!named || trimmed(sibling.text()) == own_model) continue;
    if (*named == *owner || named->empty() || owner->empty()) return true;
  }
  return false;
}

/// Whether a text can be a name at all.
bool is_name(std::string_view text) {
  if (text.empty() || text == "true" || text == "false" || text == "world") return false;
  if (text.find_first_of(" \t\r\n,;$/") != std::string_view::npos) return false;
  return text.find_first_not_of("0123456789.+-eE") != std::string_view::npos;
}

class Check {
 public:
  Check(const LinkedModel& model, Findings& findings) : model_(model), findings_(findings) {}

  // The recursion is as deep as the file, whose depth is limited.
  void find_plugins(xml::View element) {
    for (const xml::View child : element) {
      if (child.name() == "plugin") {
        check_texts(child);
      } else {
        find_plugins(child);
      }
    }
  }

 private:
  void check_texts(xml::View element) {
    for (const xml::View child : element) {
      if (child.begin() != child.end()) {
        check_texts(child);
        continue;
      }
      const NameKinds kinds = kinds_of(child.name());
      if (!kinds.empty()) check_name(child, kinds == NameKind::joint);
    }
  }

  void check_name(xml::View element, bool is_joint) {
    const std::string_view text = trimmed(element.text());
    std::string_view name = text;
    if (!is_name(name)) return;
    if (is_of_another_model(element, model_.robot->name.value_or(""))) return;
    if (name.find("::") != std::string_view::npos) {
      name = name.substr(name.rfind(':') + 1);  // of a model
    }
    if (model_.link_names.contains(name) || model_.joint_names.contains(name)) return;
    if (is_added(name)) return;
    const Span whole = element.text_span();
    const bool is_verbatim = whole.end - whole.begin == text.size();  // no entities
    const auto offset = static_cast<std::uint32_t>(name.data() - text.data());
    const auto size = static_cast<std::uint32_t>(name.size());
    const Span place =
        is_verbatim ? Span{whole.source, whole.begin + offset, whole.begin + offset + size} : whole;
    Diagnostic& diagnostic = findings_.report(
        place, "the plugin names the " + std::string(is_joint ? "joint " : "link ") + quoted(name) +
                   ", which the robot does not have");
    auto near =
        findings_.suggest(name, names(model_, is_joint ? NameKind::joint : NameKind::link).names());
    if (!near) return;
    diagnostic.help("did you mean " + quoted(*near) + "?");
    if (is_verbatim) {
      diagnostic.fixes.push_back({Applicability::unsafe, {{place, escape_xml(*near)}}});
    }
  }

  /// Whether some <gazebo> adds a link or joint of this name.
  bool is_added(std::string_view name) {
    if (!has_added_) {
      has_added_ = true;
      for (const xml::ElementId id : model_.robot->extensions) {
        add_names(xml::View(model_.robot->document, id));
      }
    }
    return added_.contains(name);
  }
  void add_names(xml::View element) {
    for (const xml::View child : element) {
      const xml::Attribute* name = child.attribute("name");
      if (name != nullptr && child.name() != "plugin") added_.insert(name->value());
      add_names(child);
    }
  }

  const LinkedModel& model_;
  Findings& findings_;
  bool has_added_ = false;
  std::set<std::string_view> added_;  ///< names in the elements <gazebo>
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  Check check(model, findings);
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() == "gazebo") check.find_plugins(gazebo);
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "loads the plugin, which finds no such part and stops",
     "gazebo_ros_pkgs gazebo_ros_diff_drive.cpp, read; gazebo_ros_pkgs issue 609"},
};

}  // namespace

extern constinit const Rule sml1459_plugin_unknown_name{
    .id = "SML1459",
    .name = "plugin-unknown-name",
    .severity = Severity::warning,
    .summary = "A plugin for Gazebo names a joint or link that the robot does not have.",
    .why = "Plugins of old versions end the simulator.",
    .remedy = "Correct the name.",
    .sources =
        "gazebo_ros_pkgs issue 609. A guess: the name of the element ends in `joint`, `link` or `body`, with or without `Name`.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml1459_plugin_unknown_name_file
