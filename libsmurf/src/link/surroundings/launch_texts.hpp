// SPDX-License-Identifier: BSD-3-Clause
// Texts in launch files that are put together of parts.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "link/surroundings/launch_reader.hpp"
#include "link/surroundings/python_calls.hpp"

namespace smurf::launch {

using python::Piece;
using python::Value;

/// Pieces as one text; arguments are replaced by their defaults.
class Texts {
 public:
  void declare(const std::string& name, const Value& fallback) {
    const auto [known, is_new] = defaults_.try_emplace(name, fallback);
    if (is_new) return;
    // Declared twice, with different defaults.
    const std::string *first = known->second.literal(), *second = fallback.literal();
    if (first == nullptr || second == nullptr || *first != *second) known->second = Value{};
  }

  LaunchText of(const Value& value) const { return text_of(value, false); }
  /// The same, where an empty default is a value like others.
  LaunchText of_argument(const Value& value) const { return text_of(value, true); }

  /// Pieces with the defaults of their arguments.
  std::vector<Piece> resolved(const std::vector<Piece>& pieces, bool& by_default, bool keeps_empty,
                              int depth = 0) const {
    std::vector<Piece> all;
    for (const Piece& one : pieces) {
      const auto known =
          one.kind == Piece::Kind::argument ? defaults_.find(one.text) : defaults_.end();
      if (known == defaults_.end() || !known->second.is_text() ||
          (!keeps_empty && is_empty(known->second)) || depth > 4) {
        all.push_back(one);
        continue;
      }
      by_default = true;
      for (Piece& inner : resolved(known->second.pieces, by_default, keeps_empty, depth + 1)) {
        all.push_back(std::move(inner));
      }
    }
    return all;
  }

 private:
  /// The default of an argument that the user must give.
  static bool is_empty(const Value& fallback) {
    return std::all_of(fallback.pieces.begin(), fallback.pieces.end(), [](const Piece& one) {
      return one.kind == Piece::Kind::literal && one.text.empty();
    });
  }

  LaunchText text_of(const Value& value, bool keeps_empty) const {
    LaunchText text;
    text.span = value.span;
    if (!value.is_text()) return text;
    text.is_known = true;
    const std::vector<Piece> all = resolved(value.pieces, text.by_default, keeps_empty);
    for (const Piece& one : all) {
      if (one.kind == Piece::Kind::literal) {
        text.text += one.text;
        if (!one.span.empty()) text.span = one.span;
      } else if (one.kind == Piece::Kind::share && &one == &all.front()) {
        text.package = one.text;
        text.package_span = one.span;
      } else {
        text.is_known = false;
      }
    }
    return text;
  }

  std::map<std::string, Value> defaults_;
};

/// A text of a command, split at blanks outside of quotes.
std::vector<python::Value> words_of(const python::Value& command);
LaunchPath path_of(const LaunchText& text, const FindLaunchPath& find);
/// The words of `xacro FILE NAME:=VALUE`.
void read_command(const python::Value& command, const Texts& texts, const FindLaunchPath& find,
                  LaunchDescription& description);
/// A text that is the path of a robot, where the text of the robot is needed.
void read_path(const LaunchText& text, const FindLaunchPath& find, LaunchDescription& description);

}  // namespace smurf::launch
