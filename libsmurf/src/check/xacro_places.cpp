// SPDX-License-Identifier: BSD-3-Clause
#include "check/xacro_places.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"

namespace smurf {
namespace {

/// The calls and includes around a part of the result, the innermost first.
std::vector<const xacro::Frame*> frames_around(const xacro::Expansion& expansion,
                                               xacro::FrameId at) {
  std::vector<const xacro::Frame*> frames;
  while (at != xacro::kNoFrame) {
    const xacro::Frame& frame = expansion.frame(at);
    if (!frame.call.empty()) frames.push_back(&frame);
    at = frame.parent;
  }
  return frames;
}

void add_labels(const xacro::Expansion& expansion, const xacro::Origin& origin,
                Diagnostic& diagnostic) {
  constexpr std::size_t kMostFrames = 8;
  for (const xacro::Input& input : origin.inputs) {
    if (input.place.empty() || input.place == origin.span) continue;
    diagnostic.label(input.place, quoted(input.name) + " comes from here");
  }
  const auto frames = frames_around(expansion, origin.frame);
  for (std::size_t i = 0; i < std::min(frames.size(), kMostFrames); ++i) {
    diagnostic.label(frames[i]->call, xacro::label_of(*frames[i]));
  }
}

/// The fix with its bytes in the xacro files; false if one of them was computed.
bool place(const xacro::Expansion& expansion, Fix& fix) {
  if (fix.new_name && fix.new_name->among.source == expansion.source) return false;
  for (Edit& edit : fix.edits) {
    if (edit.span.source != expansion.source) continue;
    const xacro::Origin origin = expansion.origin_of(edit.span);
    if (!origin.is_exact || edit.span.empty()) return false;
    // In a macro, an expression would be read where a text is meant.
    if (edit.text.find_first_of("$&<\"'") != std::string::npos) return false;
    edit.span = origin.span;
  }
  return true;
}

/// Moves a finding from the expansion to its place in the xacro files. Returns the span of the
/// innermost macro call around that place; empty if there is none.
Span move_to_xacro(const xacro::Expansion& expansion, Diagnostic& diagnostic) {
  const xacro::Origin origin = expansion.origin_of(diagnostic.span);
  diagnostic.span = origin.span;
  for (Label& label : diagnostic.labels) {
    if (label.span.source == expansion.source) label.span = expansion.origin_of(label.span).span;
  }
  std::erase_if(diagnostic.fixes, [&](Fix& fix) { return !place(expansion, fix); });
  add_labels(expansion, origin, diagnostic);
  const auto frames = frames_around(expansion, origin.frame);
  return frames.empty() ? Span{} : frames.front()->call;
}

std::string text_of(const SourceMap& sources, Span call) {
  return sources.path(call.source) + ":" + std::to_string(sources.line_of(call.source, call.begin));
}

/// "also in 3 other calls: base.xacro:41, base.xacro:42, ..."
std::string other_calls(const SourceMap& sources, std::size_t count,
                        const std::vector<Span>& calls) {
  constexpr std::size_t kMost = 5;
  std::string text = "also in " + counted(count, "other place") + " of the robot";
  for (std::size_t i = 0; i < std::min(calls.size(), kMost); ++i) {
    text += (i == 0 ? ", from calls at " : ", ") + text_of(sources, calls[i]);
  }
  return calls.size() > kMost ? text + ", ..." : text;
}

bool is_same_fix(const Diagnostic& a, const Diagnostic& b) {
  if (a.fixes.size() != b.fixes.size()) return false;
  for (std::size_t i = 0; i < a.fixes.size(); ++i) {
    const auto& [left, right] = std::tie(a.fixes[i].edits, b.fixes[i].edits);
    const bool is_same = std::equal(
        left.begin(), left.end(), right.begin(), right.end(),
        [](const Edit& x, const Edit& y) { return x.span == y.span && x.text == y.text; });
    if (!is_same) return false;
  }
  return true;
}

}  // namespace

void place_in_xacro(const xacro::Expansions& expansions, const SourceMap& sources,
                    std::vector<Diagnostic>& found) {
  if (expansions.empty()) return;
  struct Cause {
    std::size_t first = 0;
    std::size_t others = 0;
    Span call;
    std::vector<Span> calls;
  };
  using Key = std::tuple<const Rule*, SourceId, std::uint32_t, std::uint32_t>;
  std::map<Key, Cause> causes;
  std::vector<Diagnostic> kept;
  for (Diagnostic& diagnostic : found) {
    const auto expansion = expansions.find(diagnostic.span.source);
    if (expansion == expansions.end()) {
      kept.push_back(std::move(diagnostic));
      continue;
    }
    const Span call = move_to_xacro(expansion->second, diagnostic);
    const Span span = diagnostic.span;
    const auto [place, is_new] =
        causes.try_emplace({diagnostic.rule, span.source, span.begin, span.end});
    Cause& cause = place->second;
    if (is_new) {
      cause.first = kept.size();
      cause.call = call;
      kept.push_back(std::move(diagnostic));
      continue;
    }
    ++cause.others;
    Diagnostic& first = kept[cause.first];
    first.severity = std::max(first.severity, diagnostic.severity);
    if (!is_same_fix(first, diagnostic)) first.fixes.clear();
    const bool is_known =
        call.empty() || call == cause.call ||
        std::find(cause.calls.begin(), cause.calls.end(), call) != cause.calls.end();
    if (!is_known) cause.calls.push_back(call);
  }
  for (const auto& [key, cause] : causes) {
    if (cause.others > 0) kept[cause.first].note(other_calls(sources, cause.others, cause.calls));
  }
  found = std::move(kept);
}

void join_roots(const SourceMap& sources, std::vector<Diagnostic>& found) {
  using Key = std::tuple<const Rule*, SourceId, std::uint32_t, std::uint32_t>;
  std::set<Key> known;
  std::erase_if(found, [&](const Diagnostic& one) {
    if (!xacro::is_xacro_file(sources.path(one.span.source))) return false;
    return !known.insert({one.rule, one.span.source, one.span.begin, one.span.end}).second;
  });
}

}  // namespace smurf
