// SPDX-License-Identifier: BSD-3-Clause
// Outlines: links and joints as a tree, sections with their entries, entities of scenes.
#include <algorithm>
#include <set>

#include "base/files/path.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/xacro.hpp"

namespace smurf::lsp {
namespace {

// SymbolKind of the protocol.
constexpr int kNamespace = 3, kClass = 5, kProperty = 7, kField = 8, kFunction = 12, kVariable = 13,
              kObject = 19, kEvent = 24;
/// Clients and JSON libraries fail at chains of thousands of links.
constexpr int kDeepestLink = 40;
/// Nobody reads a longer list; the user types more of the name instead.
constexpr std::size_t kMostSymbols = 2000;

int kind_of(NameKind kind) {
  switch (kind) {
  case NameKind::link: return kClass;
  case NameKind::joint: return kFunction;
  case NameKind::motor: return kEvent;
  case NameKind::sensor: return kField;
  case NameKind::entity: return kObject;
  case NameKind::material: return kProperty;
  default: return kVariable;
  }
}

/// Prints symbols as text: a file of a megabyte can have hundreds of thousands. Clients without
/// support for trees get a flat list.
class SymbolPrinter {
 public:
  SymbolPrinter(const Positions& positions, bool is_deep, std::string uri)
      : positions_(positions), is_deep_(is_deep), uri_(std::move(uri)) {}

  /// The symbols until end() are below this one.
  void begin(std::string_view name, int kind, Span whole, Span named,
             std::string_view detail = {}) {
    const bool is_inside = whole.begin <= named.begin && named.end <= whole.end;
    Json one = {{"name", name.empty() ? "?" : std::string(name)}, {"kind", kind}};
    const Json selected = positions_.range(is_inside ? named : whole);
    if (is_deep_) {
      one["range"] = positions_.range(whole);
      one["selectionRange"] = selected;
      if (!detail.empty()) one["detail"] = detail;
    } else {
      one["location"] = {{"uri", uri_}, {"range", selected}};
      if (!containers_.empty()) one["containerName"] = containers_.back();
      containers_.push_back(one["name"].get<std::string>());
    }
    text_ += text_.ends_with('[') ? "" : ",";
    text_ += dump(one);
    if (is_deep_) text_.replace(text_.size() - 1, 1, R"(,"children":[)");
  }
  void end() {
    if (is_deep_) {
      text_ += "]}";
    } else {
      containers_.pop_back();
    }
  }
  std::string take() { return std::move(text_) + "]"; }

 private:
  const Positions& positions_;
  const bool is_deep_;
  const std::string uri_;
  std::vector<std::string> containers_;  ///< of a flat list
  std::string text_ = "[";
};

class RobotOutline {
 public:
  RobotOutline(const LinkedModel& model, SymbolPrinter& symbols)
      : model_(model), symbols_(symbols), seen_(model.robot->links.size()) {}

  void print() {
    for (const LinkIndex root : model_.tree.roots) print(root, 0);
    // Links that no root reaches are in a loop, or too deep.
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      print(LinkIndex{static_cast<std::uint32_t>(i)}, kDeepestLink);
    }
  }

 private:
  void print(LinkIndex index, int depth) {
    if (seen_[to_size(index)]) return;
    seen_[to_size(index)] = true;
    const urdf::Link& link = model_.link(index);
    symbols_.begin(link.name.value_or({}), kClass, link.span, link.name.span, "link");
    for (const JointIndex joint : model_.tree.child_joints[to_size(index)]) {
      begin(model_.joint(joint));
      const auto child = model_.tree.joint_child[to_size(joint)];
      if (depth < kDeepestLink && child) print(*child, depth + 2);
      symbols_.end();
    }
    symbols_.end();
  }

  void begin(const urdf::Joint& joint) {
    symbols_.begin(joint.name.value_or({}), kFunction, joint.span, joint.name.span,
                   "joint " + joint.type_name.value_or({}));
  }

  const LinkedModel& model_;
  SymbolPrinter& symbols_;
  std::vector<bool> seen_;
};

/// The name of an entry and its place.
std::pair<std::string_view, Span> name_of(yaml::View entry) {
  if (!entry.key_span().empty()) return {entry.key(), entry.key_span()};
  if (entry.is_mapping()) {
    for (const char* key : {"name", "file", "link", "joint"}) {
      const yaml::View value = entry.find(key);
      if (value && value.is_scalar()) return {value.text(), value.span()};
    }
  }
  return {entry.is_scalar() ? entry.text() : std::string_view(), entry.span()};
}

Span whole_of(yaml::View view) {
  const Span key = view.key_span();
  const Span value = view.span();
  if (key.empty()) return value;
  return {key.source, key.begin, std::max(key.end, value.end)};
}

void print_sections(const yaml::Document& document, SymbolPrinter& symbols) {
  const yaml::View root = document.view();
  if (!root || !root.is_mapping()) return;
  for (const yaml::View section : root) {
    symbols.begin(section.key(), kNamespace, whole_of(section), section.key_span());
    if (section.is_sequence() || section.is_mapping()) {
      for (const yaml::View entry : section) {
        const auto [name, place] = name_of(entry);
        symbols.begin(name, kObject, whole_of(entry), place);
        symbols.end();
      }
    }
    symbols.end();
  }
}

bool holds_letters(std::string_view name, std::string_view query) {
  std::size_t at = 0;
  for (const char c : path::to_lower(name)) {
    if (at < query.size() && c == query[at]) ++at;
  }
  return at == query.size();
}

}  // namespace

namespace {

/// The outline of a xacro: its macros with what they define, links and joints as they are written.
class XacroOutline {
 public:
  XacroOutline(const XacroRequest& request, SymbolPrinter& symbols)
      : read_(request.own().read),
        text_(request.text()),
        source_(request.own().source),
        symbols_(symbols) {}

  void print() {
    std::vector<std::size_t> open;  // ends of the symbols that are not closed
    for (std::size_t i = 0; i < read_.tags.size(); ++i) {
      const XacroTag& tag = read_.tags[i];
      for (; !open.empty() && open.back() <= tag.tag.begin; open.pop_back()) symbols_.end();
      if (begin(tag)) open.push_back(tag.end);
    }
    for (; !open.empty(); open.pop_back()) symbols_.end();
  }

 private:
  Span span_of(TextRange range) const {
    return {source_, static_cast<std::uint32_t>(range.begin),
            static_cast<std::uint32_t>(range.end)};
  }

  /// False for a tag that is no symbol.
  bool begin(const XacroTag& tag) {
    constexpr int kModule = 2, kConstant = 14;
    const std::string_view element = tag.name.of(text_);
    const Span whole = span_of({tag.tag.begin, tag.end});
    const XacroAttribute* name = tag.find(text_, "name");
    if (element == "xacro:include") {
      const XacroAttribute* file = tag.find(text_, "filename");
      if (file == nullptr) return false;
      symbols_.begin(file->value.of(text_), kModule, whole, span_of(file->value), "include");
      return true;
    }
    const std::string_view called = called_macro(element);
    if (!called.empty()) {
      symbols_.begin(called, kEvent, whole, span_of(tag.name), "call");
      return true;
    }
    const bool is_of_robot = tag.parent == XacroTag::kNone || is_container(read_.tags[tag.parent]);
    if (name == nullptr || !is_of_robot) return false;
    if (element == "xacro:macro") {
      const XacroAttribute* params = tag.find(text_, "params");
      symbols_.begin(name->value.of(text_), kFunction, whole, span_of(name->value),
                     params != nullptr ? params->value.of(text_) : std::string_view());
    } else if (element == "xacro:property" || element == "xacro:arg") {
      const bool is_argument = element == "xacro:arg";
      symbols_.begin(name->value.of(text_), is_argument ? kConstant : kVariable, whole,
                     span_of(name->value), is_argument ? "argument" : "property");
    } else if (element == "link" || element == "joint") {
      symbols_.begin(name->value.of(text_), element == "link" ? kClass : kFunction, whole,
                     span_of(name->value), element);
    } else {
      return false;
    }
    return true;
  }

  /// Whether links may be in an element.
  bool is_container(const XacroTag& tag) const {
    const std::string_view name = tag.name.of(text_);
    return name == "robot" || name.starts_with("xacro:");
  }

  const XacroText& read_;
  std::string_view text_;
  SourceId source_;
  SymbolPrinter& symbols_;
};

}  // namespace

std::optional<std::string> xacro_symbols(Context& context, const Json& params) {
  const auto request = xacro_request(context, params);
  if (!request) return std::nullopt;
  const Positions positions(request->family->sources, context.client.encoding);
  SymbolPrinter symbols(positions, context.client.takes_deep_symbols,
                        context.workspace.uri_of(request->path));
  XacroOutline(*request, symbols).print();
  return symbols.take();
}

Json document_symbols(Context& context, const Json& params) {
  if (auto outline = xacro_symbols(context, params)) {
    return context.lists.add(*std::move(outline));
  }
  const std::string path = path_in(params);
  const Positions positions = loaded_positions(context);
  SymbolPrinter symbols(positions, context.client.takes_deep_symbols,
                        context.workspace.uri_of(path));
  for (const FileView& view : context.workspace.views(path)) {
    const bool is_robot = view.xml != nullptr && view.model != nullptr && view.model->robot &&
                          view.xml == &view.model->robot->document;
    if (is_robot) {
      RobotOutline(*view.model, symbols).print();
    } else if (view.yaml != nullptr) {
      print_sections(*view.yaml, symbols);
    } else {
      continue;
    }
    break;
  }
  return context.lists.add(symbols.take());
}

Json workspace_symbols(Context& context, const Json& params) {
  const std::string query = path::to_lower(text_at(params, {"query"}));
  const Workspace::Definitions found = context.workspace.definitions();
  const Positions positions(*found.sources, context.client.encoding);
  std::set<std::pair<std::string_view, std::uint32_t>> seen;
  std::set<Json> symbols;  // a model that a scene loads may be loaded alone as well
  for (const Workspace::Definition& one : found.list) {
    if (!holds_letters(one.name, query)) continue;
    // Each model that uses a file lists the names in it, so the file may come up several times.
    if (!seen.emplace(one.path, one.span.begin).second) continue;
    Json symbol = {
        {"name", one.name},
        {"kind", kind_of(one.kind)},
        {"containerName", to_string(one.kind)},
        {"location",
         {{"uri", context.workspace.uri_of(one.path)}, {"range", positions.range(one.span)}}}};
    symbols.insert(std::move(symbol));
    if (symbols.size() >= kMostSymbols) break;
  }
  return symbols;
}

}  // namespace smurf::lsp
