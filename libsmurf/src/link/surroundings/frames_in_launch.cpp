// SPDX-License-Identifier: BSD-3-Clause
// Frames in launch files.
// Source: geometry2 static_transform_broadcaster_program.cpp, branches humble and rolling.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/words.hpp"
#include "link/surroundings/frame_names.hpp"

namespace smurf {
namespace {

using Use = FrameName::Use;

class Frames {
 public:
  Frames(const LaunchFile& file, const TakeFrame& take) : file_(file), take_(take) {}

  void run() {
    for (const LaunchNode& node : file_.nodes) {
      const auto transform = static_transform_of(node);
      if (transform) {
        if (transform->parent != nullptr) add(*transform->parent, Use::parent, "--frame-id");
        if (transform->child != nullptr) add(*transform->child, Use::child, "--child-frame-id");
      } else {
        options(node);
      }
      for (const auto& [name, value] : node.parameters) {
        if (name.is_known && may_hold_link(name.text)) add(value, Use::other, name.text);
      }
    }
  }

 private:
  /// Frames that options name, also where other arguments are not known. The last one of a name
  /// counts.
  void options(const LaunchNode& node) {
    const bool is_rviz = is_one_of(node.executable.text, {"rviz2", "rviz"});
    std::map<Use, std::pair<std::string_view, const LaunchText*>> last;
    for (std::size_t i = 0; i + 1 < node.arguments.size(); ++i) {
      const std::string_view option = node.arguments[i].text;
      const std::pair named{option, &node.arguments[i + 1]};
      if (option == "--frame-id") last.insert_or_assign(Use::parent, named);
      if (option == "--child-frame-id") last.insert_or_assign(Use::child, named);
      if (is_rviz && is_one_of(option, {"-f", "--fixed-frame"})) {
        last.insert_or_assign(Use::other, named);
      }
    }
    for (const auto& [use, named] : last) add(*named.second, use, named.first);
  }

  void add(const LaunchText& text, Use use, std::string_view key) {
    if (!text.is_known || !text.package.empty() || text.text.empty()) return;
    const auto place = place_of(text);
    if (!place) return;
    FrameName frame;
    frame.use = use;
    frame.name = text.text;
    frame.place = *place;
    frame.written = text.span;
    frame.key = key;
    take_(frame);
  }

  /// Where a name is written as it is; none if it is put together of parts, or has escapes.
  std::optional<NamePlace> place_of(const LaunchText& text) {
    const Span whole = text.span;
    if (whole.empty() || whole.end > file_.text.size()) return std::nullopt;
    const std::string_view raw = file_.text.substr(whole.begin, whole.end - whole.begin);
    if (file_.form == LaunchFile::Form::python) {
      if (raw != text.text) return std::nullopt;
      return NamePlace{Reference::Notation::program, Reference::kNothing, whole, whole};
    }
    const auto at = word_in(raw, text.text, used_[{whole.begin, text.text}]);
    if (!at) return std::nullopt;
    const bool is_yaml = file_.form == LaunchFile::Form::yaml;
    const NamePlace place{is_yaml ? Reference::Notation::yaml : Reference::Notation::xml_attribute,
                          Reference::kNothing, whole, whole};
    return part_of(place, *at, text.text.size());
  }

  /// The next place of a word that stands between blanks or quotes, as in
  /// `args="0 0 0 0 0 0 base_link laser"`.
  static std::optional<std::size_t> word_in(std::string_view raw, std::string_view word,
                                            std::size_t& from) {
    const auto is_apart = [&](std::size_t at) {
      return at >= raw.size() || is_blank(raw[at]) || raw[at] == '\'' || raw[at] == '"';
    };
    for (std::size_t at = raw.find(word, from); at != std::string_view::npos;
         at = raw.find(word, at + 1)) {
      if ((at > 0 && !is_apart(at - 1)) || !is_apart(at + word.size())) continue;
      from = at + word.size();
      return at;
    }
    return std::nullopt;
  }

  const LaunchFile& file_;
  const TakeFrame& take_;
  /// Where the search for a word in a text goes on: a frame may be named twice.
  std::map<std::pair<std::uint32_t, std::string_view>, std::size_t> used_;
};

}  // namespace

std::optional<StaticTransform> static_transform_of(const LaunchNode& node) {
  if (!node.executable.is_known || node.executable.text != "static_transform_publisher" ||
      node.has_unknown_arguments) {
    return std::nullopt;
  }
  StaticTransform found{&node, nullptr, nullptr};
  std::vector<const LaunchText*> words;
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    const LaunchText& one = node.arguments[i];
    const LaunchText* next = i + 1 < node.arguments.size() ? &node.arguments[i + 1] : nullptr;
    if (one.text == "--frame-id") found.parent = next;
    if (one.text == "--child-frame-id") found.child = next;
    words.push_back(&one);
  }
  const bool has_options = std::any_of(words.begin(), words.end(), [](const LaunchText* one) {
    return one->text.starts_with("--");
  });
  constexpr std::size_t kEuler = 8, kQuaternion = 9;  // x y z yaw pitch roll PARENT CHILD
  if (!has_options &&
      (words.size() == kEuler || words.size() == kQuaternion || words.size() == kQuaternion + 1)) {
    // ROS 1 has a period at the end.
    const std::size_t end = words.back()->text.find_first_not_of("0123456789.") == std::string::npos
                                ? words.size() - 1
                                : words.size();
    found.parent = words[end - 2];
    found.child = words[end - 1];
  }
  return found;
}

void for_each_frame(const LaunchFile& file, const TakeFrame& take) { Frames(file, take).run(); }

}  // namespace smurf
