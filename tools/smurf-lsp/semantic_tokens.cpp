// SPDX-License-Identifier: BSD-3-Clause
// Semantic tokens: names, by the kind of the named thing.
#include <algorithm>
#include <map>

#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

constexpr const char* kTypes[] = {"class",    "function",   "event",     "parameter",
                                  "property", "enumMember", "namespace", "variable"};
constexpr std::uint32_t kDeclaration = 1;  // bit of the modifier

std::uint32_t type_of(NameKind kind) {
  switch (kind) {
  case NameKind::link: return 0;
  case NameKind::joint: return 1;
  case NameKind::motor: return 2;
  case NameKind::sensor: return 3;
  case NameKind::visual:
  case NameKind::collision: return 4;
  case NameKind::material: return 5;
  case NameKind::entity: return 6;
  default: return 7;
  }
}

}  // namespace

Json token_legend() {
  Json types = Json::array();
  for (const char* type : kTypes) types.push_back(type);
  return {{"tokenTypes", std::move(types)}, {"tokenModifiers", {"declaration"}}};
}

Json semantic_tokens(Context& context, const Json& params) {
  const SourceMap& sources = context.workspace.loaded_sources();
  std::map<std::uint32_t, const Reference*> names;  // by place
  SourceId source{};
  for (const FileView& view : context.workspace.views(path_in(params))) {
    if (names.empty()) source = view.source;
    for (const Reference& one : context.workspace.names().names()[view.part]) {
      if (one.span.source == view.source && one.is_known()) {
        names.try_emplace(one.span.begin, &one);
      }
    }
  }
  const Positions positions = loaded_positions(context);
  const Json& range = at(params, {"range"});
  const std::uint32_t first =
      names.empty() || !range.is_object() ? 0 : positions.offset(source, at(range, {"start"}));
  const std::uint32_t last = names.empty() || !range.is_object()
                                 ? 0xffffffffU
                                 : positions.offset(source, at(range, {"end"}));
  std::string data = "[";  // as text: a name may have hundreds of thousands of uses
  std::uint32_t line = 0;
  std::uint32_t column = 0;
  for (const auto& [begin, name] : names) {
    const std::string_view text = sources.text(name->span);
    if (begin < first || begin > last || text.find('\n') != std::string_view::npos) continue;
    const Json start = positions.position(name->span.source, begin);
    const auto at_line = start["line"].get<std::uint32_t>();
    const auto at_column = start["character"].get<std::uint32_t>();
    const std::uint32_t from = at_line == line ? column : 0;
    if (at_line == line && at_column < column) continue;
    for (const std::uint32_t number :
         {at_line - line, at_column - from, units_in(text, context.client.encoding),
          type_of(name->kind), name->is_definition ? kDeclaration : 0U}) {
      data += (data.size() > 1 ? "," : "") + std::to_string(number);
    }
    line = at_line;
    column = at_column;
  }
  return {{"data", context.lists.add(data += ']')}};
}

}  // namespace smurf::lsp
