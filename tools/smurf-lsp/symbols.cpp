// SPDX-License-Identifier: BSD-3-Clause
// Outlines: links and joints as a tree, sections with their entries, entities of scenes.
#include <algorithm>
#include <set>

#include "base/path.hpp"
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

// SymbolKind of the protocol.
constexpr int kNamespace = 3, kClass = 5, kProperty = 7, kField = 8, kFunction = 12, kVariable = 13,
              kObject = 19, kEvent = 24;
/// Clients and JSON libraries fail at chains of thousands of links.
constexpr int kDeepest = 40;
/// More results would not be read; a longer query finds fewer.
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

Json symbol(const Positions& positions, std::string_view name, int kind, Span whole, Span named) {
  const bool is_inside = whole.begin <= named.begin && named.end <= whole.end;
  return {{"name", name.empty() ? "?" : std::string(name)},
          {"kind", kind},
          {"range", positions.range(whole)},
          {"selectionRange", positions.range(is_inside ? named : whole)},
          {"children", Json::array()}};
}

class RobotOutline {
 public:
  RobotOutline(const LinkedModel& model, const Positions& positions)
      : model_(model), positions_(positions) {}

  Json run() {
    Json roots = Json::array();
    for (const LinkIndex root : model_.tree.roots) add(root, 0, roots);
    // Links that no root reaches are in a loop.
    for (std::size_t i = 0; i < model_.robot->links.size(); ++i) {
      const LinkIndex link{static_cast<std::uint32_t>(i)};
      if (!seen(link)) add(link, kDeepest, roots);
    }
    return roots;
  }

 private:
  bool seen(LinkIndex link) {
    seen_.resize(model_.robot->links.size());
    return seen_[to_size(link)];
  }

  void add(LinkIndex index, int depth, Json& to) {
    if (seen(index)) return;
    seen_[to_size(index)] = true;
    const urdf::Link& link = model_.link(index);
    Json one = symbol(positions_, link.name.value_or({}), kClass, link.span, link.name.span);
    one["detail"] = "link";
    // Deeper links become siblings of their parents.
    std::vector<Json> beside;
    for (const JointIndex joint : model_.tree.child_joints[to_size(index)]) {
      Json below = joint_symbol(joint);
      const auto child = model_.tree.joint_child[to_size(joint)];
      if (depth < kDeepest && child) add(*child, depth + 2, below["children"]);
      one["children"].push_back(std::move(below));
    }
    to.push_back(std::move(one));
  }

  Json joint_symbol(JointIndex index) const {
    const urdf::Joint& joint = model_.joint(index);
    Json one = symbol(positions_, joint.name.value_or({}), kFunction, joint.span, joint.name.span);
    one["detail"] = "joint " + joint.type_name.value_or({});
    return one;
  }

  const LinkedModel& model_;
  const Positions& positions_;
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

Json yaml_outline(const yaml::Document& document, const Positions& positions) {
  Json symbols = Json::array();
  const yaml::View root = document.view();
  if (!root || !root.is_mapping()) return symbols;
  for (const yaml::View section : root) {
    Json one = symbol(positions, section.key(), kNamespace, whole_of(section), section.key_span());
    if (section.is_sequence() || section.is_mapping()) {
      for (const yaml::View entry : section) {
        const auto [name, place] = name_of(entry);
        one["children"].push_back(symbol(positions, name, kObject, whole_of(entry), place));
      }
    }
    symbols.push_back(std::move(one));
  }
  return symbols;
}

/// A flat list, for clients without support for trees.
void flatten(const Json& symbols, const std::string& uri, const std::string& container,
             Json& flat) {
  for (const Json& one : symbols) {
    Json info = {{"name", one["name"]},
                 {"kind", one["kind"]},
                 {"location", {{"uri", uri}, {"range", one["selectionRange"]}}}};
    if (!container.empty()) info["containerName"] = container;
    flat.push_back(std::move(info));
    flatten(one["children"], uri, one["name"].get<std::string>(), flat);
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

Json document_symbols(Context& context, const Json& params) {
  const std::string path = path_in(params);
  const Positions positions = loaded_positions(context);
  for (const FileView& view : context.workspace.views(path)) {
    Json symbols = Json::array();
    const bool is_robot = view.xml != nullptr && view.model != nullptr && view.model->robot &&
                          view.xml == &view.model->robot->document;
    if (is_robot) {
      symbols = RobotOutline(*view.model, positions).run();
    } else if (view.yaml != nullptr) {
      symbols = yaml_outline(*view.yaml, positions);
    } else {
      continue;
    }
    if (context.client.takes_deep_symbols) return symbols;
    Json flat = Json::array();
    flatten(symbols, context.workspace.uri_of(path), {}, flat);
    return flat;
  }
  return Json::array();
}

Json workspace_symbols(Context& context, const Json& params) {
  const std::string query = path::to_lower(text_at(params, {"query"}));
  const Workspace::Definitions found = context.workspace.definitions();
  const Positions positions(*found.sources, context.client.encoding);
  std::set<std::pair<std::string_view, std::uint32_t>> seen;
  std::set<Json> symbols;  // a model that a scene loads may be loaded alone as well
  for (const Workspace::Definition& one : found.list) {
    if (!holds_letters(one.name, query)) continue;
    // Each model that shares a file has the names in it.
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
