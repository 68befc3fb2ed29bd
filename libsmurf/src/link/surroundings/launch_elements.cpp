// SPDX-License-Identifier: BSD-3-Clause
// Sources: launch_xml, launch_yaml and launch, branches humble and jazzy; roslaunch of noetic.
#include "link/surroundings/launch_elements.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "base/text/words.hpp"
#include "link/surroundings/launch_mistakes.hpp"
#include "link/surroundings/launch_texts.hpp"

namespace smurf::launch {
namespace {

class ElementReader {
 public:
  ElementReader(const FindLaunchPath& find, LaunchFile& file) : find_(find), file_(file) {}

  void run(const Element& root) {
    const bool was_ros1 = file_.is_ros1;
    declare(root);
    visit(root, false, "");
    // Words of ROS 1 in a file of ROS 2 are mistakes, unless most of it was left over from ROS 1.
    const int old = words_of_ros1(root);
    const bool is_ros2 = file_.form == LaunchFile::Form::yaml ||
                         (!was_ros1 && file_.path.ends_with(".launch.xml") && old <= 0);
    if (file_.form == LaunchFile::Form::xml && old > 0) file_.is_ros1 = true;
    if (is_ros2) file_.is_ros1 = false;
    if (!file_.is_ros1) find_mistakes(root, texts_, file_);
  }

 private:
  static Value value_of(const Element& element, std::string_view name) {
    const Attribute* attribute = element.attribute(name);
    return attribute == nullptr ? Value{} : substituted(attribute->value, attribute->span);
  }
  LaunchText text_of(const Element& element, std::string_view name) const {
    return texts_.of(value_of(element, name));
  }

  // The recursions are as deep as the file, whose depth is limited.
  /// How many attributes only ROS 1 reads, less those that only ROS 2 reads.
  static int words_of_ros1(const Element& element) {
    int count = 0;
    for (const Attribute& one : element.attributes) {
      const auto has = [&](std::string_view text) {
        return one.value.find(text) != std::string::npos;
      };
      const bool is_old_name = one.name == "pass_all_args" || one.name == "doc" ||
                               (one.name == "type" && element.attribute("pkg") != nullptr);
      if (has("$(find ") || has("$(arg ") || is_old_name) ++count;
      if (has("$(find-pkg-share ") || has("$(var ") || one.name == "exec") --count;
    }
    for (const Element& child : element.children) count += words_of_ros1(child);
    return count;
  }

  void declare(const Element& element) {
    for (const Element& child : element.children) {
      if (child.name != "arg" && child.name != "let") {
        declare(child);
        continue;
      }
      const Attribute* name = child.attribute("name");
      const Attribute* value = child.attribute("default");
      if (value == nullptr) value = child.attribute("value");
      if (name == nullptr || value == nullptr) continue;
      texts_.declare(name->value, substituted(value->value, value->span));
      const auto [written, is_new] = written_.try_emplace(name->value, value);
      if (!is_new) written->second = nullptr;
    }
  }

  /// What is written for a value: for `$(var NAME)`, the value of the only `let` or `arg` of that
  /// name.
  const Attribute& written(const Attribute& value) const {
    std::string_view text = trimmed(value.value);
    if (!text.starts_with("$(var ") || !text.ends_with(")")) return value;
    text = trimmed(text.substr(6, text.size() - 7));
    const auto found = written_.find(text);
    return found == written_.end() || found->second == nullptr ? value : *found->second;
  }

  void visit(const Element& element, bool is_conditional, const std::string& space) {
    for (const Element& child : element.children) {
      const bool is_here = is_conditional || child.attribute("if") != nullptr ||
                           child.attribute("unless") != nullptr;
      if (child.name == "node") {
        node(child, is_here, space);
      } else if (child.name == "param") {
        // "/$(arg name)/robot_description"
        const std::string_view name = attribute(child, "name");
        if (name.substr(name.rfind('/') + 1) == "robot_description") description(child, nullptr);
      } else if (child.name == "include") {
        file_.has_includes = true;
        path(value_of(child, "file"));
      } else if (child.name == "rosparam") {
        path(value_of(child, "file"));
      }
      if (child.name == "arg") path(value_of(child, "default"));
      std::string inner = space;
      if (child.name == "group" && child.attribute("ns") != nullptr) {
        inner += "/" + std::string(attribute(child, "ns"));
      }
      for (const Element& one : child.children) {
        if (one.name == "push-ros-namespace" || one.name == "push_ros_namespace") inner += "/?";
      }
      if (child.name != "node") visit(child, is_here, inner);
    }
  }

  static std::string_view attribute(const Element& element, std::string_view name) {
    const Attribute* found = element.attribute(name);
    return found == nullptr ? std::string_view() : found->value;
  }

  void path(const Value& value) {
    if (!value.is_text()) return;
    const LaunchText text = texts_.of(value);
    const bool has_rest = text.text.find_first_not_of("/") != std::string::npos;
    const bool is_one = text.text.find_first_of(" \n\t") == std::string::npos;
    if (text.is_known && !text.package.empty() && has_rest && is_one) {
      file_.paths.push_back(path_of(text, find_));
    }
  }

  void node(const Element& element, bool is_conditional, const std::string& space) {
    LaunchNode node;
    node.span = element.span;
    node.is_conditional = is_conditional;
    node.package = text_of(element, "pkg");
    file_.is_ros1 = file_.is_ros1 || element.attribute("type") != nullptr;
    node.executable = text_of(element, element.attribute("exec") != nullptr ? "exec" : "type");
    node.name = text_of(element, "name");
    const bool has_own =
        element.attribute("ns") != nullptr || element.attribute("namespace") != nullptr;
    node.has_namespace = has_own || !space.empty();
    node.name_space = text_of(element, element.attribute("ns") != nullptr ? "ns" : "namespace");
    if (!has_own) {
      node.name_space.text = space;
      node.name_space.is_known = space.find('?') == std::string::npos;
    }
    if (const Attribute* words = element.attribute("args")) {
      // In a message of YAML, as `rosservice call` gets it, marks may follow a path.
      const bool is_message = words->value.find_first_of("{[,") != std::string::npos;
      for (const Value& word : words_of(value_of(element, "args"))) {
        LaunchText text = texts_.of(word);
        node.has_unknown_arguments = node.has_unknown_arguments || !text.is_known;
        if (!is_message) path(word);
        node.arguments.push_back(std::move(text));
      }
    }
    for (const Element& child : element.children) {
      if (child.name != "param") continue;
      if (child.attribute("from") != nullptr) {
        path(value_of(child, "from"));
        node.has_unknown_parameters = true;
        continue;
      }
      LaunchText name = text_of(child, "name");
      if (name.text == "robot_description") description(child, &node);
      node.parameters.emplace_back(std::move(name), text_of(child, "value"));
    }
    file_.nodes.push_back(std::move(node));
  }

  void description(const Element& element, LaunchNode* node) {
    LaunchDescription found;
    found.span = element.span;
    found.is_wrapped = attribute(element, "type") == "str" || file_.is_ros1 || node == nullptr;
    if (element.attribute("command") != nullptr) {
      file_.is_ros1 = true;
      found.tolerates_errors = true;
      found.span = element.attribute("command")->span;
      Value value = value_of(element, "command");
      if (value.pieces.size() > 1 && value.pieces.front().kind == Piece::Kind::literal &&
          trimmed(value.pieces.front().text).empty()) {
        value.pieces.erase(value.pieces.begin());
      }
      // `$(find xacro)/xacro` is the program.
      if (value.pieces.size() > 1 && value.pieces.front().kind == Piece::Kind::share &&
          value.pieces.front().text == "xacro") {
        value.pieces.erase(value.pieces.begin());
      }
      read_command(value, texts_, find_, found);
    } else if (element.attribute("textfile") != nullptr) {
      file_.is_ros1 = true;
      found.form = LaunchDescription::Form::content;
      found.span = element.attribute("textfile")->span;
      found.file = path_of(text_of(element, "textfile"), find_);
    } else if (const Attribute* value = element.attribute("value")) {
      found.span = value->span;
      const std::string_view text = trimmed(written(*value).value);
      if (text.starts_with("$(command ") && text.ends_with(")")) {
        std::string_view inner = trimmed(text.substr(10, text.size() - 11));
        const char quote = inner.empty() ? ' ' : inner.front();
        if (quote == '\'' || quote == '"') {
          const std::size_t end = inner.find(quote, 1);
          found.tolerates_errors = !trimmed(inner.substr(std::min(end + 1, inner.size()))).empty();
          inner = inner.substr(1, end == std::string_view::npos ? end : end - 1);
        }
        const Value command = substituted(inner, written(*value).span);
        if (!command.pieces.empty()) read_command(command, texts_, find_, found);
      } else {
        read_path(text_of(element, "value"), find_, found);
      }
    }
    file_.descriptions.push_back(found);
    if (node != nullptr) node->descriptions.push_back(std::move(found));
  }

  const FindLaunchPath& find_;
  LaunchFile& file_;
  Texts texts_;
  std::map<std::string, const Attribute*, std::less<>> written_;  ///< null: several
};

}  // namespace

Value substituted(std::string_view text, Span span) {
  Value value;
  value.kind = Value::Kind::text;
  value.span = span;
  const std::size_t size = text.size();
  while (!text.empty()) {
    const std::size_t begin = text.find("$(");
    if (begin > 0) {
      value.pieces.push_back({Piece::Kind::literal, std::string(text.substr(0, begin)), span});
    }
    if (begin == std::string_view::npos) break;
    std::size_t end = begin + 2;
    for (int depth = 1; end < text.size() && depth > 0; ++end) {
      if (text[end] == '(') ++depth;
      if (text[end] == ')') --depth;
    }
    const std::string_view inner = trimmed(text.substr(begin + 2, end - begin - 3));
    std::size_t at = 0;
    const std::string_view word = next_word(inner, at);
    const std::string rest(trimmed(inner.substr(std::min(at, inner.size()))));
    Piece piece{Piece::Kind::unknown, rest, span};
    if (is_one_of(word, {"find-pkg-share", "find"})) {
      piece.kind = Piece::Kind::share;
      // Where the name is written, unless entities make the text shorter than its place.
      const std::size_t name = text.find(rest, begin + 2 + word.size());
      if (name != std::string_view::npos && span.end - span.begin == size) {
        piece.span.begin += static_cast<std::uint32_t>(size - text.size() + name);
        piece.span.end = piece.span.begin + static_cast<std::uint32_t>(rest.size());
      }
    }
    if (is_one_of(word, {"var", "arg"})) piece.kind = Piece::Kind::argument;
    value.pieces.push_back(std::move(piece));
    text.remove_prefix(std::min(end, text.size()));
  }
  return value;
}

const Attribute* Element::attribute(std::string_view wanted) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& one) { return one.name == wanted; });
  return found == attributes.end() ? nullptr : &*found;
}

void read_elements(const Element& root, const FindLaunchPath& find, LaunchFile& file) {
  ElementReader(find, file).run(root);
}

}  // namespace smurf::launch
