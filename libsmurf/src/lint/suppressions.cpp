// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>

#include "base/findings/rule_patterns.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "lint/file_selection.hpp"
#include "lint/suppress.hpp"

namespace smurf {

namespace {

constexpr std::string_view kMarker = "smurf-lint:";
constexpr std::string_view kBlank = " \t";

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::uint32_t offset(std::size_t size) { return static_cast<std::uint32_t>(size); }

bool is_known(std::string_view name) { return !rules_matching(name).empty(); }

/// Whether smurf-lint reports all findings of the rules of that name here. Findings that depend on
/// targets are reported only if all readers with a fact are targets. Findings of the other tools
/// (SML6, SML8) are never reported.
bool has_run(std::string_view name, const RuleSelection& selection, FileSelection& file) {
  const auto has_run_in_full = [&](const Rule& rule) {
    if (rule.reported_by != Tool::lint) return false;
    if (!file.is_enabled(rule)) return false;
    const auto& targets = selection.targets;
    const auto readers = all_readers();
    return !rule.needs_target ||
           std::all_of(readers.begin(), readers.end(), [&](const Reader* reader) {
             return !reader->is_target || !has_facts(*reader, rule) ||
                    std::any_of(targets.begin(), targets.end(), [&](const Reader* target) {
                      return target == reader || target->like == reader;
                    });
           });
  };
  const auto rules = rules_matching(name);
  return std::all_of(rules.begin(), rules.end(),
                     [&](const Rule* rule) { return has_run_in_full(*rule); });
}

/// "there is no rule `SML31O1`", and a suggestion.
void report_unknown_rule(Span span, std::string_view name, DiagnosticSink& sink) {
  Diagnostic& diagnostic = sink.report(rules::sml9102_unknown_rule, span,
                                       "there is no rule `" + std::string(name) + "`");
  if (const auto near = sink.suggest(name, rule_words())) {
    diagnostic.help("did you mean `" + std::string(*near) + "`?");
    diagnostic.fixes.push_back({Applicability::unsafe, {{span, std::string(*near)}}});
  }
}

}  // namespace

/// Reads the comments of one file.
class Suppressions::Reader {
 public:
  Reader(std::string_view text, SourceId source, std::vector<Comment>& comments)
      : text_(text), source_(source), comments_(comments), lines_(text) {}

  void read(const yaml::Document& document) {
    const std::vector<Marker> markers = markers_in(document);
    bool is_above_entry = false;
    for (std::size_t i = 0; i < markers.size(); ++i) {
      const auto [hash, at] = markers[i];
      const Line line = lines_.around(at);
      const bool is_continued = i + 1 < markers.size() && markers[i + 1].hash < line.end;
      const std::size_t end =
          is_continued ? text_.find_last_not_of(kBlank, markers[i + 1].hash - 1) + 1 : line.end;
      // Several suppressions in one comment apply to the same place.
      const bool is_first = i == 0 || markers[i - 1].hash < line.begin;
      if (is_first) is_above_entry = hash == line.text_begin;
      add({source_, offset(hash), offset(end)}, at, is_above_entry,
          [&](std::uint32_t behind) { return next_entry(document, behind); });
    }
  }

  void read(const xml::Document& document) {
    for (const Span comment : document.comments) {
      const std::string_view body = text_.substr(comment.begin, comment.end - comment.begin);
      const std::size_t at = body.find_first_not_of(" \t\r\n", 4);
      if (at == std::string_view::npos || !body.substr(at).starts_with(kMarker)) continue;
      add(comment, comment.begin + at, comment.begin == lines_.around(comment.begin).text_begin,
          [&](std::uint32_t end) { return next_element(document, end); });
    }
  }

 private:
  /// A line without its line end, and its text without the blanks around it.
  struct Line {
    std::size_t begin = 0, end = 0;
    std::size_t text_begin = 0, text_end = 0;
  };

  /// Finds the lines of places. Call it with places in ascending order; many may share a line.
  class Lines {
   public:
    explicit Lines(std::string_view text) : text_(text) { look_around(0); }

    const Line& around(std::size_t at) {
      if (at < line_.begin || at > line_.end) look_around(at);
      return line_;
    }

   private:
    void look_around(std::size_t at) {
      const std::size_t before = at == 0 ? std::string_view::npos : text_.rfind('\n', at - 1);
      line_.begin = before == std::string_view::npos ? 0 : before + 1;
      line_.end = std::min(text_.find('\n', at), text_.size());
      line_.text_begin = line_.begin;
      while (line_.text_begin < line_.end && is_space(text_[line_.text_begin])) ++line_.text_begin;
      line_.text_end = line_.end;
      while (line_.text_end > line_.text_begin && is_space(text_[line_.text_end - 1])) {
        --line_.text_end;
      }
    }

    std::string_view text_;
    Line line_;
  };

  using Range = std::pair<std::uint32_t, std::uint32_t>;
  struct Marker {
    std::size_t hash, at;
  };

  std::vector<Marker> markers_in(const yaml::Document& document) const {
    std::vector<Marker> markers;
    for (std::size_t at = text_.find(kMarker); at != std::string_view::npos;
         at = text_.find(kMarker, at + 1)) {
      const std::size_t hash = text_.find_last_not_of(kBlank, at == 0 ? 0 : at - 1);
      if (at == 0 || hash == std::string_view::npos || text_[hash] != '#') continue;
      if (hash > 0 && !is_space(text_[hash - 1]) && text_[hash - 1] != '\n') continue;
      if (!is_in_scalar(document, offset(hash))) markers.push_back({hash, at});
    }
    return markers;
  }

  static bool is_in_scalar(const yaml::Document& document, std::uint32_t at) {
    const yaml::NodeId id = yaml::node_at(document, at);
    if (id == yaml::kNoNode) return false;
    const yaml::Node& node = document.nodes[static_cast<std::size_t>(id)];
    if (node.key_span().contains(at)) return true;
    return node.kind() == yaml::Kind::scalar && node.span.contains(at);
  }

  /// The outermost entry that begins behind the comment and is not the whole file.
  static Range next_entry(const yaml::Document& document, std::uint32_t end) {
    const auto begin_of = [](const yaml::Node& node) {
      return node.key_span().empty() ? node.span.begin : node.key_span().begin;
    };
    const auto& nodes = document.nodes;  // in document order
    auto next = std::partition_point(nodes.begin(), nodes.end(),
                                     [&](const yaml::Node& node) { return begin_of(node) < end; });
    const auto number = static_cast<std::size_t>(next - nodes.begin());
    if (next != nodes.end() && yaml::NodeId{offset(number)} == document.root) ++next;
    if (next == nodes.end()) return {end, end};
    return {begin_of(*next), std::max(next->key_span().end, next->span.end)};
  }

  static Range next_element(const xml::Document& document, std::uint32_t end) {
    const auto& elements = document.elements;  // in document order
    const auto next =
        std::partition_point(elements.begin(), elements.end(),
                             [&](const xml::Element& one) { return one.span.begin < end; });
    if (next == document.elements.end()) return {end, end};
    return {next->span.begin, next->span.end};
  }

  /// `at` is the marker. A comment above an entry applies to what `find_next` finds after it, any
  /// other comment to its line.
  template <class FindNext>
  void add(Span span, std::size_t at, bool is_above_entry, const FindNext& find_next) {
    const Line first = lines_.around(span.begin);
    const Line last = lines_.around(span.end);
    Comment comment{span, span, 0, 0, {}, {}, {}};
    if (first.text_begin == span.begin && last.text_end <= span.end) {  // nothing else
      const std::size_t after = std::min(last.end + 1, text_.size());
      comment.removal = {source_, offset(first.begin), offset(after)};
    } else {
      const std::size_t before = text_.substr(0, span.begin).find_last_not_of(kBlank);
      comment.removal.begin = before == std::string_view::npos ? 0 : offset(before + 1);
    }
    if (!is_removable(span)) comment.removal = {};
    std::tie(comment.begin, comment.end) =
        is_above_entry ? find_next(span.end) : Range{offset(first.begin), offset(last.end) + 1};

    std::string_view words = text_.substr(at + kMarker.size(), span.end - at - kMarker.size());
    const std::size_t skipped = std::min(words.find_first_not_of(kBlank), words.size());
    read_words(words.substr(skipped), at + kMarker.size() + skipped, comment);
    comments_.push_back(std::move(comment));
  }

  /// The first rule that a malformed comment names; "ID" when it names none.
  static std::string rule_in(std::string_view words) {
    constexpr std::string_view kNameCharacters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-";
    std::size_t begin = words.find_first_of(kNameCharacters);
    while (begin != std::string_view::npos) {
      const std::size_t end =
          std::min(words.find_first_not_of(kNameCharacters, begin), words.size());
      const std::string_view word = words.substr(begin, end - begin);
      if (find_rule(word) != nullptr) return std::string(word);
      begin = words.find_first_of(kNameCharacters, end);
    }
    return "ID";
  }

  /// False if a reader of YAML 1.1 would end the line earlier and read the rest, or if the comment
  /// would split a text in XML.
  bool is_removable(Span span) const {
    const std::string_view comment = text_.substr(span.begin, span.end - span.begin);
    for (const std::string_view line_end : {"\u0085", "\u2028", "\u2029"}) {
      if (comment.find(line_end) != std::string_view::npos) return false;
    }
    if (!comment.starts_with('<')) return true;
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t before = text_.substr(0, span.begin).find_last_not_of(kSpace);
    const std::size_t after = text_.find_first_not_of(kSpace, span.end);
    return before == std::string_view::npos || text_[before] == '>' ||
           after == std::string_view::npos || text_[after] == '<';
  }

  void read_words(std::string_view words, std::size_t at, Comment& comment) const {
    comment.rule_named = rule_in(words);
    const std::size_t open = std::min(words.find_first_of("[ \t\r\n"), words.size());
    const std::string_view verb = words.substr(0, open);
    if (verb != "ignore" && verb != "ignore-file") {
      comment.problem = quoted(verb) + " is neither `ignore` nor `ignore-file`";
      return;
    }
    const std::size_t close = words.find(']');
    if (open == words.size() || words[open] != '[' || close == std::string_view::npos) {
      comment.problem = "no rules in brackets follow " + quoted(verb);
      return;
    }
    if (verb == "ignore-file") {
      comment.begin = 0;
      comment.end = offset(text_.size()) + 1;
    }
    read_items(words.substr(open + 1, close - open - 1), at + open + 1, comment);
    if (comment.items.empty()) comment.problem = "it names no rule";
  }

  /// "SML3101, unknown-link". An item is removed with the comma before it, the first item with the
  /// comma after it.
  void read_items(std::string_view list, std::size_t at, Comment& comment) const {
    std::size_t begin = 0;
    while (begin <= list.size()) {
      const std::size_t end = std::min(list.find(',', begin), list.size());
      const std::string_view piece = list.substr(begin, end - begin);
      const std::size_t first = piece.find_first_not_of(" \t\r\n");
      if (first != std::string_view::npos) {
        const std::size_t last = piece.find_last_not_of(" \t\r\n") + 1;
        Item item;
        item.name = piece.substr(first, last - first);
        item.span = {source_, offset(at + begin + first), offset(at + begin + last)};
        item.removal = begin == 0
                           ? Span{source_, offset(at), offset(at + std::min(end + 1, list.size()))}
                           : Span{source_, offset(at + begin - 1), offset(at + end)};
        comment.items.push_back(std::move(item));
      }
      begin = end + 1;
    }
  }

  std::string_view text_;
  SourceId source_;
  std::vector<Comment>& comments_;
  Lines lines_;
};

/// A file is read once, but several models may use it. It is complete only if it is complete in all
/// of them.
template <class Document>
void Suppressions::add(const Document& document, bool is_complete, const SourceMap& sources) {
  const auto [file, is_new] = files_.try_emplace(sources.path(document.source));
  file->second.is_complete = file->second.is_complete && is_complete;
  if (!is_new) return;
  Reader(sources.text(document.source), document.source, file->second.comments).read(document);
}

void Suppressions::add(const LinkedModel& model, const SourceMap& sources,
                       const xacro::Expansions& expansions) {
  for (const ModelFile& file : model.files) {
    if (file.document) add(*file.document, model.is_complete, sources);
  }
  if (!model.robot) return;
  const auto expanded = expansions.find(model.robot->document.source);
  if (expanded == expansions.end()) {
    add(model.robot->document, model.is_complete, sources);
    return;
  }
  // Other robots may use an included file, and need its comments.
  for (const xml::Document& document : expanded->second.documents) {
    add(document, model.is_complete && document.source == expanded->second.root, sources);
  }
}

void Suppressions::add(const Companions& companions, const SourceMap& sources) {
  for (const Companion& one : companions.files) {
    if (one.srdf) add(one.srdf->document, true, sources);
    if (one.document) add(*one.document, true, sources);
  }
}

void Suppressions::add(const LinkedScene& scene, const SourceMap& sources,
                       const xacro::Expansions& expansions) {
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      add(*file.drawing, scene.is_complete, sources);
    } else if (file.document) {
      const auto made = expansions.find(file.document->source);
      if (made == expansions.end()) {
        add(*file.document, scene.is_complete, sources);
      } else {
        for (const xml::Document& document : made->second.documents)
          add(document, scene.is_complete, sources);
      }
    }
  }
  for (const DataFile& file : scene.data_files) add(file.document, scene.is_complete, sources);
  for (const LinkedModel& model : scene.models) add(model, sources, expansions);
}

void Suppressions::take(Suppressions&& other, const SourceShift& shift) {
  for (auto& [path, from] : other.files_) {
    const auto [place, is_new] = files_.try_emplace(path);
    File& file = place->second;
    file.is_complete = file.is_complete && from.is_complete;
    if (!is_new) continue;
    file.comments = std::move(from.comments);
    for (Comment& comment : file.comments) {
      comment.span = shift(comment.span);
      comment.removal = shift(comment.removal);
      for (Item& item : comment.items) {
        item.span = shift(item.span);
        item.removal = shift(item.removal);
      }
    }
  }
}

std::size_t Suppressions::apply(std::vector<Diagnostic>& diagnostics, const SourceMap& sources,
                                const RuleSelection& selection) {
  std::vector<bool> is_silent(diagnostics.size());
  const auto path_of = [&](const Diagnostic& one) -> const std::string& {
    return sources.path(one.span.source);
  };
  for (auto& [path, file] : files_) {
    const auto first = std::lower_bound(
        diagnostics.begin(), diagnostics.end(), path,
        [&](const Diagnostic& one, const std::string& wanted) { return path_of(one) < wanted; });
    auto last = first;
    while (last != diagnostics.end() && path_of(*last) == path) ++last;
    const auto skipped = static_cast<std::size_t>(first - diagnostics.begin());
    const auto count = static_cast<std::size_t>(last - first);
    const std::span found = std::span(diagnostics).subspan(skipped, count);
    for (const std::size_t i : silence(found, file.comments)) {
      is_silent[skipped + i] = true;
    }
  }
  std::size_t index = 0;
  const std::size_t count =
      std::erase_if(diagnostics, [&](const Diagnostic&) { return is_silent[index++]; });

  DiagnosticSink sink;
  for (const auto& [path, file] : files_) {
    if (file.comments.empty()) continue;
    std::map<std::string_view, bool> have_run;  // many items may query it
    FileSelection selected(selection, path);
    const auto is_unused = [&, &file = file](const Item& item) {
      if (item.is_used || !file.is_complete) return false;
      const auto [known, is_new] = have_run.try_emplace(item.name, false);
      if (is_new) known->second = has_run(item.name, selection, selected);
      return known->second;
    };
    for (const Comment& comment : file.comments) judge(comment, is_unused, sink);
  }
  std::vector<Diagnostic> judged = sink.take();
  std::move(judged.begin(), judged.end(), std::back_inserter(diagnostics));
  return count;
}

/// A sweep over the file, so the cost of many comments and findings is that of sorting them.
std::vector<std::size_t> Suppressions::silence(std::span<const Diagnostic> diagnostics,
                                               std::vector<Comment>& comments) {
  struct Scope {
    std::uint32_t begin, end;
    Item* item;
  };
  std::map<std::string_view, std::vector<Scope>> by_name;
  for (Comment& comment : comments) {
    for (Item& item : comment.items) {
      if (is_known(item.name)) by_name[item.name].push_back({comment.begin, comment.end, &item});
    }
  }
  std::vector<std::size_t> silent;
  for (auto& [name, scopes] : by_name) {
    std::stable_sort(scopes.begin(), scopes.end(),
                     [](const Scope& a, const Scope& b) { return a.begin < b.begin; });
    std::multimap<std::uint32_t, Item*> around;  // sorted by end: the first is the narrowest
    auto next = scopes.begin();
    for (std::size_t i = 0; i < diagnostics.size(); ++i) {
      if (!matches(*diagnostics[i].rule, name)) continue;
      const std::uint32_t at = diagnostics[i].span.begin;
      for (; next != scopes.end() && next->begin <= at; ++next)
        around.emplace(next->end, next->item);
      around.erase(around.begin(), around.upper_bound(at));
      if (around.empty()) continue;
      around.begin()->second->is_used = true;
      silent.push_back(i);
    }
  }
  return silent;
}

void Suppressions::judge(const Comment& comment, const std::function<bool(const Item&)>& is_unused,
                         DiagnosticSink& sink) {
  if (!comment.problem.empty()) {
    sink.report(rules::sml9101_malformed_suppression, comment.span,
                "this comment silences nothing: " + comment.problem)
        .help("write `smurf-lint: ignore[" + comment.rule_named + "] reason`");
    return;
  }
  const bool is_all_unused = std::all_of(comment.items.begin(), comment.items.end(), is_unused);
  for (const Item& item : comment.items) {
    if (!is_known(item.name)) {
      report_unknown_rule(item.span, item.name, sink);
    } else if (is_unused(item)) {
      Diagnostic& diagnostic = sink.report(rules::sml9103_unused_suppression, item.span,
                                           "there is no finding of `" + item.name + "` here");
      diagnostic.help("remove it");
      const Span removal = is_all_unused ? comment.removal : item.removal;
      if (!removal.empty()) diagnostic.fixes.push_back({Applicability::safe, {{removal, ""}}});
    }
  }
}

}  // namespace smurf
