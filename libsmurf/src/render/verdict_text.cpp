// SPDX-License-Identifier: BSD-3-Clause
// Prints the effects of findings on each target as text.
#include "render/verdict_text.hpp"

#include <algorithm>

#include "base/text/counted.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::Ink;
using render::Painter;

/// The count " (2)", with the number of suppressed findings: " (2, 1 in the baseline)".
std::string count_of(const TargetVerdict& target) {
  const std::size_t count = target.count(target.answer());
  std::string text = " (" + std::to_string(count);
  const auto add = [&](std::size_t some, std::string_view where) {
    if (some == 0) return;
    text += some == count ? ", " : ", " + std::to_string(some) + " ";
    text += where;
  };
  add(target.ignored, "ignored by a comment");
  add(target.in_baseline, "in the baseline");
  return text + ")";
}

/// The worst effect of the files on the reader.
std::string reason_of(const TargetVerdict& target, const SourceMap& sources) {
  std::string place;
  const Span span = target.span;
  if (static_cast<std::size_t>(span.source) < sources.size()) {
    const auto size = static_cast<std::uint32_t>(sources.text(span.source).size());
    const Position at = sources.position(span.source, std::min(span.begin, size));
    place = render::escape(sources.path(span.source)) + ":" + std::to_string(at.line) + ":" +
            std::to_string(at.column) + ": ";
  }
  return place + std::string(target.fact->makes) + " (" + std::string(target.rule->id) + ")";
}

}  // namespace

std::string render::verdict_of(const TargetVerdict& target, const Painter& paint) {
  switch (target.answer()) {
  case Answer::takes: return "loads";
  case Answer::loses: return paint(Ink::warning, "loads, with losses" + count_of(target));
  case Answer::refuses: return paint(Ink::error, "fails to load" + count_of(target));
  case Answer::unknown: break;
  }
  constexpr std::size_t kMostRules = 2;  // a line has 80 columns
  std::string rules;
  const std::size_t all = target.unknown_rules.size();
  for (std::size_t i = 0; i < std::min(all, kMostRules); ++i) {
    const Rule& rule = *target.unknown_rules[i];
    rules.append(i == 0 ? ": " : ", ").append(rule.id).append(" ").append(rule.name);
  }
  if (all > kMostRules) rules += " and " + counted(all - kMostRules, "more rule");
  return paint(Ink::warning, "not known" + count_of(target)) + rules;
}

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
           render::verdict_of(target, paint) + "\n";
    if (target.fact != nullptr) {
      const std::string_view besides = target.answer() == Answer::unknown ? "besides, " : "";
      out +=
          render::wrap(std::string(besides) + reason_of(target, sources), indent, render::kColumns);
    }
    for (const TargetVerdict* other : {find_earlier_release(target), find_other_release(target)}) {
      if (other == nullptr) continue;
      out += std::string(indent, ' ') + std::string(target.reader->releases.front()->name) +
             " is meant; " + std::string(other->reader->name) + ": " +
             render::verdict_of(*other, paint) + "\n";
    }
  }
  return out;
}

}  // namespace smurf
