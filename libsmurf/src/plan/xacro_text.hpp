// SPDX-License-Identifier: BSD-3-Clause
// What a xacro file defines and includes, read from its text, which may be incomplete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// A part of a text.
struct TextRange {
  std::size_t begin = 0, end = 0;
  bool holds(std::size_t at) const { return begin <= at && at <= end; }
  std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// An attribute of a start tag.
struct XacroAttribute {
  TextRange name;
  TextRange value;  ///< without quotes
};

/// A start tag.
struct XacroTag {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  TextRange name;
  TextRange tag;               ///< from `<` to behind `>`
  std::size_t end = 0;         ///< behind the end tag
  std::size_t parent = kNone;  ///< index of the element around it
  std::size_t macro = kNone;   ///< index of the `xacro:macro` around it
  std::vector<XacroAttribute> attributes = {};

  const XacroAttribute* find(std::string_view text, std::string_view attribute) const;
};

/// All start tags of a text, in its order; comments and CDATA are skipped.
std::vector<XacroTag> xacro_tags(std::string_view text);

enum class XacroNameKind : std::uint8_t { macro, parameter, block, property, argument };

/// A definition.
struct XacroName {
  XacroNameKind kind{};
  std::string name;
  TextRange place;    ///< of the name
  TextRange whole;    ///< of the tag; of a parameter with its default
  std::string value;  ///< of a macro its parameters; otherwise the written value or default
  bool has_value = false;
  std::size_t tag = XacroTag::kNone;    ///< index
  std::size_t macro = XacroTag::kNone;  ///< index of the tag of the macro of a parameter
};

/// What a text defines and includes.
struct XacroText {
  std::vector<XacroTag> tags;
  std::vector<XacroName> names;
  std::vector<TextRange> includes;  ///< the values of `filename`
};
XacroText read_xacro_text(std::string_view text);

/// The name of the called macro, without its namespaces; "" for another element.
std::string_view called_macro(std::string_view element);
/// Whether `xacro:NAME` is an element of the language.
bool is_xacro_element(std::string_view name);

/// An expression around a place of a text.
struct XacroExpression {
  char kind = '\0';  ///< '{' of `${...}`, '(' of `$(...)`; '\0': there is none
  TextRange whole;   ///< to behind the bracket, or to the end of the text if it is not closed
  TextRange inner;
  TextRange word;  ///< the name at the place; empty if there is none
};
XacroExpression xacro_expression_at(std::string_view text, std::size_t at);

/// Calls `visit` with the place of each use of the name in `${...}`, or of the argument in
/// `$(arg ...)`.
std::vector<TextRange> xacro_uses(std::string_view text, std::string_view name, bool is_argument);

}  // namespace smurf
