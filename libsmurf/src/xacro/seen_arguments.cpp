// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/seen_arguments.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <span>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "xacro/whole_word.hpp"

namespace smurf::xacro {
namespace {

constexpr std::size_t kMostFiles = 100;              // of a package
constexpr std::uint64_t kMostBytes = 256ULL << 10U;  // of a file
constexpr int kMostLevels = 6;                       // from a file up to its package.xml
constexpr std::size_t kMostNames = 20;               // of arguments
constexpr std::size_t kMostValues = 100;             // of all arguments
constexpr std::size_t kMostValue = 60;               // characters

/// The folder of the nearest package.xml; without one, that of the file, or the one above it.
std::string package_of(const std::string& file, const FileReader& files) {
  std::string folder(path::parent(file));
  for (int i = 0; i < kMostLevels; ++i) {
    if (files.is_file(path::join(folder, "package.xml"))) return folder;
    folder = path::join(folder.empty() ? "." : folder, "..");
  }
  folder = path::parent(file);
  // `urdf/` and `launch/` beside each other.
  std::string above = path::join(folder.empty() ? "." : folder, "..");
  const bool is_above = !files.list(path::join(above, "launch")).empty();
  return is_above ? above : folder;
}

std::vector<std::string> launch_files(const std::string& package, const FileReader& files) {
  std::vector<std::string> found{path::join(package, "CMakeLists.txt")};
  std::vector<std::string> folders;
  for (const std::string_view name : {"launch", "config", "test", "tests", "scripts"}) {
    folders.push_back(path::join(package, name));
  }
  for (const std::string& folder : folders) {
    for (const std::string& name : files.list(folder)) {
      const std::string_view extension = path::extension(name);
      const bool is_launch = extension == ".launch" || extension == ".xml" || extension == ".py";
      if (is_launch && found.size() < kMostFiles) found.push_back(path::join(folder, name));
    }
  }
  return found;
}

/// A literal from `at` on: between quotes, or up to the next blank, quote or bracket. Empty if the
/// value is computed.
std::string literal_at(std::string_view text, std::size_t at) {
  if (at >= text.size()) return {};
  const bool is_quoted = text[at] == '"' || text[at] == '\'';
  const std::size_t begin = is_quoted ? at + 1 : at;
  const std::size_t end =
      is_quoted ? text.find(text[at], begin) : text.find_first_of(" \t\r\n\"'<>,;)]}", begin);
  if (end == std::string_view::npos || end - begin > kMostValue) return {};
  std::string_view value = text.substr(begin, end - begin);
  // Quotes for the shell that runs xacro: `default_value='""'` is an empty text.
  while (value.size() > 1 && value.front() == value.back() &&
         (value.front() == '"' || value.front() == '\'')) {
    value = value.substr(1, value.size() - 2);
  }
  return value.find_first_of("${}\n") == std::string_view::npos ? std::string(value) : "";
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  return at;
}

/// "name:=", "value" in a list of Python: the literal after the name and the sign, if it is one.
std::string next_literal(std::string_view text, std::size_t quote) {
  const std::size_t comma = skip_blanks(text, quote + 1);
  if (comma >= text.size() || text[comma] != ',') return {};
  const std::size_t value = skip_blanks(text, comma + 1);
  const bool is_literal = value < text.size() && (text[value] == '"' || text[value] == '\'');
  return is_literal ? literal_at(text, value) : "";
}

/// DeclareLaunchArgument("name", choices=["a", "b"])
std::vector<std::string> choices_after(std::string_view text, std::size_t begin, std::size_t end) {
  constexpr std::size_t kNear = 600;
  constexpr std::size_t kMostChoices = 50;
  std::vector<std::string> found;
  const std::size_t first = begin - std::min<std::size_t>(begin, 60);
  if (text.substr(first, begin - first).rfind("DeclareLaunchArgument(") == std::string_view::npos) {
    return found;
  }
  std::string_view near = text.substr(end, kNear);
  near = near.substr(0, near.find("DeclareLaunchArgument("));
  const std::size_t list = near.find("choices=[");
  if (list == std::string_view::npos) return found;
  const std::size_t close = std::min(near.find(']', list), near.size());
  for (std::size_t at = list; at < close && found.size() < kMostChoices; ++at) {
    if (near[at] != '"' && near[at] != '\'') continue;
    std::string value = literal_at(near, at);
    at = near.find(near[at], at + 1);
    if (at == std::string_view::npos) break;
    if (!value.empty()) found.push_back(std::move(value));
  }
  return found;
}

/// The value after the name of an argument, which ends at `end`.
std::string value_after(std::string_view text, std::size_t begin, std::size_t end) {
  const std::string_view rest = text.substr(end);
  if (rest.starts_with(":=")) {
    const std::size_t value = end + 2;
    const bool is_quote = value < text.size() && (text[value] == '"' || text[value] == '\'');
    const std::size_t after = is_quote ? skip_blanks(text, value + 1) : value;
    const bool ends_text =
        is_quote && (after >= text.size() ||
                     std::string_view(",)]+").find(text[after]) != std::string_view::npos);
    return ends_text ? next_literal(text, value) : literal_at(text, value);
  }
  const bool is_quoted = begin > 0 && end < text.size() && text[begin - 1] == text[end] &&
                         (text[end] == '"' || text[end] == '\'');
  if (!is_quoted) return {};
  // {"name": "value"}
  const std::size_t mark = skip_blanks(text, end + 1);
  if (mark < text.size() && text[mark] == ':') {
    const std::size_t value = skip_blanks(text, mark + 1);
    const bool is_literal = value < text.size() && (text[value] == '"' || text[value] == '\'');
    return is_literal ? literal_at(text, value) : "";
  }
  // DeclareLaunchArgument("name", default_value="value"), <arg name="name" default="value"/>
  constexpr std::size_t kNear = 300;
  const std::size_t first = begin - std::min<std::size_t>(begin, 60);
  const std::string_view before = text.substr(first, begin - first);
  const bool is_python = before.rfind("DeclareLaunchArgument(") != std::string_view::npos;
  const std::string_view near = rest.substr(0, kNear);
  const std::string_view word = is_python ? "default_value" : "default";
  const std::size_t stop = near.find(is_python ? "DeclareLaunchArgument(" : ">");
  const std::size_t found = near.substr(0, stop).find(word);
  const bool is_element = !is_python && before.rfind("<arg ") != std::string_view::npos;
  if (found == std::string_view::npos || (!is_python && !is_element)) return {};
  std::size_t value = skip_blanks(text, end + found + word.size());
  if (value >= text.size() || text[value] != '=') return {};
  value = skip_blanks(text, value + 1);
  const bool is_literal = value < text.size() && (text[value] == '"' || text[value] == '\'');
  return is_literal ? literal_at(text, value) : "";
}

}  // namespace

std::vector<SeenArgument> seen_arguments(const std::string& root,
                                         const std::vector<std::string>& names,
                                         const FileReader& files) {
  std::vector<SeenArgument> seen;
  // More are not shown, and each is searched in each file.
  const std::span<const std::string> first(names.data(), std::min(names.size(), kMostNames));
  for (const std::string& file : launch_files(package_of(root, files), files)) {
    const FileContent content = files.read(file, kMostBytes);
    for (const std::string& name : first) {
      for (const std::string& value : values_in(content.text, name)) {
        const bool is_known = std::any_of(seen.begin(), seen.end(), [&](const SeenArgument& one) {
          return one.name == name && one.value == value;
        });
        if (seen.size() >= kMostValues) return seen;
        if (!is_known) seen.push_back({name, value, file});
      }
    }
  }
  return seen;
}

std::vector<std::string> values_in(std::string_view text, std::string_view name) {
  std::vector<std::string> values;
  for (std::size_t at = find_name(text, name); at != std::string_view::npos;
       at = find_name(text, name, at + name.size())) {
    const std::size_t end = at + name.size();
    std::vector<std::string> choices = choices_after(text, at, end);
    if (!choices.empty()) return choices;
    std::string value = value_after(text, at, end);
    const bool is_known = std::find(values.begin(), values.end(), value) != values.end();
    if (!value.empty() && !is_known) values.push_back(std::move(value));
  }
  return values;
}

std::vector<std::string> choices_in(std::string_view text, std::string_view name) {
  for (std::size_t at = find_name(text, name); at != std::string_view::npos;
       at = find_name(text, name, at + name.size())) {
    std::vector<std::string> choices = choices_after(text, at, at + name.size());
    if (!choices.empty()) return choices;
  }
  return {};
}

namespace {

/// The arguments of a text in the order of their first use, and the first place of each.
struct ArgumentsInText {
  std::vector<std::string> names;  ///< that are used
  std::map<std::string, std::size_t, std::less<>> uses, declared;
};

ArgumentsInText arguments_in(std::string_view text) {
  ArgumentsInText found;
  constexpr std::string_view kUse = "$(arg ";
  for (std::size_t at = text.find(kUse); at != std::string_view::npos;
       at = text.find(kUse, at + 1)) {
    const std::size_t end = text.find(')', at);
    if (end == std::string_view::npos) break;
    const std::string_view name = trimmed(text.substr(at + kUse.size(), end - at - kUse.size()));
    if (name.empty() || name.find_first_of(" \t\r\n${}") != std::string_view::npos) continue;
    if (found.uses.emplace(name, at).second) found.names.emplace_back(name);
  }
  // ${xacro.arg('name')}
  for (std::size_t at = text.find("arg("); at != std::string_view::npos;
       at = text.find("arg(", at + 1)) {
    const std::size_t quote = skip_blanks(text, at + 4);
    if (quote >= text.size() || (text[quote] != '"' && text[quote] != '\'')) continue;
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end == std::string_view::npos) break;
    const std::string_view name = text.substr(quote + 1, end - quote - 1);
    if (!name.empty() && found.uses.emplace(name, at).second) found.names.emplace_back(name);
  }
  constexpr std::string_view kTag = "<xacro:arg";
  for (std::size_t at = text.find(kTag); at != std::string_view::npos;
       at = text.find(kTag, at + 1)) {
    const std::string_view tag =
        text.substr(at, std::min(text.find_first_of("<>", at + 1), text.size()) - at);
    for (std::size_t name = tag.find("name"); name != std::string_view::npos;
         name = tag.find("name", name + 1)) {
      std::size_t quote = skip_blanks(tag, name + 4);
      if (!is_blank(tag[name - 1]) || quote >= tag.size() || tag[quote] != '=') continue;
      quote = skip_blanks(tag, quote + 1);
      if (quote >= tag.size() || (tag[quote] != '"' && tag[quote] != '\'')) continue;
      const std::size_t end = tag.find(tag[quote], quote + 1);
      if (end == std::string_view::npos) break;
      found.declared.emplace(tag.substr(quote + 1, end - quote - 1), at);
      break;
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> all_arguments(std::string_view text) {
  ArgumentsInText found = arguments_in(text);
  for (const auto& [name, at] : found.declared) {
    if (!found.uses.contains(name)) found.names.push_back(name);
  }
  return std::move(found.names);
}

std::vector<std::string> undeclared_arguments(std::string_view text) {
  ArgumentsInText found = arguments_in(text);
  std::erase_if(found.names, [&](const std::string& name) {
    const auto place = found.declared.find(name);
    return place != found.declared.end() && place->second < found.uses[name];  // read from the top
  });
  return std::move(found.names);
}

}  // namespace smurf::xacro
