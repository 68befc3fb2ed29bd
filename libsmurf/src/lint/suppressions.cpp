// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "base/quoted.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"
#include "smurf/suppress.hpp"

namespace smurf {

namespace {

constexpr std::string_view kMarker = "smurf-lint:";
constexpr std::string_view kBlank = " \t";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::uint32_t offset(std::size_t size) { return static_cast<std::uint32_t>(size); }

/// The line around a byte, without its line end.
std::pair<std::size_t, std::size_t> line_around(std::string_view text, std::size_t at) {
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return {begin, std::min(text.find('\n', at), text.size())};
}

bool is_known(std::string_view name) {
  const auto rules = all_rules();
  return std::any_of(rules.begin(), rules.end(),
                     [&](const Rule* rule) { return matches(*rule, name); });
}

/// Whether smurf-lint would have found here whatever there is to find of the rules of that name.
/// Findings that depend on targets appear only when each reader with an opinion is a target, and
/// those of the other tools (SML6, SML8) never.
bool has_run(std::string_view name, const std::string& path, const RuleSelection& selection) {
  const auto has_run_in_full = [&](const Rule& rule) {
    if (rule.id.starts_with("SML6") || rule.id.starts_with("SML8")) return false;
    if (!selection.is_enabled(rule, path)) return false;
    const auto& targets = selection.targets;
    const auto readers = all_readers();
    return !rule.needs_target ||
           std::all_of(readers.begin(), readers.end(), [&](const Reader* reader) {
             return !reader->is_target || !has_facts(*reader, rule) ||
                    std::find(targets.begin(), targets.end(), reader) != targets.end();
           });
  };
  const auto rules = all_rules();
  return std::all_of(rules.begin(), rules.end(), [&](const Rule* rule) {
    return !matches(*rule, name) || has_run_in_full(*rule);
  });
}

/// "there is no rule `SML31O1`", and which is meant.
void report_unknown_rule(Span span, std::string_view name, DiagnosticSink& sink) {
  Diagnostic& diagnostic = sink.report(rules::sml9102_unknown_rule, span,
                                       "there is no rule `" + std::string(name) + "`");
  std::vector<std::string_view> known;
  for (const Rule* rule : all_rules()) known.push_back(rule->id);
  for (const Rule* rule : all_rules()) known.push_back(rule->name);
  if (const auto near = nearest(name, known)) {
    diagnostic.help = "did you mean `" + std::string(*near) + "`?";
    diagnostic.fixes.push_back({Applicability::unsafe, {{span, std::string(*near)}}});
  }
}

bool is_all_blank(std::string_view text) { return std::all_of(text.begin(), text.end(), is_blank); }

}  // namespace

/// Reads the comments of one file.
class Suppressions::Reader {
 public:
  Reader(std::string_view text, SourceId source, std::vector<Comment>& comments)
      : text_(text), source_(source), comments_(comments) {}

  void read(const yaml::Document& document) {
    for (std::size_t at = text_.find(kMarker); at != std::string_view::npos;
         at = text_.find(kMarker, at + 1)) {
      const std::size_t hash = text_.find_last_not_of(kBlank, at == 0 ? 0 : at - 1);
      if (at == 0 || hash == std::string_view::npos || text_[hash] != '#') continue;
      if (hash > 0 && !is_blank(text_[hash - 1]) && text_[hash - 1] != '\n') continue;
      if (is_in_scalar(document, offset(hash))) continue;
      add({source_, offset(hash), offset(line_around(text_, at).second)}, at,
          [&](std::uint32_t end) { return next_entry(document, end); });
    }
  }

  void read(const xml::Document& document) {
    for (const Span comment : document.comments) {
      const std::string_view body = text_.substr(comment.begin, comment.end - comment.begin);
      const std::size_t at = body.find_first_not_of(" \t\r\n", 4);
      if (at == std::string_view::npos || !body.substr(at).starts_with(kMarker)) continue;
      add(comment, comment.begin + at,
          [&](std::uint32_t end) { return next_element(document, end); });
    }
  }

 private:
  using Range = std::pair<std::uint32_t, std::uint32_t>;

  static bool is_in_scalar(const yaml::Document& document, std::uint32_t at) {
    const yaml::NodeId id = yaml::node_at(document, at);
    if (id == yaml::kNoNode) return false;
    const yaml::Node& node = document.nodes[static_cast<std::size_t>(id)];
    if (node.key_span().contains(at)) return true;
    return node.kind() == yaml::Kind::scalar && node.span.contains(at);
  }

  /// The outermost entry, which is not the whole file, that begins behind the comment.
  static Range next_entry(const yaml::Document& document, std::uint32_t end) {
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
      if (yaml::NodeId{offset(i)} == document.root) continue;
      const yaml::Node& node = document.nodes[i];
      const std::uint32_t begin = node.key_span().empty() ? node.span.begin : node.key_span().begin;
      if (begin >= end) return {begin, std::max(node.key_span().end, node.span.end)};
    }
    return {end, end};
  }

  static Range next_element(const xml::Document& document, std::uint32_t end) {
    const auto next = std::find_if(document.elements.begin(), document.elements.end(),
                                   [&](const xml::Element& one) { return one.span.begin >= end; });
    if (next == document.elements.end()) return {end, end};
    return {next->span.begin, next->span.end};
  }

  /// `at` is the marker. `find_next` gives what a comment on a line of its own speaks of.
  template <class FindNext>
  void add(Span span, std::size_t at, const FindNext& find_next) {
    const auto [line_begin, ignored] = line_around(text_, span.begin);
    const std::size_t line_end = line_around(text_, span.end).second;
    const bool has_text_before = !is_all_blank(text_.substr(line_begin, span.begin - line_begin));
    const bool is_alone =
        !has_text_before && is_all_blank(text_.substr(span.end, line_end - span.end));
    Comment comment{span, span, 0, 0, {}, {}};
    if (is_alone) {
      const std::size_t after = std::min(line_end + 1, text_.size());
      comment.removal = {source_, offset(line_begin), offset(after)};
    } else {
      const std::size_t before =
          text_.find_last_not_of(kBlank, span.begin == 0 ? 0 : span.begin - 1);
      comment.removal.begin = before == std::string_view::npos ? 0 : offset(before + 1);
    }
    std::tie(comment.begin, comment.end) =
        has_text_before ? Range{offset(line_begin), offset(line_end) + 1} : find_next(span.end);

    std::string_view words = text_.substr(at + kMarker.size(), span.end - at - kMarker.size());
    const std::size_t skipped = std::min(words.find_first_not_of(kBlank), words.size());
    read_words(words.substr(skipped), at + kMarker.size() + skipped, comment);
    comments_.push_back(std::move(comment));
  }

  void read_words(std::string_view words, std::size_t at, Comment& comment) const {
    const std::size_t open = std::min(words.find_first_of("[ \t\r\n"), words.size());
    const std::string_view verb = words.substr(0, open);
    if (verb != "ignore" && verb != "ignore-file") {
      comment.problem = quoted(verb) + " is neither `ignore` nor `ignore-file`";
      return;
    }
    const std::size_t close = words.find(']');
    if (open == words.size() || words[open] != '[' || close == std::string_view::npos) {
      comment.problem = "the rules are missing: `" + std::string(verb) + "[SML3101]`";
      return;
    }
    if (verb == "ignore-file") {
      comment.begin = 0;
      comment.end = offset(text_.size()) + 1;
    }
    read_items(words.substr(open + 1, close - open - 1), at + open + 1, comment);
    if (comment.items.empty()) comment.problem = "it names no rule";
  }

  /// "SML3101, unknown-link"; an item goes with the comma before it, the first with that behind it.
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
};

/// A file is read once; what is missing where one model uses it may be found where another does,
/// so that it is complete only where every one of them is.
template <class Document>
void Suppressions::add(const Document& document, bool is_complete, const SourceMap& sources) {
  const auto [file, is_new] = files_.try_emplace(sources.path(document.source));
  file->second.is_complete = file->second.is_complete && is_complete;
  if (!is_new) return;
  Reader(sources.text(document.source), document.source, file->second.comments).read(document);
}

void Suppressions::add(const LinkedModel& model, const SourceMap& sources) {
  for (const ModelFile& file : model.files) {
    if (file.document) add(*file.document, model.is_complete, sources);
  }
  if (model.robot) add(model.robot->document, model.is_complete, sources);
}

void Suppressions::add(const LinkedScene& scene, const SourceMap& sources) {
  for (const SceneFile& file : scene.scenes) {
    if (file.drawing) {
      add(*file.drawing, scene.is_complete, sources);
    } else if (file.document) {
      add(*file.document, scene.is_complete, sources);
    }
  }
  for (const DataFile& file : scene.data_files) add(file.document, scene.is_complete, sources);
  for (const LinkedModel& model : scene.models) add(model, sources);
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
    for (const std::size_t i : silence(std::span(first, last), file.comments)) {
      is_silent[skipped + i] = true;
    }
  }
  std::size_t index = 0;
  const std::size_t count =
      std::erase_if(diagnostics, [&](const Diagnostic&) { return is_silent[index++]; });

  DiagnosticSink sink;
  for (const auto& [path, file] : files_) {
    const auto is_unused = [&, &path = path, &file = file](const Item& item) {
      return !item.is_used && file.is_complete && has_run(item.name, path, selection);
    };
    for (const Comment& comment : file.comments) judge(comment, is_unused, sink);
  }
  std::vector<Diagnostic> judged = sink.take();
  std::move(judged.begin(), judged.end(), std::back_inserter(diagnostics));
  return count;
}

/// A sweep over the file, so that many comments and many findings cost no more than sorting them.
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
    std::multimap<std::uint32_t, Item*> around;  // by their ends: the first is the narrowest
    auto next = scopes.begin();
    for (std::size_t i = 0; i < diagnostics.size(); ++i) {
      const std::uint32_t at = diagnostics[i].span.begin;
      for (; next != scopes.end() && next->begin <= at; ++next)
        around.emplace(next->end, next->item);
      around.erase(around.begin(), around.upper_bound(at));
      if (around.empty() || !matches(*diagnostics[i].rule, name)) continue;
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
        .help = "write `smurf-lint: ignore[SML3101] reason`";
    return;
  }
  const bool is_all_unused = std::all_of(comment.items.begin(), comment.items.end(), is_unused);
  for (const Item& item : comment.items) {
    if (!is_known(item.name)) {
      report_unknown_rule(item.span, item.name, sink);
    } else if (is_unused(item)) {
      Diagnostic& diagnostic = sink.report(rules::sml9103_unused_suppression, item.span,
                                           "nothing here raises `" + item.name + "`");
      diagnostic.help = "remove it";
      diagnostic.fixes.push_back(
          {Applicability::safe, {{is_all_unused ? comment.removal : item.removal, ""}}});
    }
  }
}

}  // namespace smurf
