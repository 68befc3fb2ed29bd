// SPDX-License-Identifier: BSD-3-Clause
// The sink and the one table of rules.
#include "smurf/diagnostic.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"

namespace smurf {

namespace {

constexpr std::size_t kMostMessage = 4000;  // bytes; shorter than several quoted names

constexpr const Rule* kRules[] = {
#define SMURF_RULE(name) &rules::name,
#include "base/findings/rules.def"
#undef SMURF_RULE
};

using Place = std::tuple<SourceId, std::uint32_t, std::uint32_t>;
using RulesByPlace = std::map<Place, std::vector<const Rule*>>;

Place key_of(Span span) { return {span.source, span.begin, span.end}; }

/// The entry whose place contains the span. Its place may be larger than the span: one rule may
/// mark the whole value "42 kg", and another only `kg`.
RulesByPlace::const_iterator find_around(const RulesByPlace& rules, Span span) {
  const auto lies_in = [&](const Place& place) {
    const auto& [source, begin, end] = place;
    return source == span.source && begin <= span.begin && span.end <= end;
  };
  const auto next = rules.lower_bound(key_of(span));
  if (next != rules.end() && lies_in(next->first)) return next;
  if (next == rules.begin() || !lies_in(std::prev(next)->first)) return rules.end();
  return std::prev(next);
}

}  // namespace

std::string_view to_string(Severity severity) {
  switch (severity) {
  case Severity::info: return "info";
  case Severity::warning: return "warning";
  case Severity::error: return "error";
  }
  return "";
}

void DiagnosticSink::report_left_out(const Rule& rule, Span span, std::string message,
                                     std::string_view limit) {
  Diagnostic& last = diagnostics_.emplace_back();
  last.rule = &rules::sml0002_file_too_large;
  last.severity = rule.severity;
  last.span = span;
  last.message = std::move(message) + "; from here on they are left out";
  last.help(raise_limit(limit));
  last.left_out = &rule;
}

Diagnostic& Diagnostic::label(Span place, std::string text) {
  labels.push_back({place, std::move(text)});
  return *this;
}

Diagnostic& Diagnostic::note(std::string text) {
  notes.push_back(std::move(text));
  return *this;
}

Diagnostic& Diagnostic::help(std::string text) {
  help_text = std::move(text);
  return *this;
}

Diagnostic& DiagnosticSink::report(const Rule& rule, Span span, std::string message) {
  const Rule& about_limits = rules::sml0002_file_too_large;
  const std::uint64_t count = ++counts_[&rule];
  const bool has_room = diagnostics_.size() < most_of_all_;
  const bool is_kept = (count <= most_ && has_room) || &rule == &about_limits;
  is_last_left_out_ = !is_kept;
  if (!is_kept && !has_room && !is_full_) {
    is_full_ = true;
    report_left_out(about_limits, span,
                    "there are more than " + std::to_string(most_of_all_) + " findings",
                    "all-findings");
  } else if (!is_kept && has_room && count == most_ + 1) {
    report_left_out(rule, span,
                    "there are more than " + std::to_string(most_) + " findings of " +
                        std::string(rule.id),
                    "findings");
  }
  Diagnostic& diagnostic =
      is_kept ? diagnostics_.emplace_back() : (left_out_ = Diagnostic{}, left_out_);
  diagnostic.rule = &rule;
  diagnostic.severity = rule.severity;
  diagnostic.span = span;
  const bool is_short = message.size() <= kMostMessage;
  diagnostic.message = is_short ? std::move(message) : shortened(message, kMostMessage);
  return diagnostic;
}

KeptIndexes::KeptIndexes() = default;
KeptIndexes::KeptIndexes(const KeptIndexes&) {}
KeptIndexes& KeptIndexes::operator=(const KeptIndexes&) {
  indexes_.reset();
  return *this;
}
KeptIndexes::~KeptIndexes() = default;
SuggestionIndexes& KeptIndexes::get() {
  if (!indexes_) indexes_ = std::make_unique<SuggestionIndexes>();
  return *indexes_;
}

std::optional<std::string_view> DiagnosticSink::suggest(std::string_view name,
                                                        std::span<const std::string_view> known) {
  if (is_last_left_out_ || suggestions_end_) return std::nullopt;
  const auto found = only_nearest(name, known, suggestions_left_, &indexes_.get());
  if (suggestions_left_ == 0) {
    suggestions_end_ = diagnostics_.empty() ? Span{} : diagnostics_.back().span;
  }
  return found;
}

std::vector<Diagnostic> DiagnosticSink::take() {
  if (suggestions_end_) {
    const auto last = std::find_if(diagnostics_.begin(), diagnostics_.end(),
                                   [&](const auto& one) { return one.span == *suggestions_end_; });
    if (last != diagnostics_.end()) {
      last->note("from here on, no names are suggested: the suggestions so far took more than " +
                 std::to_string(most_suggestions_) + " comparisons; " + raise_limit("suggestions"));
    }
    suggestions_end_.reset();
  }
  RulesByPlace by_place;
  for (const auto& [place, rule] : consequences_) by_place[key_of(place)].push_back(rule);
  for (Diagnostic& diagnostic : diagnostics_) {
    if (by_place.empty()) break;
    const auto found = find_around(by_place, diagnostic.span);
    if (found == by_place.end()) continue;
    diagnostic.consequences.insert(diagnostic.consequences.end(), found->second.begin(),
                                   found->second.end());
  }
  consequences_.clear();
  std::vector<Diagnostic> taken(std::make_move_iterator(diagnostics_.begin()),
                                std::make_move_iterator(diagnostics_.end()));
  diagnostics_.clear();
  return taken;
}

bool DiagnosticSink::has_errors() const {
  return std::any_of(diagnostics_.begin(), diagnostics_.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

std::uint64_t DiagnosticSink::count_of(const Rule& rule) const {
  const auto found = counts_.find(&rule);
  return found == counts_.end() ? 0 : found->second;
}

std::span<const Rule* const> all_rules() { return kRules; }

const std::vector<std::string_view>& rule_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> all;
    for (const Rule* rule : all_rules()) all.push_back(rule->id);
    for (const Rule* rule : all_rules()) all.push_back(rule->name);
    return all;
  }();
  return words;
}

const Rule* find_rule(std::string_view id_or_name) {
  for (const Rule* rule : all_rules()) {
    if (rule->id == id_or_name || rule->name == id_or_name) return rule;
  }
  return nullptr;
}

}  // namespace smurf
