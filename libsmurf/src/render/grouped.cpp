// SPDX-License-Identifier: BSD-3-Clause
// Findings of one cause as one finding, in few lines: for converters, which report beside a result.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostListed = 3;
constexpr std::size_t kLongestName = 32;

std::size_t lines_of(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A message around its first name in backquotes: "the mesh `", "base.stl", "` is not in the SDF".
struct Parts {
  std::string_view before, name, after;
};
Parts parts_of(std::string_view message) {
  const std::size_t begin = message.find('`');
  const std::size_t end = begin == std::string_view::npos ? begin : message.find('`', begin + 1);
  if (end == std::string_view::npos) return {message, {}, {}};
  return {message.substr(0, begin + 1), message.substr(begin + 1, end - begin - 1),
          message.substr(end)};
}

/// "`a`, `b` and 10 more"; nothing if names are so long that they hide the message.
std::string list(const std::vector<std::string>& names) {
  std::vector<std::string_view> distinct;
  for (const std::string& name : names) {
    if (std::find(distinct.begin(), distinct.end(), name) == distinct.end()) {
      distinct.push_back(name);
    }
    if (distinct.size() > kMostListed) break;
  }
  const bool has_all = distinct.size() <= kMostListed && distinct.size() == names.size();
  const std::size_t shown = has_all ? distinct.size() : std::min(distinct.size(), kMostListed - 1);
  distinct.resize(shown);
  for (const std::string_view name : distinct) {
    if (name.empty() || name.size() > kLongestName) return {};
  }
  if (has_all) return enumerated(all_quoted(distinct));
  return listed(all_quoted(distinct)) + " and " + std::to_string(names.size() - shown) + " more";
}

/// "12 joints (`a`, `b` and 10 more) are fixed in the SDF" for "the joint `a` is fixed in the SDF".
/// None for a sentence of another form.
std::optional<std::string> in_plural(const Parts& parts, const std::vector<std::string>& names) {
  constexpr std::string_view kThe = "the ";
  if (!parts.before.starts_with(kThe) || !parts.before.ends_with(" `")) return std::nullopt;
  const std::string_view noun =
      parts.before.substr(kThe.size(), parts.before.size() - kThe.size() - 2);
  std::string_view verb = parts.after.substr(1);
  std::string_view plural;
  if (noun.empty() || noun.find(' ') != std::string_view::npos) return std::nullopt;
  if (verb.starts_with(" is ")) {
    verb.remove_prefix(4);
    plural = " are ";
  } else if (!verb.starts_with(" cannot ")) {
    return std::nullopt;
  }
  std::string rest(verb);
  constexpr std::string_view kFile = ": the file ";
  if (const std::size_t file = rest.find(kFile); file != std::string::npos) {
    rest.replace(file, kFile.size(), ": each file ");
  }
  const std::string listed = list(names);
  const std::string many = noun == "mesh" ? "meshes" : std::string(noun) + "s";
  return counted(names.size(), noun, many) + (listed.empty() ? "" : " (" + listed + ")") +
         std::string(plural) + rest;
}

/// Findings that differ in the first name of their message only.
struct Group {
  Diagnostic shown;
  std::vector<std::string> names;
};

Diagnostic title_of(const Group& group) {
  Diagnostic shown = group.shown;
  if (group.names.size() < 2) return shown;
  if (auto message = in_plural(parts_of(shown.message), group.names)) {
    shown.message = std::move(*message);
  } else {
    const std::vector<std::string> others(group.names.begin() + 1, group.names.end());
    const std::string listed = list(others);
    shown.notes.push_back(counted(others.size(), "more finding") + " like this one" +
                          (listed.empty() ? "" : ": " + listed));
  }
  shown.labels.clear();
  return shown;
}

std::vector<Group> groups_of(std::span<const Diagnostic> diagnostics) {
  using Key = std::tuple<const Rule*, Severity, std::string, std::string, std::string>;
  std::map<Key, std::size_t> index;
  std::vector<Group> groups;
  for (const Diagnostic& one : diagnostics) {
    const Parts parts = parts_of(one.message);
    Key key{one.rule, one.severity, std::string(parts.before), std::string(parts.after),
            one.help_text};
    const auto [place, is_new] = index.try_emplace(std::move(key), groups.size());
    if (is_new) groups.push_back({one, {}});
    groups[place->second].names.emplace_back(parts.name);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.shown.severity > b.shown.severity;
  });
  return groups;
}

}  // namespace

GroupedFindings render_grouped(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                               std::size_t most_lines, const TextStyle& style) {
  const std::vector<Group> groups = groups_of(diagnostics);
  std::vector<std::string> full, brief;
  std::set<std::pair<const Rule*, std::string>> helped;
  std::size_t all = 0;
  for (const Group& group : groups) {
    const Diagnostic shown = title_of(group);
    full.push_back(render_full(shown, sources, style));
    const bool has_help = helped.insert({shown.rule, shown.help_text}).second;
    brief.push_back(render_brief(shown, sources, has_help, style));
    all += lines_of(full.back());
  }
  GroupedFindings result;
  result.is_complete = groups.size() == diagnostics.size();
  if (all <= most_lines) {
    for (const std::string& one : full) result.text += one;
    return result;
  }
  constexpr std::size_t kRest = 2;  // the line about the rest, and an empty one
  std::size_t lines = kRest;
  std::size_t next = 0;
  for (; next < groups.size(); ++next) {
    lines += lines_of(brief[next]);
    if (next > 0 && lines > most_lines) break;
    result.text += brief[next];
  }
  std::size_t left = 0;
  for (std::size_t i = next; i < groups.size(); ++i) left += groups[i].names.size();
  if (left > 0) {
    result.text += "... and " + counted(left, "finding") + " of " +
                   counted(groups.size() - next, "other kind") + "\n";
    result.is_complete = false;
  }
  result.text += "\n";
  return result;
}

}  // namespace smurf
