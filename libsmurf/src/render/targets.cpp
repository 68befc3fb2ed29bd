// SPDX-License-Identifier: BSD-3-Clause
// What becomes of the files in each target, for people.
#include <algorithm>

#include "render/paint.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::Ink;
using render::Painter;

constexpr std::size_t kColumns = 80;

std::string verdict_of(const TargetVerdict& target, const Painter& paint) {
  if (target.refusals > 0) {
    return paint(Ink::error, "refuses it (" + std::to_string(target.refusals) + ")");
  }
  if (target.losses > 0) {
    return paint(Ink::warning, "takes it with losses (" + std::to_string(target.losses) + ")");
  }
  return "takes it";
}

std::string reason_of(const TargetVerdict& target, const SourceMap& sources) {
  std::string place;
  const Span span = target.first->span;
  if (static_cast<std::size_t>(span.source) < sources.size()) {
    const auto size = static_cast<std::uint32_t>(sources.text(span.source).size());
    const Position at = sources.position(span.source, std::min(span.begin, size));
    place = render::escape(sources.path(span.source)) + ":" + std::to_string(at.line) + ":" +
            std::to_string(at.column) + ": ";
  }
  return place + std::string(target.fact->makes) + " (" + std::string(target.first->rule->id) + ")";
}

}  // namespace

std::string render_targets(std::span<const TargetVerdict> targets, const SourceMap& sources,
                           const TextStyle& style) {
  const Painter paint(style.color);
  std::size_t indent = 0;
  for (const TargetVerdict& target : targets) {
    indent = std::max(indent, target.reader->name.size() + 2);
  }
  std::string out;
  for (const TargetVerdict& target : targets) {
    const std::string_view name = target.reader->name;
    out += paint(Ink::strong, name) + std::string(indent - name.size(), ' ') +
           verdict_of(target, paint) + "\n";
    if (target.first != nullptr) out += render::wrap(reason_of(target, sources), indent, kColumns);
  }
  return out;
}

}  // namespace smurf
