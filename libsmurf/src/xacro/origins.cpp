// SPDX-License-Identifier: BSD-3-Clause
// From a part of the result back to the place where it was written, and the calls around it.
#include <algorithm>

#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"

namespace smurf::xacro {

Origin Expansion::origin_of(Span part) const {
  const auto after =
      std::upper_bound(leaves.begin(), leaves.end(), part.begin,
                       [](std::uint32_t at, const Leaf& leaf) { return at < leaf.begin; });
  if (after == leaves.begin()) return {{root, 0, 0}, false, FrameId{0}, {}};
  const Leaf& leaf = *std::prev(after);
  Origin origin;
  origin.frame = leaf.frame;
  const bool is_inside = part.end <= leaf.end;
  if (leaf.kind == Leaf::Kind::tag || leaf.kind == Leaf::Kind::end_tag) {
    if (is_inside) {
      const bool is_name = part.begin > leaf.begin || leaf.kind == Leaf::Kind::end_tag;
      origin.span = is_name ? leaf.origin : leaf.use;
    } else {
      // Of a tag, or of the whole element: the next tag decides.
      const auto next = std::find_if(after, leaves.end(), [](const Leaf& one) {
        return one.kind != Leaf::Kind::attribute && one.kind != Leaf::Kind::value;
      });
      const bool is_tag = next == leaves.end() || next->begin >= part.end;
      origin.span = is_tag ? leaf.use : leaf.whole;
    }
    return origin;
  }
  if (is_inside && (part.begin < leaf.end || part.begin == part.end)) {
    origin.is_exact = leaf.is_exact;
    origin.span = leaf.origin;
    for (std::uint32_t i = 0; i < leaf.inputs; ++i)
      origin.inputs.push_back(inputs[leaf.first_input + i]);
    if (!leaf.is_exact) return origin;
    origin.span.begin = leaf.origin.begin + (part.begin - leaf.begin);
    origin.span.end = leaf.origin.begin + (part.end - leaf.begin);
    return origin;
  }
  if (leaf.kind == Leaf::Kind::attribute) {
    origin.span = leaf.whole;
    return origin;
  }
  // Several parts of one text: where they are used.
  origin.span = leaf.use;
  for (auto next = after; next != leaves.end() && next->begin < part.end; ++next) {
    if (next->use.source != origin.span.source || next->kind != leaf.kind) continue;
    origin.span.begin = std::min(origin.span.begin, next->use.begin);
    origin.span.end = std::max(origin.span.end, next->use.end);
  }
  return origin;
}

std::vector<Copied> Expansion::copied_in(Span part) const {
  std::vector<Copied> copied;
  auto leaf = std::partition_point(leaves.begin(), leaves.end(),
                                   [&](const Leaf& one) { return one.end <= part.begin; });
  for (; leaf != leaves.end() && leaf->begin < part.end; ++leaf) {
    if (!leaf->is_exact || leaf->begin == leaf->end) continue;
    const std::uint32_t begin = std::max(leaf->begin, part.begin);
    const std::uint32_t end = std::min(leaf->end, part.end);
    const std::uint32_t at = leaf->origin.begin + (begin - leaf->begin);
    copied.push_back({begin, end, {leaf->origin.source, at, at + (end - begin)}});
  }
  return copied;
}

void Expander::add_frames(Diagnostic& diagnostic) const {
  constexpr int kMost = 10;
  int count = 0;
  for (FrameId at = frame_; at != kNoFrame && count < kMost;
       at = result_.frame(at).parent, ++count) {
    const Frame& frame = result_.frame(at);
    if (frame.kind == Frame::Kind::root || frame.call.empty()) continue;
    const bool is_known = std::any_of(diagnostic.labels.begin(), diagnostic.labels.end(),
                                      [&](const Label& one) { return one.span == frame.call; });
    if (is_known) continue;  // of a recursion
    diagnostic.label(frame.call, label_of(frame));
  }
}

std::string label_of(const Frame& frame) {
  if (frame.kind == Frame::Kind::include) return "in " + quoted(frame.name) + ", included here";
  return "in " + quoted(frame.name) + ", called here" +
         (frame.parameters.empty() ? "" : " with " + frame.parameters);
}

}  // namespace smurf::xacro
