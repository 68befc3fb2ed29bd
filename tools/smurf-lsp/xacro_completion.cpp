// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/xacro_completion.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace smurf::lsp {
namespace {

/// An element of the language, with its attributes.
struct Element {
  std::string_view name, doc, snippet;
  std::array<std::string_view, 6> attributes;
};
constexpr std::array<Element, 10> kElements{{
    {"xacro:property",
     "gives a name to a value",
     "xacro:property name=\"$1\" value=\"$2\"/>",
     {"name", "value", "default", "scope", "lazy_eval", "remove"}},
    {"xacro:macro",
     "defines a macro",
     "xacro:macro name=\"$1\" params=\"$2\">\n\t$3\n</xacro:macro>",
     {"name", "params"}},
    {"xacro:include",
     "reads another file",
     "xacro:include filename=\"$1\"/>",
     {"filename", "ns", "optional"}},
    {"xacro:arg",
     "takes a value from the command line",
     "xacro:arg name=\"$1\" default=\"$2\"/>",
     {"name", "default"}},
    {"xacro:if",
     "keeps its content if the value is true",
     "xacro:if value=\"\\${$1}\">\n\t$2\n</xacro:if>",
     {"value"}},
    {"xacro:unless",
     "keeps its content if the value is false",
     "xacro:unless value=\"\\${$1}\">\n\t$2\n</xacro:unless>",
     {"value"}},
    {"xacro:insert_block",
     "inserts a block that was given to the macro",
     "xacro:insert_block name=\"$1\"/>",
     {"name"}},
    {"xacro:call", "calls a macro whose name is computed", "xacro:call macro=\"$1\"/>", {"macro"}},
    {"xacro:element",
     "makes an element whose name is computed",
     "xacro:element xacro:name=\"$1\"/>",
     {"xacro:name"}},
    {"xacro:attribute",
     "sets an attribute of the element around it",
     "xacro:attribute name=\"$1\" value=\"$2\"/>",
     {"name", "value"}},
}};

constexpr std::array<std::string_view, 26> kFunctions = {
    "abs",      "acos",  "asin",    "atan",    "atan2",
    "ceil",     "cos",   "degrees", "dict",    "e",
    "float",    "floor", "int",     "len",     "list",
    "max",      "min",   "pi",      "radians", "round",
    "sin",      "sqrt",  "str",     "tan",     "xacro.load_yaml",
    "xacro.arg"};
constexpr std::array<std::string_view, 6> kCommands = {"arg",  "cwd",  "env",
                                                       "eval", "find", "optenv"};

class Collector {
 public:
  Collector(const XacroFamily& family, std::size_t offset, const XmlContext& context)
      : family_(family),
        own_(family.files.front()),
        text_(family.text(own_)),
        offset_(offset),
        context_(context) {}

  XacroItems run() {
    const XacroExpression around = xacro_expression_at(text_, offset_);
    if (around.kind != '\0' && offset_ <= around.inner.end) {
      items_.begin = around.word.begin;
      items_.are_all = true;
      in_expression(around);
      return std::move(items_);
    }
    items_.begin = context_.begin;
    switch (context_.kind) {
    case XmlContext::Kind::element: add_elements(); break;
    case XmlContext::Kind::attribute: add_attributes(); break;
    case XmlContext::Kind::value: add_values(); break;
    default: break;
    }
    return std::move(items_);
  }

 private:
  void add(XacroItem::Kind kind, std::string label, std::string text, std::string snippet,
           std::string detail) {
    if (!seen_.insert(label).second) return;
    items_.list.push_back(
        {kind, std::move(label), std::move(text), std::move(snippet), std::move(detail)});
  }

  void add_name(const XacroName& one, std::string_view word) {
    add(XacroItem::Kind::name, one.name, one.name, {},
        std::string(word) + (one.has_value ? " = " + one.value : ""));
  }

  template <class Visit>
  void for_each_name(XacroNameKind kind, const Visit& visit) const {
    for (const XacroFamily::File& file : family_.files) {
      for (const XacroName& one : file.read.names) {
        if (one.kind == kind) visit(file, one);
      }
    }
  }

  /// The parameters of the macros of a name.
  template <class Visit>
  void for_each_parameter(std::string_view macro, const Visit& visit) const {
    for (const XacroFamily::File& file : family_.files) {
      for (const XacroName& one : file.read.names) {
        if (one.macro == XacroTag::kNone) continue;
        const XacroAttribute* name = file.read.tags[one.macro].find(family_.text(file), "name");
        if (name != nullptr && name->value.of(family_.text(file)) == macro) visit(one);
      }
    }
  }

  std::string_view macro_around() const {
    const XacroTag* macro = xacro_macro_around(own_, text_, offset_);
    const XacroAttribute* name = macro != nullptr ? macro->find(text_, "name") : nullptr;
    return name != nullptr ? name->value.of(text_) : std::string_view();
  }

  void in_expression(const XacroExpression& around) {
    const std::string_view before =
        text_.substr(around.inner.begin, around.word.begin - around.inner.begin);
    if (around.kind == '(' && before.empty()) {
      for (const std::string_view one : kCommands) {
        add(XacroItem::Kind::function, std::string(one), std::string(one), {}, {});
      }
    } else if (around.kind == '(' && before.starts_with("arg")) {
      for_each_name(XacroNameKind::argument,
                    [&](const auto&, const XacroName& one) { add_name(one, "argument"); });
    } else if (around.kind == '(' && before.starts_with("find")) {
      add_packages();
    } else if (around.kind == '{' || before.starts_with("eval")) {
      const std::string_view macro = macro_around();
      for_each_parameter(macro, [&](const XacroName& one) {
        if (one.kind == XacroNameKind::parameter) add_name(one, "parameter");
      });
      for_each_name(XacroNameKind::property,
                    [&](const auto&, const XacroName& one) { add_name(one, "property"); });
      for (const std::string_view one : kFunctions) {
        add(XacroItem::Kind::function, std::string(one), std::string(one), {}, {});
      }
    }
  }

  /// Those that the files name.
  void add_packages() {
    constexpr std::string_view kFind = "$(find ";
    for (const XacroFamily::File& file : family_.files) {
      const std::string_view text = family_.text(file);
      for (std::size_t at = text.find(kFind); at != text.npos; at = text.find(kFind, at + 1)) {
        const std::size_t begin = at + kFind.size();
        const std::size_t end = text.find_first_of(")\"<\n", begin);
        if (end == text.npos || text[end] != ')' || (begin <= offset_ && offset_ <= end)) continue;
        std::string name(text.substr(begin, end - begin));
        add(XacroItem::Kind::name, name, name, {}, "package");
      }
    }
  }

  void add_elements() {
    for (const Element& one : kElements) {
      add(XacroItem::Kind::element, std::string(one.name), std::string(one.name),
          std::string(one.snippet), std::string(one.doc));
    }
    for_each_name(XacroNameKind::macro, [&](const auto&, const XacroName& one) {
      const std::string name = "xacro:" + one.name;
      std::string snippet = name;
      int stop = 0;
      bool has_block = false;
      for_each_parameter(one.name, [&](const XacroName& parameter) {
        has_block = has_block || parameter.kind == XacroNameKind::block;
        if (parameter.kind == XacroNameKind::block || parameter.has_value) return;
        snippet += " " + parameter.name + "=\"$" + std::to_string(++stop) + "\"";
      });
      snippet += has_block ? ">\n\t$" + std::to_string(++stop) + "\n</" + name + ">" : "/>";
      add(XacroItem::Kind::element, name, name, std::move(snippet), one.value);
    });
  }

  void add_attribute(std::string_view name, std::string detail) {
    const auto& has = context_.attributes;
    if (name.empty() || std::find(has.begin(), has.end(), name) != has.end()) return;
    add(XacroItem::Kind::attribute, std::string(name), std::string(name) + "=\"\"",
        std::string(name) + "=\"$1\"", std::move(detail));
  }

  void add_attributes() {
    items_.are_all = context_.element.starts_with("xacro:");
    for (const Element& one : kElements) {
      if (one.name != context_.element) continue;
      for (const std::string_view name : one.attributes) add_attribute(name, {});
    }
    const std::string_view called = called_macro(context_.element);
    if (called.empty()) return;
    for_each_parameter(called, [&](const XacroName& one) {
      if (one.kind != XacroNameKind::parameter) return;
      add_attribute(one.name, one.has_value ? "by default " + one.value : "required");
    });
  }

  void add_values() {
    items_.are_all = context_.element.starts_with("xacro:");
    if (context_.element == "xacro:include") items_.are_files = context_.attribute == "filename";
    if (context_.element == "xacro:insert_block" && context_.attribute == "name") {
      for_each_parameter(macro_around(), [&](const XacroName& one) {
        if (one.kind == XacroNameKind::block) add_name(one, "block");
      });
    }
    if (context_.element == "xacro:call" && context_.attribute == "macro") {
      for_each_name(XacroNameKind::macro, [&](const auto&, const XacroName& one) {
        add(XacroItem::Kind::name, one.name, one.name, {}, one.value);
      });
    }
  }

  const XacroFamily& family_;
  const XacroFamily::File& own_;
  std::string_view text_;
  std::size_t offset_;
  const XmlContext& context_;
  XacroItems items_;
  std::set<std::string> seen_;
};

}  // namespace

XacroItems xacro_items(const XacroFamily& family, std::size_t offset, const XmlContext& context) {
  return Collector(family, offset, context).run();
}

}  // namespace smurf::lsp
