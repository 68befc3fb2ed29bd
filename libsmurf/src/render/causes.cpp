// SPDX-License-Identifier: BSD-3-Clause
#include "render/causes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"

namespace smurf::render {
namespace {

/// Fewer findings are shown one by one.
constexpr std::size_t kFewest = 3;

/// The place where the meant thing is defined, and the name that the finding is about.
using Cause = std::tuple<SourceId, std::uint32_t, std::string_view>;

struct Group {
  Span definition;
  std::vector<const Diagnostic*> findings;
};

std::string place_text(Span place, const SourceMap& sources) {
  return sources.path(place.source) + ":" +
         std::to_string(sources.line_of(place.source, place.begin));
}

/// The finding whose fix writes the name of a known thing; null for others.
const Edit* correction(const Diagnostic& finding) {
  const bool is_unknown_name = finding.caret.starts_with("no such ") && !finding.labels.empty();
  if (!is_unknown_name || finding.fixes.size() != 1) return nullptr;
  const std::vector<Edit>& edits = finding.fixes.front().edits;
  return edits.size() == 1 ? &edits.front() : nullptr;
}

Diagnostic speak_for(const Group& group, std::string_view name, const SourceMap& sources) {
  Diagnostic spokesman = *group.findings.front();
  std::set<SourceId> files;
  for (std::size_t i = 1; i < group.findings.size(); ++i) {
    files.insert(group.findings[i]->span.source);
  }
  spokesman.note(counted(group.findings.size() - 1, "more finding") + " in " +
                 counted(files.size(), "file") + " " +
                 (group.findings.size() == 2 ? "has" : "have") +
                 " this cause: `--all` shows where else " + quoted(name) + " is named");
  spokesman.help_text += " Or was it renamed by mistake? Then write " + quoted(name) + " at " +
                         place_text(group.definition, sources);
  return spokesman;
}

}  // namespace

Causes::Causes(std::span<const Diagnostic> diagnostics, const SourceMap& sources) {
  std::map<Cause, Group> groups;
  for (const Diagnostic& one : diagnostics) {
    const Edit* edit = correction(one);
    if (edit == nullptr) continue;
    const Span definition = one.labels.back().span;
    const std::string_view name = sources.text(edit->span);
    Group& group = groups[{definition.source, definition.begin, name}];
    group.definition = definition;
    group.findings.push_back(&one);
  }
  for (auto& [cause, group] : groups) {
    if (group.findings.size() < kFewest) continue;
    std::stable_sort(
        group.findings.begin(), group.findings.end(),
        [](const Diagnostic* a, const Diagnostic* b) { return a->severity > b->severity; });
    spokesmen_.push_back(speak_for(group, std::get<2>(cause), sources));
    for (const Diagnostic* one : group.findings) shown_[one] = nullptr;
    shown_[group.findings.front()] = &spokesmen_.back();
  }
}

const Diagnostic* Causes::shown(const Diagnostic& finding) const {
  const auto found = shown_.find(&finding);
  return found == shown_.end() ? &finding : found->second;
}

}  // namespace smurf::render
