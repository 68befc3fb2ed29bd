// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/launch_texts.hpp"

#include <algorithm>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf::launch {

std::vector<Value> words_of(const Value& command) {
  std::vector<Value> words;
  bool is_open = false;
  for (const Piece& piece : command.pieces) {
    if (piece.kind != Piece::Kind::literal) {
      if (!is_open) words.emplace_back();
      is_open = true;
      words.back().kind = Value::Kind::text;
      if (words.back().pieces.empty()) words.back().span = piece.span;
      words.back().pieces.push_back(piece);
      continue;
    }
    std::string part;
    std::size_t at = 0;  // behind the part
    const auto flush = [&] {
      if (part.empty()) return;
      const Span span = piece.span_at(at - 1);
      if (!is_open) words.emplace_back();
      is_open = true;
      words.back().kind = Value::Kind::text;
      if (words.back().pieces.empty()) words.back().span = span;
      words.back().pieces.push_back({Piece::Kind::literal, part, span});
      part.clear();
    };
    for (const char c : piece.text) {
      if (is_blank(c)) {
        flush();
        is_open = false;
      } else if (c != '"' && c != '\'') {
        part += c;
      }
      ++at;
    }
    flush();
  }
  return words;
}

LaunchPath path_of(const LaunchText& text, const FindLaunchPath& find) {
  LaunchPath path;
  path.text = text;
  find(path);
  return path;
}

void read_path(const LaunchText& text, const FindLaunchPath& find, LaunchDescription& description) {
  const bool is_in_package = !text.package.empty();
  const bool is_of_robot =
      is_one_of(path::to_lower(path::extension(text.text)), {".urdf", ".xacro", ".sdf"}) &&
      text.text.find_first_of("<\n") == std::string::npos;
  if (!text.is_known || (!is_in_package && !is_of_robot)) return;
  description.form = LaunchDescription::Form::path;
  if (!text.by_default) description.span = text.span;
  description.file = path_of(text, find);
}

void read_command(const Value& command, const Texts& texts, const FindLaunchPath& find,
                  LaunchDescription& description) {
  description.form = LaunchDescription::Form::command;
  const std::vector<Value> words = words_of(command);
  bool has_value = false;
  for (const Value& word : words) {
    const LaunchText text = texts.of(word);
    const bool is_first = &word == &words.front();
    const std::string* begin =
        word.pieces.front().kind == Piece::Kind::literal ? &word.pieces.front().text : nullptr;
    const std::size_t equals = begin != nullptr ? begin->find(":=") : std::string::npos;
    if (std::exchange(has_value, false)) continue;  // of the option before it
    if (is_first) {
      description.program = text;
      description.lacks_blank = begin != nullptr && *begin == "xacro" && word.pieces.size() > 1 &&
                                (word.pieces[1].kind == Piece::Kind::share ||
                                 word.pieces[1].kind == Piece::Kind::argument);
    } else if (equals != std::string::npos) {
      LaunchDescription::Argument argument;
      argument.name = begin->substr(0, equals);
      argument.span = word.pieces.front().span;
      argument.value = texts.of_argument(word);
      std::string& value = argument.value.text;
      value = value.substr(std::min(equals + 2, value.size()));
      description.arguments.push_back(std::move(argument));
    } else if (begin != nullptr && begin->starts_with("-")) {
      description.options.insert(*begin);
      has_value = is_one_of(*begin, {"-o", "--output", "--verbosity"});
    } else if (!description.file) {
      description.file = path_of(text, find);
    } else {
      description.has_unknown_words = true;
    }
  }
}

}  // namespace smurf::launch
