// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/text/edits.hpp"
#include "smurf/fix.hpp"

namespace smurf {
namespace {

/// The edits of one file that do not conflict with each other.
class FileEdits {
 public:
  bool contains(const Edit& edit) const {
    const auto [first, last] = range(edit.span);
    return std::any_of(first, last, [&](const auto& one) {
      return one.second.span.begin == edit.span.begin && one.second.span.end == edit.span.end &&
             one.second.text == edit.text;
    });
  }

  /// Edits that touch also conflict, because the order of two insertions would be arbitrary.
  /// Deletions may touch.
  bool is_free(const Edit& edit) const {
    const auto [first, last] = range(edit.span);
    return std::all_of(first, last, [&](const auto& one) {
      const Span taken = one.second.span;
      const bool do_meet = taken.end == edit.span.begin || edit.span.end == taken.begin;
      return do_meet && is_deletion(edit) && is_deletion(one.second);
    });
  }

  void add(const Edit& edit) { edits_.emplace(edit.span.begin, edit); }

  std::vector<Edit> list() const {
    std::vector<Edit> edits;
    for (const auto& [begin, edit] : edits_) edits.push_back(edit);
    return edits;
  }

 private:
  using Map = std::multimap<std::uint32_t, Edit>;

  static bool is_deletion(const Edit& edit) { return edit.text.empty() && !edit.span.empty(); }

  /// The accepted edits that overlap or touch the span; accepted edits are disjoint, so there are
  /// at most a few.
  std::pair<Map::const_iterator, Map::const_iterator> range(Span span) const {
    auto first = edits_.upper_bound(span.begin);
    while (first != edits_.begin() && std::prev(first)->second.span.end >= span.begin) --first;
    return {first, edits_.upper_bound(span.end)};
  }

  Map edits_;
};

const Fix* applicable(const Diagnostic& diagnostic, Applicability most) {
  for (const Fix& fix : diagnostic.fixes) {
    if (fix.edits.empty()) continue;
    if (fix.applicability == Applicability::safe || most == Applicability::unsafe) return &fix;
  }
  return nullptr;
}

using NewNameKey = std::tuple<std::string, std::uint32_t, std::string>;

NewNameKey key_of(const Fix::NewName& new_name, const SourceMap& sources) {
  return {sources.path(new_name.among.source), new_name.among.begin, new_name.name};
}

}  // namespace

AppliedFixes apply_fixes(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         Applicability most) {
  // By path: two models that share a file have read it twice.
  std::map<std::string, std::pair<SourceId, FileEdits>> files;
  const auto file_of = [&](const Edit& edit) -> FileEdits& {
    const SourceId source = edit.span.source;
    return files.try_emplace(sources.path(source), source, FileEdits{}).first->second.second;
  };
  AppliedFixes applied;
  std::set<NewNameKey> new_names;
  for (const Diagnostic& diagnostic : diagnostics) {
    const Fix* fix = applicable(diagnostic, most);
    if (fix == nullptr) continue;
    const auto is_done = [&](const Edit& edit) { return file_of(edit).contains(edit); };
    if (std::all_of(fix->edits.begin(), fix->edits.end(), is_done)) {
      ++applied.count;
      continue;
    }
    const auto is_free = [&](const Edit& edit) { return file_of(edit).is_free(edit); };
    if (!std::all_of(fix->edits.begin(), fix->edits.end(), is_free)) continue;
    if (fix->new_name && !new_names.insert(key_of(*fix->new_name, sources)).second) continue;
    for (const Edit& edit : fix->edits) file_of(edit).add(edit);
    ++applied.count;
  }
  for (const auto& [path, file] : files) {
    const std::string_view before = sources.text(file.first);
    const std::vector<Edit> edits = file.second.list();
    std::string after = apply_edits(before, edits);
    if (after == before) continue;
    applied.texts.push_back({path, std::move(after)});
    applied.edits.insert(applied.edits.end(), edits.begin(), edits.end());
  }
  return applied;
}

}  // namespace smurf
