// SPDX-License-Identifier: BSD-3-Clause
// Merges the reports of a check that was split over several machines.
#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

#include "render/json_text.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::dump;
using render::Json;
using render::text;

using Order = std::tuple<std::string, std::uint64_t, std::uint64_t, std::string, std::string>;

Order order_of(const Json& diagnostic) {
  return {diagnostic.at("file"), diagnostic.at("line"), diagnostic.at("column"),
          diagnostic.at("id"), diagnostic.at("message")};
}

/// Reports may come from anywhere, so a sum that is too large stays at the largest number.
std::uint64_t sum(const Json& a, const Json& b) {
  const auto first = a.get<std::uint64_t>();
  const auto second = b.get<std::uint64_t>();
  return second > UINT64_MAX - first ? UINT64_MAX : first + second;
}

/// The position of a word in a list from best to worst.
template <std::size_t N>
std::ptrdiff_t rank(const std::array<std::string_view, N>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) - words.begin();
}

std::ptrdiff_t rank_of_verdict(const Json& target) {
  static constexpr std::array<std::string_view, 4> kWords = {"takes", "loses", "unknown",
                                                             "refuses"};
  return rank(kWords, target.at("verdict"));
}

std::ptrdiff_t rank_of_first(const Json& target) {
  static constexpr std::array<std::string_view, 5> kWords = {"changes", "loses", "breaks",
                                                             "refuses", "crashes"};
  return target.contains("first") ? rank(kWords, target.at("first").at("effect")) : -1;
}

void add_count(Json& target, const Json& other, const char* name) {
  target[name] = sum(target.at(name), other.at(name));
}

/// The worse of two verdicts on one reader.
void merge_target(Json& target, const Json& other) {
  for (const char* name : {"refusals", "unknown", "losses"}) add_count(target, other, name);
  if (rank_of_first(other) > rank_of_first(target)) target["first"] = other.at("first");
  for (const Json& rule : other.value("unknown_rules", Json::array())) {
    Json& rules = target["unknown_rules"];
    if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
  }
  const std::ptrdiff_t worse = rank_of_verdict(other) - rank_of_verdict(target);
  if (worse > 0) target["verdict"] = other.at("verdict");
  for (const char* name : {"ignored", "in_baseline"}) {  // number of deciding findings
    if (worse > 0) target[name] = other.at(name);
    if (worse == 0) add_count(target, other, name);
  }
}

void add(Json& merged, const Json& report) {
  for (const auto& [name, count] : report.at("summary").items()) {
    Json& total = merged["summary"].emplace(name, 0U).first.value();
    total = sum(total, count);
  }
  for (const Json& diagnostic : report.at("diagnostics"))
    merged["diagnostics"].push_back(diagnostic);
  if (!report.contains("targets")) return;
  for (const auto& [name, target] : report.at("targets").items()) {
    if (!merged["targets"].contains(name)) {
      merged["targets"][name] = target;
    } else {
      merge_target(merged["targets"][name], target);
    }
  }
}

/// A file that two parts have read is in both reports.
void drop_repeated(Json& merged) {
  Json& list = merged["diagnostics"];
  std::stable_sort(list.begin(), list.end(),
                   [](const Json& a, const Json& b) { return order_of(a) < order_of(b); });
  Json kept = Json::array();
  for (Json& diagnostic : list) {
    if (kept.empty() || kept.back() != diagnostic) {
      kept.push_back(std::move(diagnostic));
      continue;
    }
    Json& count = merged["summary"][diagnostic.at("severity").get<std::string>()];
    count = std::max<std::uint64_t>(count.get<std::uint64_t>(), 1) - 1;
  }
  list = std::move(kept);
}

}  // namespace

MergedReport merge_json_reports(std::span<const NamedText> reports, const ToolName& tool) {
  Json merged;
  merged["schema_version"] = "1.0";
  merged["tool"] = {{"name", text(tool.name)}, {"version", text(tool.version)}};
  for (const char* count :
       {"error", "warning", "info", "suppressed", "files", "models", "scenes"}) {
    merged["summary"][count] = 0U;
  }
  merged["diagnostics"] = Json::array();
  for (const NamedText& report : reports) {
    try {
      add(merged, Json::parse(report.text));
    } catch (const nlohmann::json::exception&) {
      return {{}, {}, "'" + report.name + "' is not a JSON report of these tools"};
    }
  }
  MergedReport result;
  try {
    drop_repeated(merged);
  } catch (const nlohmann::json::exception&) {
    return {{}, {}, "a finding of the reports lacks what every finding has"};
  }
  result.json = dump(merged);
  result.summary.errors = merged["summary"]["error"];
  result.summary.warnings = merged["summary"]["warning"];
  result.summary.infos = merged["summary"]["info"];
  return result;
}

}  // namespace smurf
