// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/robot_facts.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

class RobotFacts {
 public:
  RobotFacts(const LinkedModel& model, const LoadContext& context, Surroundings& found)
      : model_(model), context_(context), found_(found) {}

  /// What the files of the robot say by themselves.
  void read_robot() {
    const xacro::Expansion* expansion = nullptr;
    for (const auto& [source, one] : *context_.expansions) {
      const bool is_own =
          model_.robot ? source == model_.robot->document.source
                       : context_.sources.path(one.root) == path::normalize(model_.urdf_path);
      if (is_own) expansion = &one;
    }
    if (expansion != nullptr) {
      for (const xml::Document& one : expansion->documents) read_document(one);
    } else if (model_.robot) {
      read_document(model_.robot->document);
    } else {
      read_source_text(model_.urdf_path);
    }
    if (model_.robot) read_comments(expansion);
  }

 private:
  /// A xacro that could not be expanded, and what it includes, each file once.
  void read_source_text(const std::string& path) {
    constexpr std::size_t kMostFiles = 64;
    if (!read_.insert(path::normalize(path)).second) return;
    const FileContent content = context_.files.read(path, context_.limits.file_bytes);
    if (content.status != ReadStatus::ok || read_.size() > kMostFiles) {
      found_.has_all_arguments = false;
      return;
    }
    note_uses(content.text);
    for_each_tag(content.text, "<xacro:include",
                 [&](std::string_view tag) { read_source_text(included_file(tag, path)); });
    for_each_tag(content.text, "<xacro:arg", [&](std::string_view tag) {
      const std::size_t name = tag.find("name=");
      if (name == std::string_view::npos || name + 6 >= tag.size()) return;
      const std::size_t end = tag.find(tag[name + 5], name + 6);
      found_.arguments.push_back({std::string(tag.substr(name + 6, end - name - 6)),
                                  tag.find("default=") != std::string_view::npos});
    });
  }

  /// From the beginning of each such tag to its ">".
  static void for_each_tag(std::string_view text, std::string_view begin,
                           const std::function<void(std::string_view)>& take) {
    for (std::size_t at = text.find(begin); at != std::string_view::npos;
         at = text.find(begin, at + 1)) {
      const std::size_t end = text.find('>', at);
      if (end == std::string_view::npos) return;  // no tag follows
      take(text.substr(at, end - at));
    }
  }

  /// The file that an include names; "" if that is not known without expanding.
  std::string included_file(std::string_view tag, const std::string& from) const {
    const std::size_t begin = tag.find_first_of("\"'");
    const std::size_t end =
        begin == std::string_view::npos ? begin : tag.find(tag[begin], begin + 1);
    if (end == std::string_view::npos) return {};
    std::string name(tag.substr(begin + 1, end - begin - 1));
    constexpr std::string_view kFind = "$(find ";
    if (name.starts_with(kFind)) {
      const std::size_t close = name.find(')');
      const std::string package(trimmed(name.substr(kFind.size(), close - kFind.size())));
      const auto known =
          std::find_if(found_.packages.begin(), found_.packages.end(),
                       [&](const SurroundingPackage& one) { return one.name == package; });
      if (close == std::string::npos || known == found_.packages.end()) return {};
      name = known->folder + name.substr(close + 1);
    }
    if (name.find_first_of("${}*") != std::string::npos) return {};
    return path::join(path::parent(from), name);
  }

  void read_document(const xml::Document& document) {
    for (const xml::Element& one : document.elements) {
      const xml::View element(
          document, xml::ElementId{static_cast<std::uint32_t>(&one - document.elements.data())});
      if (element.name() == "xacro:arg" && element.attribute("name") != nullptr) {
        found_.arguments.push_back({std::string(element.attribute("name")->value()),
                                    element.attribute("default") != nullptr,
                                    element.attribute("name")->value_span()});
      }
      for (const xml::Attribute& attribute : element.attributes()) {
        note_uses(attribute.value());
        note_calls(attribute.value(), attribute.value_span());
      }
    }
    for (const xml::Element& one : document.elements) {
      const xml::View element(
          document, xml::ElementId{static_cast<std::uint32_t>(&one - document.elements.data())});
      note_uses(element.text());
      found_.may_choose_hardware =
          found_.may_choose_hardware ||
          element.text().find("GazeboSimSystem") != std::string_view::npos ||
          element.text().find("IgnitionSystem") != std::string_view::npos;
    }
  }

  /// Arguments that are used: one that is not declared has no default.
  void note_uses(std::string_view text) {
    constexpr std::string_view kUse = "$(arg ";
    for (std::size_t at = text.find(kUse); at != std::string_view::npos;
         at = text.find(kUse, at + 1)) {
      const std::string_view rest = text.substr(at + kUse.size());
      const std::string name(trimmed(rest.substr(0, rest.find(')'))));
      if (!name.empty()) found_.arguments.push_back({name, false});
    }
  }

  /// The comments of the robot, as xacro prints them, and those before its root.
  void read_comments(const xacro::Expansion* expansion) {
    const auto look_at = [&](Span comment) {
      if (!found_.not_yaml && breaks_yaml(context_.sources.text(comment)))
        found_.not_yaml = comment;
    };
    for (const Span comment : model_.robot->document.comments) look_at(comment);
    if (expansion == nullptr) return;
    for (const xml::Document& one : expansion->documents) {
      if (one.source == expansion->root && one.view()) {
        for (const Span comment : one.comments) {
          if (comment.end <= one.view().span().begin) look_at(comment);
        }
      }
    }
    // The place where it is written.
    if (!found_.not_yaml || found_.not_yaml->source != expansion->source) return;
    const std::string_view text = context_.sources.text(*found_.not_yaml);
    for (const xml::Document& one : expansion->documents) {
      for (const Span comment : one.comments) {
        if (context_.sources.text(comment) == text) found_.not_yaml = comment;
      }
    }
  }

  /// Functions that xacro has under `xacro.` and warns about without it.
  void note_calls(std::string_view value, Span span) {
    if (value.find("${") == std::string_view::npos) return;
    for (const std::string_view name : {"load_yaml(", "abs_filename(", "dotify("}) {
      const std::size_t at = value.find(name);
      if (at == std::string_view::npos) continue;
      const char before = at == 0 ? ' ' : value[at - 1];
      const bool is_whole = before != '.' && before != '_' && !(before >= 'a' && before <= 'z') &&
                            !(before >= 'A' && before <= 'Z');
      if (is_whole) found_.noisy_calls.push_back(span);
    }
  }

  /// Whether a text in the output of xacro is no scalar of YAML: PyYAML, run.
  static bool breaks_yaml(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool is_last = i + 1 >= text.size() || text[i + 1] == ' ' || text[i + 1] == '\n' ||
                           text[i + 1] == '\r' || text[i + 1] == '\t';
      if (text[i] == ':' && is_last && i + 1 < text.size()) return true;
      if (text[i] == '#' && (i == 0 || is_blank(text[i - 1]))) return true;
      if (text[i] == '\t') return true;
    }
    return false;
  }

  const LinkedModel& model_;
  const LoadContext& context_;
  Surroundings& found_;
  std::set<std::string> read_;  ///< texts of a xacro that could not be expanded
};

}  // namespace

void read_robot_facts(const LinkedModel& model, const LoadContext& context, Surroundings& found) {
  RobotFacts(model, context, found).read_robot();
}

}  // namespace smurf
