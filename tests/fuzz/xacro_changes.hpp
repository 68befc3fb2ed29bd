// SPDX-License-Identifier: BSD-3-Clause
// Mutations of what the trees of XML and YAML do not show: expressions of xacro, and its elements.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/mutator.hpp"

namespace smurf::test {

/// Changes a random expression, or adds an element of xacro. False if there was nothing to change.
class XacroChange {
 public:
  XacroChange(std::string& text, Random& random) : text_(text), random_(random) {}

  bool run() {
    if (text_.find("xacro:") == std::string::npos) return false;
    for (std::size_t at = text_.find("${"); at != std::string::npos;
         at = text_.find("${", at + 2)) {
      const std::size_t end = text_.find('}', at);
      if (end != std::string::npos) codes_.push_back({at + 2, end});
    }
    switch (random_.below(4)) {
    case 0: return change_token();
    case 1: return combine();
    case 2: return put_expression();
    default: return put_element();
    }
  }

 private:
  struct Part {
    std::size_t begin, end;
  };
  static constexpr std::string_view kTokens[] = {
      "+",      "-",      "*",      "**",    "/",    "//",    "%",    "&lt;&lt;", "|",
      "^",      "~",      "==",     "!=",    "&lt;", " in ",  " is ", " and ",    " or ",
      " not ",  "(",      ")",      "[",     "]",    ",",     ":",    ".",        " if ",
      " else ", " for ",  "lambda", ":=",    "=",    "0",     "1",    "-1",       "0.5",
      "1e308",  "10**30", "1e-320", "2**63", "''",   "'a b'", "'%s'", "None",     "True",
      "pi",     "inf",    "nan",    "x",     "_",    "\\",    "'",    "$(arg x)", "$${x}"};
  static constexpr std::string_view kFunctions[] = {"len",
                                                    "str",
                                                    "int",
                                                    "float",
                                                    "list",
                                                    "dict",
                                                    "max",
                                                    "min",
                                                    "round",
                                                    "map",
                                                    "sin",
                                                    "log",
                                                    "factorial",
                                                    "python.range",
                                                    "python.set",
                                                    "python.zip",
                                                    "python.sorted",
                                                    "python.sum",
                                                    "python.tuple",
                                                    "python.repr",
                                                    "python.type",
                                                    "python.slice",
                                                    "python.abs",
                                                    "xacro.dotify",
                                                    "python.any",
                                                    "xacro.load_yaml",
                                                    "xacro.tokenize",
                                                    "python.enumerate",
                                                    "python.filter"};
  static constexpr std::string_view kMethods[] = {
      "split", "join",  "strip",  "format", "replace", "append", "extend",     "pop",    "insert",
      "sort",  "items", "update", "get",    "find",    "count",  "startswith", "center", "copy"};
  static constexpr std::string_view kElements[] = {
      R"(<xacro:property name="x" value="@"/>)",
      R"(<xacro:property name="x" value="@" scope="parent"/>)",
      R"(<xacro:property name="x" value="@" lazy_eval="false"/>)",
      R"(<xacro:property name="x" default="@"/>)",
      R"(<xacro:property name="x" remove="true"/>)",
      R"(<xacro:property name="x"><a v="@"/><b>@</b></xacro:property>)",
      R"(<xacro:macro name="m" params="x:=@ y:=^|1 *b **c"><a v="@"/><xacro:insert_block name="b"/></xacro:macro>)",
      R"(<xacro:macro name="m" params="x"><xacro:if value="${x > 0}"><xacro:m x="${x-1}"/></xacro:if></xacro:macro>)",
      R"(<xacro:m x="@"/>)",
      R"(<xacro:m x="@"><a v="$@"/><b/></xacro:m>)",
      R"(<xacro:call macro="@" x="1"/>)",
      R"(<xacro:insert_block name="x"/>)",
      R"(<xacro:if value="@"><a/></xacro:if>)",
      R"(<xacro:unless value="@"><a v="@"/></xacro:unless>)",
      R"(<xacro:arg name="x" default="@"/>)",
      R"(<xacro:include filename="*.xacro" ns="x"/>)",
      R"(<xacro:include filename="@" optional="true"/>)",
      R"(<xacro:element xacro:name="@" v="@"/>)",
      R"(<xacro:attribute name="v" value="a@"/>)",
      R"(<!-- xacro:eval-comments --><!-- @ -->)"};

  template <class List>
  std::string one_of(const List& list) {
    return std::string(list[random_.below(std::size(list))]);
  }
  std::string code() {
    if (codes_.empty() || random_.one_in(4)) return one_of(kTokens);
    const Part part = codes_[random_.below(codes_.size())];
    return text_.substr(part.begin, part.end - part.begin);
  }

  bool change_token() {
    if (codes_.empty()) return false;
    const Part part = codes_[random_.below(codes_.size())];
    if (part.begin == part.end) return false;
    std::size_t begin = part.begin + random_.below(part.end - part.begin);
    const auto is_word = [&](std::size_t at) {
      const char c = text_[at];
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    std::size_t end = begin + 1;
    while (is_word(begin) && begin > part.begin && is_word(begin - 1)) --begin;
    while (is_word(begin) && end < part.end && is_word(end)) ++end;
    if (random_.one_in(3)) end = begin;  // insert
    text_.replace(begin, end - begin, random_.one_in(6) ? "" : one_of(kTokens));
    return true;
  }

  std::string combined() {
    const std::string a = code();
    const std::string b = code();
    switch (random_.below(9)) {
    case 0: return one_of(kFunctions) + "(" + a + ")";
    case 1: return one_of(kFunctions) + "(" + a + "," + b + ")";
    case 2: return "(" + a + ")" + one_of(kTokens) + "(" + b + ")";
    case 3: return "[" + a + " for x in " + b + "]";
    case 4: return "(lambda x: " + a + ")(" + b + ")";
    case 5: return "(" + a + ")[" + b + (random_.one_in(2) ? ":" : "") + "]";
    case 6: return "(" + a + ")." + one_of(kMethods) + "(" + b + ")";
    case 7: return "(" + a + ") if (" + b + ") else " + a;
    default: return "[" + a + "," + b + "]";
    }
  }

  bool combine() {
    if (codes_.empty()) return false;
    const Part part = codes_[random_.below(codes_.size())];
    const std::string code = combined();
    text_.replace(part.begin, part.end - part.begin, code);
    return true;
  }

  /// In a value that had none.
  bool put_expression() {
    std::size_t begin = text_.find("=\"", random_.below(text_.size()));
    if (begin == std::string::npos) return false;
    begin += 2;
    const std::size_t end = text_.find('"', begin);
    if (end == std::string::npos) return false;
    const std::string expression = "${" + combined() + "}";
    text_.replace(begin, random_.one_in(2) ? end - begin : 0, expression);
    return true;
  }

  bool put_element() {
    const std::size_t at = text_.find('<', random_.below(text_.size()));
    if (at == std::string::npos || text_.substr(at, 2) == "<?") return false;
    std::string element = one_of(kElements);
    for (std::size_t mark = element.find('@'); mark != std::string::npos;
         mark = element.find('@', mark)) {
      const std::string expression = "${" + code() + "}";
      element.replace(mark, 1, expression);
      mark += expression.size();
    }
    text_.insert(at, element);
    return true;
  }

  std::string& text_;
  Random& random_;
  std::vector<Part> codes_;  ///< what stands in `${...}`
};

}  // namespace smurf::test
