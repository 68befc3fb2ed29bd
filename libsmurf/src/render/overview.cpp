// SPDX-License-Identifier: BSD-3-Clause
// The overview of a report for people: errors first, and limited in length.
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "render/causes.hpp"
#include "render/paint.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/render.hpp"
#include "smurf/verdict.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostOfRule = 3;  ///< kinds in a file
constexpr std::size_t kMostOthers = 6;  ///< named after a finding that they repeat
constexpr std::size_t kMostLines = 85;  ///< with the last finding and the summary, below 150
constexpr std::size_t kSlack = 15;      ///< for the last findings of a file
constexpr std::size_t kMostNames = 8;   ///< number of files listed by name only
constexpr std::size_t kFewest = 3;      ///< fewer findings are shown instead of counted
constexpr std::size_t kScreen = 8;      ///< findings that fit on about one screen

/// Rules about xacro, and about the files around a robot.
bool is_often_the_answer(const Rule& rule) {
  constexpr std::string_view kFamilies[] = {"SML33", "SML35", "SML36", "SML37", "SML38",
                                            "SML39", "SML42", "SML44", "SML45"};
  return std::any_of(std::begin(kFamilies), std::end(kFamilies),
                     [&](std::string_view family) { return rule.id.starts_with(family); });
}

/// A name in a file around a robot that the robot does not have.
bool is_misspelt_answer(const Diagnostic& one) {
  return is_often_the_answer(*one.rule) && one.caret.starts_with("no such ");
}

/// The files with findings of a kind.
struct Spread {
  std::vector<std::string_view> files;  ///< each once, in the order of the report
  std::string_view told_in{};           ///< the file with the block; "": none yet
};

/// Findings of a section that differ in names and numbers only: the first is shown, the others are
/// named.
struct Kind {
  std::vector<const Diagnostic*> findings;
  Spread* spread = nullptr;  ///< null if all findings are shown
};

/// The findings of one severity in one file.
struct Section {
  Severity severity;
  SourceId file;
  std::vector<const Diagnostic*> findings;
  std::vector<Kind> kinds = {};
};

class Overview {
 public:
  Overview(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
           const OverviewOptions& options, const TextStyle& style)
      : sources_(sources), options_(options), style_(style), paint_(style.color) {
    if (!options.shows_all) causes_.emplace(diagnostics, sources);
    std::array<std::vector<Section>, 3> by_severity;
    // Robots that include a file, or variants of a robot, have read it one by one.
    std::map<std::pair<Severity, std::string_view>, std::size_t> section_of;
    for (const Diagnostic& each : diagnostics) {
      const Diagnostic* shown = causes_ ? causes_->shown(each) : &each;
      if (shown == nullptr || !is_shown(*shown, options)) continue;
      const Diagnostic& one = *shown;
      const SourceId file = one.span.source;
      auto& sections = by_severity[static_cast<std::size_t>(one.severity)];
      const auto [section, is_new] =
          section_of.try_emplace({one.severity, path_of(file)}, sections.size());
      if (is_new) sections.push_back({one.severity, file, {}});
      sections[section->second].findings.push_back(&one);
      Repeated& repeated = repeated_[{one.rule, one.message}];
      if (repeated.files.empty()) repeated.first = path_of(file);
      repeated.files.insert(path_of(file));
      robots_at_[place_of(one)].push_back(file);
    }
    std::for_each(by_severity.rbegin(), by_severity.rend(), [&](std::vector<Section>& sections) {
      if (!options.shows_all && diagnostics.size() > kScreen) put_worst_first(sections);
      std::move(sections.begin(), sections.end(), std::back_inserter(sections_));
    });
    for (Section& section : sections_) {
      section.kinds = kinds_of(section);
      if (options.shows_all) continue;
      for (Kind& kind : section.kinds) spread(kind);
    }
    has_titles_ = std::any_of(sections_.begin(), sections_.end(), [&](const Section& section) {
      return path_of(section.file) != path_of(sections_.front().file);
    });
  }

  std::string text() {
    std::size_t next = 0;
    while (next < sections_.size() && (options_.shows_all || lines_ < kMostLines)) {
      add(sections_[next++]);
    }
    add_names(std::span(sections_).subspan(next));
    return std::move(out_);
  }

 private:
  /// A message that several files may have.
  struct Repeated {
    std::string_view first;
    std::set<std::string_view> files;
    bool is_told = false;
  };

  /// Robots that include a file have the same finding there, with names and numbers of their own.
  using Place = std::tuple<const Rule*, Severity, std::string_view, std::uint32_t, std::string>;
  Place place_of(const Diagnostic& one) const {
    return {one.rule, one.severity, path_of(one.span.source), one.span.begin, form_of(one.message)};
  }
  static std::string without_names(std::string_view message) {
    std::string rest;
    bool is_name = false;
    for (const char c : message) {
      if (c == '`') is_name = !is_name;
      if (!is_name) rest += c;
    }
    return rest;
  }
  /// With one sign for each number, whatever its form: "-1.0472" and "2e-06".
  static std::string without_numbers(std::string_view text) {
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    std::string rest;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool is_sign = text[i] == '-' && i + 1 < text.size() && is_digit(text[i + 1]);
      if (!is_digit(text[i]) && !is_sign) {
        rest += text[i];
        continue;
      }
      for (++i; i < text.size(); ++i) {
        const bool is_exponent = text[i] == '-' && text[i - 1] == 'e';
        if (!is_digit(text[i]) && text[i] != '.' && text[i] != 'e' && !is_exponent) break;
      }
      --i;
      rest += '#';
    }
    return rest;
  }
  static std::string form_of(std::string_view text) { return without_numbers(without_names(text)); }
  static std::string_view remedy_of(const Diagnostic& one) {
    return one.fixes.empty() ? std::string_view() : std::string_view(one.help_text);
  }
  bool is_of_another_robot(const Diagnostic& one) const {
    return robots_at_.at(place_of(one)).front() != one.span.source;
  }

  /// What findings of a kind have in common, in all files.
  using Text = std::tuple<const Rule*, Severity, std::string, std::string_view>;
  static Text text_of(const Diagnostic& one) {
    return {one.rule, one.severity, form_of(one.message), remedy_of(one)};
  }
  void spread(Kind& kind) {
    kind.spread = &spread_[text_of(*kind.findings.front())];
    std::vector<std::string_view>& files = kind.spread->files;
    const auto add = [&](std::string_view file) {
      if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    };
    for (const Diagnostic* one : kind.findings) {
      add(path_of(one->span.source));
      for (const std::string_view file : repeated_[{one->rule, one->message}].files) add(file);
    }
  }
  /// One block for all files, if there are so many that the report would repeat itself.
  bool is_told(const Kind& kind) const {
    return kind.spread != nullptr && is_one_block(kind) && !kind.spread->told_in.empty() &&
           kind.spread->told_in != path_of(kind.findings.front()->span.source);
  }

  /// In the files around a robot, the names are what readers look for: two files are two blocks.
  static bool is_one_block(const Kind& kind) {
    const bool is_about_names = is_misspelt_answer(*kind.findings.front());
    return kind.spread->files.size() >= (is_about_names ? kFewest : 2);
  }

  /// The number of findings and of kinds of a rule in a section.
  struct Tally {
    std::size_t all = 0;
    std::size_t told = 0;
    std::size_t kinds = 0;
    std::size_t shown = 0;
  };

  /// The number of readers that do not load a file with such a finding, and of those that lose a
  /// part of it.
  using Harm = std::pair<std::size_t, std::size_t>;

  /// Depends on the place of a finding only for few rules, so the first place of each set of cases
  /// stands for all.
  Harm harm_of(const Diagnostic& finding) {
    const auto [place, is_new] = harms_.try_emplace({finding.rule, finding.cases}, Harm{0, 0});
    if (!is_new) return place->second;
    for (const Reader* reader : all_readers()) {
      const Fact* fact = reader->is_target ? find_fact(*reader, finding) : nullptr;
      if (fact == nullptr) continue;
      if (fact->effect >= Effect::refuses) ++place->second.first;
      if (fact->effect >= Effect::loses) ++place->second.second;
    }
    return place->second;
  }

  /// Otherwise the files are in the order of their names, and the first screen shows any of them.
  /// Names that a file around the robot misspells come first: a robot has dozens of estimated
  /// masses, and they would hide the one line that keeps it from moving.
  void put_worst_first(std::vector<Section>& sections) {
    std::map<std::string_view, std::pair<bool, Harm>> worst;
    for (const Section& section : sections) {
      auto& [is_answer, harm] = worst[path_of(section.file)];
      for (const Diagnostic* finding : section.findings) {
        is_answer = is_answer || is_misspelt_answer(*finding);
        harm = std::max(harm, harm_of(*finding));
      }
    }
    std::stable_sort(sections.begin(), sections.end(), [&](const Section& a, const Section& b) {
      return worst[path_of(a.file)] > worst[path_of(b.file)];
    });
  }

  std::string_view path_of(SourceId file) const { return sources_.path(file); }

  void write(const std::string& text) {
    lines_ += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    out_ += text;
  }

  /// "arm.urdf: 3 errors"
  std::string title(const Section& section) const {
    return render::escape(sources_.path(section.file)) + ": " + amount(section);
  }

  static std::string amount(const Section& section) {
    return counted(section.findings.size(), to_string(section.severity));
  }

  std::vector<Kind> kinds_of(const Section& section) {
    std::vector<Kind> kinds;
    // Notes may say what is special about a finding, such as the variant of its robot. With a
    // remedy of another form, a finding is another one; what else it writes is named with the
    // finding. Help without a fix is only a guess; guesses about one fault could contradict each
    // other, so only the first is shown.
    using Key = std::tuple<const Rule*, std::string, std::string, std::vector<std::string>>;
    std::map<Key, std::size_t> index;
    for (const Diagnostic* one : section.findings) {
      if (options_.shows_all) {
        kinds.push_back({{one}});
        continue;
      }
      const Repeated& repeated = repeated_[{one->rule, one->message}];
      if (repeated.first != path_of(section.file) || is_of_another_robot(*one)) continue;
      std::vector<std::string> notes;
      for (const std::string& note : one->notes) {
        const bool is_variant = note.find(":=") != std::string::npos;
        notes.push_back(is_variant ? note : without_numbers(note));
      }
      const auto [kind, is_new] = index.try_emplace(
          {one->rule, form_of(one->message), form_of(remedy_of(*one)), notes}, kinds.size());
      if (is_new) kinds.emplace_back();
      kinds[kind->second].findings.push_back(one);
    }
    return kinds;
  }

  void add(const Section& section) {
    std::vector<Kind> kinds = section.kinds;
    std::erase_if(kinds, [&](const Kind& kind) { return is_told(kind); });
    std::map<std::string_view, Tally> of_rule;
    for (const Kind& kind : kinds) {
      Tally& tally = of_rule[kind.findings.front()->rule->id];
      ++tally.kinds;
      tally.all += kind.findings.size();
    }
    bool is_titled = !has_titles_;
    bool is_too_long = false;
    std::size_t left = kinds.size();
    for (const Kind& kind : kinds) {
      const Diagnostic& one = *kind.findings.front();
      Tally& tally = of_rule[one.rule->id];
      const bool is_too_many = tally.shown >= kMostOfRule && tally.kinds >= kMostOfRule + kFewest;
      is_too_long =
          is_too_long || (lines_ >= kMostLines && left >= kFewest) || lines_ >= kMostLines + kSlack;
      const bool is_cut = !options_.shows_all && (is_too_many || is_too_long);
      --left;
      if (is_cut) continue;
      if (!is_titled) write(paint_(render::Ink::strong, title(section)) + "\n\n");
      is_titled = true;
      ++tally.shown;
      tally.told += kind.findings.size();
      write(render_full(one, sources_, style_));
      const std::string same = same_here(kind) + same_elsewhere(kind);
      if (!same.empty()) write(same + "\n");
    }
    write(cut(of_rule));
  }

  /// The names in a message, with their backquotes.
  static std::vector<std::string_view> names_in(std::string_view message) {
    std::vector<std::string_view> names;
    for (std::size_t at = message.find('`'); at != std::string_view::npos;) {
      const std::size_t end = message.find('`', at + 1);
      if (end == std::string_view::npos) break;
      names.push_back(message.substr(at, end + 1 - at));
      at = message.find('`', end + 1);
    }
    return names;
  }

  /// Which name of the messages tells the findings apart: of unknown names the last, which is the
  /// unknown one; large if none does.
  static std::size_t distinct_name_of(const Kind& kind) {
    const Diagnostic& first = *kind.findings.front();
    const std::size_t count = names_in(first.message).size();
    const bool is_unknown_name = first.caret.starts_with("no such ");
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t which = is_unknown_name ? count - 1 - i : i;
      std::set<std::string_view> distinct;
      for (const Diagnostic* one : kind.findings) {
        // A name may contain backquotes.
        const std::vector<std::string_view> names = names_in(one->message);
        if (which < names.size()) distinct.insert(names[which]);
      }
      if (distinct.size() == kind.findings.size()) return which;
    }
    return std::string_view::npos;
  }

  /// " (`left_toe`)", if that is what the fix of a finding writes, and not that of the first.
  static std::string correction_of(const Diagnostic& one, const Diagnostic& first) {
    if (one.fixes.empty() || one.help_text == first.help_text) return {};
    const std::vector<std::string_view> names = names_in(one.help_text);
    return names.empty() ? "" : " (" + render::escape(names.front()) + ")";
  }

  /// "... and the same for `left_toe` and `left_shin` in this file; --all shows them"
  std::string same_here(const Kind& kind) const {
    if (kind.findings.size() == 1) return {};
    const Diagnostic& first = *kind.findings.front();
    std::vector<std::string> names, lines;
    const std::size_t which = distinct_name_of(kind);
    for (const Diagnostic* one : std::span(kind.findings).subspan(1)) {
      const std::vector<std::string_view> all = names_in(one->message);
      if (which < all.size()) {
        names.push_back(render::escape(all[which]) + correction_of(*one, first));
      }
      const Span place = one->span;
      const std::string line = std::to_string(sources_.line_of(place.source, place.begin));
      if (lines.empty() || lines.back() != line) lines.push_back(line);
    }
    const bool are_named = !names.empty();
    std::vector<std::string>& others = are_named ? names : lines;
    const std::string_view where = are_named            ? "for "
                                   : others.size() == 1 ? "in line "
                                                        : "in lines ";
    if (others.size() > kMostOthers + 1) {
      const std::size_t more = others.size() - kMostOthers;
      others.resize(kMostOthers);
      others.push_back(std::to_string(more) + " more");
    }
    return render::wrap("... and the same " + std::string(where) + enumerated(others) +
                            (are_named ? " in this file" : "") + "; --all shows " +
                            (kind.findings.size() == 2 ? "it" : "them"),
                        0, render::kColumns);
  }

  /// "... and the same in 31 more files: a.xacro, b.xacro and 29 more; --all shows them"
  static std::string same_in_files(Spread& spread, std::string_view here) {
    if (!spread.told_in.empty()) return {};
    spread.told_in = here;
    std::vector<std::string> others;
    for (const std::string_view file : spread.files) {
      if (file != here) others.push_back(render::escape(file));
    }
    return render::wrap("... and the same in " + counted(others.size(), "more file") + ": " +
                            enumerated_to(kFewest, others) + "; --all shows them",
                        0, render::kColumns);
  }

  std::string same_elsewhere(const Kind& kind) {
    if (kind.spread == nullptr) return {};
    const Diagnostic& one = *kind.findings.front();
    if (is_one_block(kind)) {
      return same_in_files(*kind.spread, path_of(one.span.source));
    }
    Repeated& repeated = repeated_[{one.rule, one.message}];
    if (repeated.files.size() > 1) {
      if (std::exchange(repeated.is_told, true)) return {};
      return "... and the same in " + counted(repeated.files.size() - 1, "more file") + "\n";
    }
    const std::vector<SourceId>& readings = robots_at_.at(place_of(one));
    const std::size_t robots = std::set(readings.begin(), readings.end()).size();
    return robots == 1 ? "" : "... and the same in " + counted(robots - 1, "more robot") + "\n";
  }

  /// "... and 12 more of SML1501, 3 of SML1502 in this file; --all shows them"
  static std::string cut(const std::map<std::string_view, Tally>& of_rule) {
    std::string text;
    std::size_t count = 0;
    for (const auto& [id, tally] : of_rule) {
      if (tally.told == tally.all) continue;
      text += (text.empty() ? "... and " : ", ") + std::to_string(tally.all - tally.told) +
              (tally.told > 0 ? " more of " : " of ") + std::string(id);
      count += tally.all - tally.told;
    }
    if (text.empty()) return text;
    const std::string_view them = count == 1 ? "it" : "them";
    return render::wrap(text + " in this file; --all shows " + std::string(them), 0,
                        render::kColumns) +
           "\n";
  }

  /// The files whose findings do not fit, as "arm.urdf: 3 errors, 2 warnings".
  void add_names(std::span<const Section> rest) {
    std::vector<std::vector<const Section*>> files;
    std::map<std::string_view, std::size_t> index;
    for (const Section& section : rest) {
      const auto told = [&](const Kind& one) { return is_told(one); };
      if (std::all_of(section.kinds.begin(), section.kinds.end(), told)) continue;
      const auto [place, is_new] = index.try_emplace(path_of(section.file), files.size());
      if (is_new) files.emplace_back();
      files[place->second].push_back(&section);
    }
    const std::size_t named = std::min(files.size(), kMostNames);
    if (!files.empty()) write("Also found, and shown with --all:\n");
    for (std::size_t i = 0; i < named; ++i) {
      std::string line = title(*files[i].front());
      for (std::size_t j = 1; j < files[i].size(); ++j) line += ", " + amount(*files[i][j]);
      write(line + "\n");
    }
    std::size_t findings = 0;
    for (std::size_t i = named; i < files.size(); ++i) {
      for (const Section* section : files[i]) findings += section->findings.size();
    }
    if (findings > 0) {
      write("... and " + counted(findings, "finding") + " in " +
            counted(files.size() - named, "more file") + "\n");
    }
    if (!files.empty()) write("\n");
  }

  const SourceMap& sources_;
  const OverviewOptions& options_;
  const TextStyle& style_;
  render::Painter paint_;
  std::optional<render::Causes> causes_;
  std::vector<Section> sections_;
  std::map<std::pair<const Rule*, std::string_view>, Repeated> repeated_;
  std::map<Text, Spread> spread_;
  std::map<Place, std::vector<SourceId>> robots_at_;  ///< in their order
  std::map<std::pair<const Rule*, Circumstances>, Harm> harms_;
  bool has_titles_ = false;
  std::size_t lines_ = 0;
  std::string out_;
};

}  // namespace

bool is_shown(const Diagnostic& diagnostic, const OverviewOptions& options) {
  return diagnostic.severity >= options.least ||
         (options.shows_answers && is_often_the_answer(*diagnostic.rule));
}

OverviewOptions show_answers(OverviewOptions options, std::span<const Diagnostic> diagnostics) {
  constexpr std::ptrdiff_t kMost = 9;
  options.shows_answers = true;
  const auto count = std::count_if(diagnostics.begin(), diagnostics.end(),
                                   [&](const Diagnostic& one) { return is_shown(one, options); });
  options.shows_answers = count <= kMost;
  return options;
}

std::string render_overview(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                            const OverviewOptions& options, const TextStyle& style) {
  return Overview(diagnostics, sources, options, style).text();
}

}  // namespace smurf
