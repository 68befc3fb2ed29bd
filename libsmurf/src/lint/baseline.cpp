// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "base/edits.hpp"
#include "base/rules.hpp"
#include "smurf/suppress.hpp"

namespace smurf {

namespace {

constexpr std::string_view kFirstLine =
    "# Findings that smurf-lint lets pass: file, rule, place. Written by\n";

void malformed(Span span, std::string message, DiagnosticSink& sink) {
  sink.report(rules::sml9104_malformed_baseline, span, std::move(message)).help =
      "write it anew with `--generate-baseline`";
}

}  // namespace

void Baseline::read(const yaml::Document& document, DiagnosticSink& sink) {
  const yaml::View root = document.view();
  if (!root || root.is_null()) return;
  if (!root.is_mapping()) {
    return malformed(root.place(), "a baseline maps files to rules to places", sink);
  }
  for (const yaml::View file : root) read_file(file, sink);
}

void Baseline::read_file(yaml::View file, DiagnosticSink& sink) {
  if (!file.is_mapping()) {
    return malformed(file.place(), "below a file stand rules, each with a list of places", sink);
  }
  for (const yaml::View rule : file) {
    if (!rule.is_sequence()) {
      malformed(rule.place(), "below a rule stands a list of places", sink);
      continue;
    }
    for (const yaml::View place : rule) {
      if (!place.is_scalar()) {
        malformed(place.place(), "a place is a pointer such as `/motors/name=elbow/joint`", sink);
        continue;
      }
      entries_[{std::string(file.key()), std::string(rule.key()), std::string(place.text())}]
          .push_back({place.place()});
    }
  }
}

std::size_t Baseline::apply(std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
  return std::erase_if(diagnostics, [&](const Diagnostic& diagnostic) {
    const auto found = entries_.find({name_of_(sources.path(diagnostic.span.source)),
                                      std::string(diagnostic.rule->id), diagnostic.named_pointer});
    if (found == entries_.end()) return false;
    const auto entry = std::find_if(found->second.begin(), found->second.end(),
                                    [](const Entry& one) { return !one.is_used; });
    if (entry == found->second.end()) return false;
    entry->is_used = true;
    return true;
  });
}

void Baseline::report_stale(const SourceMap& sources, const RuleSelection& selection,
                            DiagnosticSink& sink) const {
  std::set<std::string> checked;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    checked.insert(name_of_(sources.path(SourceId{static_cast<std::uint32_t>(i)})));
  }
  for (const auto& [key, entries] : entries_) {
    const auto& [file, id, pointer] = key;
    const Rule* rule = find_rule(id);
    if (rule != nullptr && (!checked.contains(file) || !selection.is_enabled(*rule))) continue;
    for (const Entry& entry : entries) {
      if (entry.is_used) continue;
      sink.report(rules::sml9105_stale_baseline_entry, entry.span,
                  "`" + file + "` no longer raises " + id + " at `" + pointer + "`");
    }
  }
}

bool Baseline::is_written(std::string_view text) { return text.starts_with(kFirstLine); }

std::string Baseline::write(std::span<const Diagnostic> diagnostics,
                            const SourceMap& sources) const {
  std::map<std::string, std::map<std::string_view, std::vector<std::string>>> files;
  for (const Diagnostic& diagnostic : diagnostics) {
    files[name_of_(sources.path(diagnostic.span.source))][diagnostic.rule->id].push_back(
        diagnostic.named_pointer);
  }
  std::string text = std::string(kFirstLine) +
                     "# `smurf-lint --generate-baseline`, which also drops what is mended.\n";
  if (files.empty()) text += "{}\n";
  for (auto& [file, by_rule] : files) {
    text += yaml_like("", file) + ":\n";
    for (auto& [id, pointers] : by_rule) {
      text.append("  ").append(id).append(":\n");
      std::sort(pointers.begin(), pointers.end());
      for (const std::string& pointer : pointers) text += "  - " + yaml_like("", pointer) + "\n";
    }
  }
  return text;
}

}  // namespace smurf
