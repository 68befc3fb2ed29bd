// SPDX-License-Identifier: BSD-3-Clause
// Hover in a xacro: what a name is, and which values an expression has in which call.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/xacro.hpp"

namespace smurf::lsp {
namespace {

std::string place_of(const SourceMap& sources, Span span) {
  return std::string(path::file_name(sources.path(span.source))) + ":" +
         std::to_string(sources.line_of(span.source, span.begin));
}

std::string said_of(const XacroFamily& family, const XacroMeaning::Definition& definition) {
  const XacroName& name = *definition.name;
  const Span span{definition.file->source, static_cast<std::uint32_t>(name.place.begin),
                  static_cast<std::uint32_t>(name.place.end)};
  const std::string where = ", defined in " + place_of(family.sources, span);
  const std::string value = name.has_value ? smurf::quoted(name.value) : std::string();
  switch (name.kind) {
  case XacroNameKind::macro:
    return "macro " + smurf::quoted(name.name) +
           (name.value.empty() ? " without parameters" : ": " + smurf::quoted(name.value)) + where;
  case XacroNameKind::parameter:
    return "parameter " + smurf::quoted(name.name) +
           (value.empty() ? "" : ", by default " + value) + where;
  case XacroNameKind::block: return "block " + smurf::quoted(name.name) + where;
  case XacroNameKind::property:
    return "property " + smurf::quoted(name.name) + (value.empty() ? "" : " = " + value) + where;
  case XacroNameKind::argument:
    return "argument " + smurf::quoted(name.name) + (value.empty() ? "" : ", by default " + value) +
           where;
  }
  return {};
}

/// A value with the call in which it is computed, each once.
class Values {
 public:
  Values(Context& context, const XacroRequest& request, TextRange part)
      : sources_(context.workspace.loaded_sources()), part_(part) {
    for (const Workspace::Expanded& one : context.workspace.expansions_of(request.path)) add(one);
  }

  std::vector<std::string> lines() const {
    constexpr std::size_t kMost = 8;
    std::vector<std::string> shown(lines_.begin(),
                                   lines_.begin() +
                                       static_cast<std::ptrdiff_t>(std::min(kMost, lines_.size())));
    if (lines_.size() > kMost) {
      shown.push_back("and " + counted(lines_.size() - kMost, "more value"));
    }
    return shown;
  }

 private:
  void add(const Workspace::Expanded& expanded) {
    const xacro::Expansion& expansion = *expanded.expansion;
    const std::string_view text = sources_.text(expansion.source);
    for (const xacro::Leaf& leaf : expansion.leaves) {
      const bool is_value =
          leaf.kind == xacro::Leaf::Kind::value || leaf.kind == xacro::Leaf::Kind::text;
      if (!is_value || leaf.use.begin > part_.begin || leaf.use.end < part_.end) continue;
      if (!expanded.sources.contains(leaf.use.source)) continue;
      std::string line = smurf::quoted(text.substr(leaf.begin, leaf.end - leaf.begin));
      line += " " + call_of(expansion, leaf.frame);
      if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) {
        lines_.push_back(std::move(line));
      }
      if (lines_.size() >= kMostValues) return;
    }
  }

  std::string call_of(const xacro::Expansion& expansion, xacro::FrameId at) const {
    for (; at != xacro::kNoFrame; at = expansion.frame(at).parent) {
      const xacro::Frame& frame = expansion.frame(at);
      if (frame.kind != xacro::Frame::Kind::macro) continue;
      return "in " + smurf::quoted(frame.name) + ", called at " + place_of(sources_, frame.call) +
             (frame.parameters.empty() ? "" : " with " + smurf::quoted(frame.parameters));
    }
    return "in " + std::string(path::file_name(sources_.path(expansion.root)));
  }

  static constexpr std::size_t kMostValues = 1000;

  const SourceMap& sources_;
  TextRange part_;
  std::vector<std::string> lines_;
};

}  // namespace

Json xacro_hover(Context& context, const Json& params) {
  const auto request = xacro_request(context, params);
  if (!request) return nullptr;
  const auto meaning = xacro_meaning(*request->family, request->offset);
  const XacroExpression around = xacro_expression_at(request->text(), request->offset);
  std::vector<std::string> lines;
  TextRange shown;
  if (around.kind != '\0') {
    shown = around.whole;
    lines = Values(context, *request, around.whole).lines();
  }
  if (meaning) {
    shown = meaning->at;
    constexpr std::size_t kMostDefinitions = 5;
    for (const auto& one : meaning->definitions) {
      if (lines.size() >= 2 * kMostDefinitions) break;
      lines.push_back(said_of(*request->family, one));
    }
  }
  if (lines.empty()) return nullptr;
  const Json range = at(to_json(*request->family, {&request->own(), shown}, context), {"range"});
  return {{"contents", markdown(lines)}, {"range", range}};
}

}  // namespace smurf::lsp
