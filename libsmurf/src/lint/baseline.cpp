// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "lint/suppress.hpp"

namespace smurf {

namespace {

constexpr std::string_view kFirstLine =
    "# Findings that smurf-lint suppresses: file, rule, place. Written by\n";

void malformed(Span span, std::string message, DiagnosticSink& sink) {
  sink.report(rules::sml9104_malformed_baseline, span, std::move(message))
      .help("write it again with `--generate-baseline`");
}

}  // namespace

bool may_be_in_baseline(const Diagnostic& diagnostic) {
  return !diagnostic.rule->id.starts_with("SML9");
}

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
    return malformed(file.place(), "a file maps rules to lists of places", sink);
  }
  for (const yaml::View rule : file) {
    if (!rule.is_sequence()) {
      malformed(rule.place(), "a rule needs a list of places", sink);
      continue;
    }
    const Rule* known = find_rule(rule.key());  // it may be a name
    const std::string_view id = known != nullptr ? known->id : rule.key();
    auto& entries = entries_[std::string(file.key())][std::string(id)];
    for (const yaml::View place : rule) {
      if (!place.is_scalar()) {
        malformed(place.place(), "a place is a pointer such as `/motors/name=elbow/joint`", sink);
        continue;
      }
      entries[std::string(place.text())].push_back({place.place()});
    }
  }
}

std::size_t Baseline::apply(std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
  return std::erase_if(diagnostics, [&](const Diagnostic& diagnostic) {
    if (!may_be_in_baseline(diagnostic)) return false;
    const auto file = entries_.find(name_of_(sources.path(diagnostic.span.source)));
    if (file == entries_.end()) return false;
    const auto rule = file->second.find(diagnostic.rule->id);
    if (rule == file->second.end()) return false;
    const auto found = rule->second.find(diagnostic.named_pointer);
    if (found == rule->second.end()) return false;
    const auto entry = std::find_if(found->second.begin(), found->second.end(),
                                    [](const Entry& one) { return !one.is_used; });
    if (entry == found->second.end()) return false;
    entry->is_used = true;
    return true;
  });
}

constexpr std::size_t kLongestId = 40;  // a hostile list may have any length

void Baseline::report_stale(const SourceMap& sources, const RuleSelection& selection,
                            DiagnosticSink& sink) const {
  std::set<std::string> checked;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    checked.insert(name_of_(sources.path(SourceId{static_cast<std::uint32_t>(i)})));
  }
  const auto report = [&](const std::string& file, const std::string& id, const auto& places) {
    for (const auto& [pointer, entries] : places) {
      for (const Entry& entry : entries) {
        if (entry.is_used) continue;
        sink.report(rules::sml9105_stale_baseline_entry, entry.span,
                    quoted(file) + " no longer raises " + shortened(id, kLongestId) + " at " +
                        quoted(pointer));
      }
    }
  };
  for (const auto& [file, by_rule] : entries_) {
    for (const auto& [id, places] : by_rule) {
      const Rule* rule = find_rule(id);
      const bool is_run =
          checked.contains(file) && (rule == nullptr || selection.is_enabled(*rule));
      if (rule == nullptr || is_run) report(file, id, places);
    }
  }
}

bool Baseline::is_written(std::string_view text) { return text.starts_with(kFirstLine); }

std::string Baseline::write(std::span<const Diagnostic> diagnostics,
                            const SourceMap& sources) const {
  std::map<std::string, std::map<std::string_view, std::vector<std::string>>> files;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!may_be_in_baseline(diagnostic)) continue;
    files[name_of_(sources.path(diagnostic.span.source))][diagnostic.rule->id].push_back(
        diagnostic.named_pointer);
  }
  std::string text =
      std::string(kFirstLine) +
      "# `smurf-lint --generate-baseline`, which also removes entries of repaired faults.\n";
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
