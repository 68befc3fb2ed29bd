// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/rename.hpp"

#include <algorithm>
#include <compare>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "ast/notation.hpp"
#include "base/files/path.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"
#include "smurf/yaml.hpp"

namespace smurf {
namespace {

using Loaded = std::span<const std::vector<Reference>>;

/// Longer lists would not be read.
constexpr std::size_t kMostProblems = 20;

/// The owner of a name: a loaded model, or the scene.
struct Owner {
  std::size_t loaded = 0;
  ModelIndex model{};
  friend bool operator<(const Owner& a, const Owner& b) {
    return std::tie(a.loaded, a.model) < std::tie(b.loaded, b.model);
  }
};

/// A name, as used in one model.
struct OwnedName {
  Owner owner;
  NameKind kind{};
  std::string_view name;
  friend bool operator<(const OwnedName& a, const OwnedName& b) {
    return std::tie(a.owner, a.kind, a.name) < std::tie(b.owner, b.kind, b.name);
  }
};

std::string place_text(const SourceMap& sources, Span span) {
  const Position at = sources.position(span.source, span.begin);
  return sources.path(span.source) + ":" + std::to_string(at.line) + ":" +
         std::to_string(at.column);
}

std::string thing(NameKind kind, std::string_view name) {
  return std::string(to_string(kind)) + " " + quoted(name);
}

/// Whether a plain scalar would be read as this text in block and flow style.
bool is_plain(std::string_view text) {
  constexpr std::string_view kIndicators = "-?:,[]{}#&*!|>'\"%@`";
  if (text.empty() || trimmed(text).size() != text.size() ||
      kIndicators.find(text.front()) != text.npos || text.find_first_of(",[]{}\n") != text.npos ||
      text.find(": ") != text.npos || text.find(" #") != text.npos || text.ends_with(':')) {
    return false;
  }
  const bool has_meaning = text == "=" || text == "<<";  // in YAML 1.1
  return yaml::classify(text, yaml::Style::plain) == yaml::ScalarType::text && !has_meaning &&
         !text_by_yaml11(text);
}

std::string with_doubled(std::string_view text, std::string_view which, char before) {
  std::string result;
  for (const char c : text) {
    if (which.find(c) != std::string_view::npos) result += before == '\0' ? c : before;
    result += c;
  }
  return result;
}

/// Escapes a text for an attribute in these quotes, or for character data, which must not contain
/// `]]>`. Escapes nothing else.
std::string escape_for(std::string_view text, char quote) {
  std::string result;
  for (const char c : text) {
    if (c == '>' && result.ends_with("]]")) {
      result += "&gt;";
      continue;
    }
    const bool is_special = c == '&' || c == '<' || c == quote;
    result += is_special ? escape_xml(std::string_view(&c, 1)) : std::string(1, c);
  }
  return result;
}

constexpr std::string_view kDigits = "0123456789";

/// Whether xacro copies a part of a name as it is.
bool is_plain_part(std::string_view part) {
  constexpr std::string_view kInner =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_-./0123456789";
  return part.find_first_not_of(kInner) == part.npos;
}

/// Whether xacro copies a name as it is, wherever it stands.
bool is_plain_name(std::string_view name) {
  constexpr std::string_view kRead[] = {"true", "True", "false", "False", "inf", "nan", "infinity"};
  const bool is_word = std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead);
  return !is_word && kDigits.find(name.front()) == name.npos && name.front() != '.' &&
         name.front() != '-' && is_plain_part(name);
}

/// The bytes of a file that a rename replaces: a whole name, or the literal part of a computed one.
struct NewText {
  Span span;
  std::string text;
};

/// The piece of a computed name that makes it another one; none if a computed part would change.
std::optional<NewText> new_piece(const Reference& one, std::string_view to) {
  std::optional<NewText> best;
  std::size_t longest = 0;
  for (const xacro::Copied& piece : one.copied) {
    const std::string_view head = one.name.substr(0, piece.begin);
    const std::string_view tail = one.name.substr(piece.end);
    const std::size_t size = piece.end - piece.begin;
    if (to.size() <= head.size() + tail.size() || size <= longest) continue;
    if (!to.starts_with(head) || !to.ends_with(tail)) continue;
    longest = size;
    const std::size_t new_size = to.size() - head.size() - tail.size();
    best = NewText{piece.span, std::string(to.substr(head.size(), new_size))};
  }
  return best;
}

bool is_yaml(const Reference& one) {
  return one.notation == Reference::Notation::yaml || one.notation == Reference::Notation::yaml_key;
}

/// The names that change in one text.
struct ChangedText {
  const Reference* reference = nullptr;                         ///< one of them
  std::map<std::uint32_t, std::pair<Span, std::string>> parts;  ///< by place
};

class Renamer {
 public:
  Renamer(Loaded loaded, std::span<const Rename> renames, const SourceMap& sources)
      : loaded_(loaded), renames_(renames), sources_(sources) {}

  Renamed run() {
    for (const Rename& rename : renames_) choose(rename);
    check_clashes();
    if (result_.problems.empty()) collect();
    if (result_.problems.empty()) apply();
    if (!result_.problems.empty()) result_ = {{}, {}, std::move(result_.problems)};
    return std::move(result_);
  }

 private:
  void fail(std::string problem) {
    auto& all = result_.problems;
    if (all.size() >= kMostProblems) return;
    if (std::find(all.begin(), all.end(), problem) == all.end()) all.push_back(std::move(problem));
  }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i < loaded_.size(); ++i) {
      for (const Reference& one : loaded_[i]) visit(Owner{i, one.model}, one);
    }
  }

  static bool is_of(const Rename& rename, const Reference& one) {
    return !rename.kind || *rename.kind == one.kind;
  }

  /// Files are identified by their paths, because several loads may have read the same file.
  std::pair<std::string_view, std::uint32_t> place_of(const Reference& one) const {
    return {sources_.path(one.span.source), one.span.begin};
  }

  /// Finds the owners of the name; several models may share the file.
  void choose(const Rename& rename) {
    if (rename.to.empty() || !utf8::is_printable(rename.to)) {
      return fail("'" + utf8::replace_controls(rename.to) + "' is not a name");
    }
    std::map<Owner, const Reference*> owners;
    std::set<NameKind> kinds;
    for_each([&](Owner owner, const Reference& one) {
      // A material may be used without a definition.
      const bool is_it = one.is_definition || one.kind == NameKind::material;
      if (!is_it || one.name != rename.from || !is_of(rename, one)) return;
      owners.emplace(owner, &one);
      kinds.insert(one.kind);
    });
    if (owners.empty()) return fail(unknown(rename));
    if (kinds.size() > 1) return fail(ambiguous(rename, kinds));
    const Reference& first = *owners.begin()->second;
    const std::set<Owner> tied = tied_to(owners.begin()->first, first);
    for (const auto& [owner, definition] : owners) {
      if (place_of(*definition) != place_of(first) && !tied.contains(owner)) {
        return fail("there are two: the " + thing(first.kind, rename.from) + " of " +
                    place_text(sources_, first.span) + " and that of " +
                    place_text(sources_, definition->span) +
                    "; name only files that use one of them");
      }
      const auto [known, is_new] =
          new_names_.emplace(OwnedName{owner, first.kind, rename.from}, rename.to);
      if (!is_new && known->second != rename.to) {
        return fail("the " + thing(first.kind, rename.from) + " cannot get two names");
      }
    }
  }

  /// The owners whose thing of this name must be renamed together with that of `owner`, because a
  /// text names both: robots that include the same file.
  std::set<Owner> tied_to(Owner owner, const Reference& definition) const {
    std::set<Owner> tied{owner};
    std::set<std::pair<std::string_view, std::uint32_t>> places;
    for (std::size_t before = 0; before != tied.size() + places.size();) {
      before = tied.size() + places.size();
      for_each([&](Owner one, const Reference& use) {
        if (use.kind != definition.kind || use.name != definition.name || !use.is_known()) return;
        if (use.around != Reference::Around::no) return;  // robots may have a file beside them both
        if (tied.contains(one)) places.insert(place_of(use));
        if (places.contains(place_of(use))) tied.insert(one);
      });
    }
    return tied;
  }

  std::string unknown(const Rename& rename) const {
    const std::string kind(rename.kind ? to_string(*rename.kind) : "name");
    std::vector<std::string_view> known;
    for_each([&](Owner, const Reference& one) {
      if (one.is_definition && is_of(rename, one)) known.push_back(one.name);
    });
    const auto near = only_nearest(rename.from, known);
    return "there is no " + kind + " " + quoted(rename.from) +
           (near ? "; did you mean " + quoted(*near) + "?" : std::string());
  }

  static std::string ambiguous(const Rename& rename, const std::set<NameKind>& kinds) {
    std::string words, ways;
    for (const NameKind kind : kinds) {
      words += (words.empty() ? "a " : " and a ") + std::string(to_string(kind));
      ways += (ways.empty() ? "" : " or ") + std::string(to_string(kind)) + ":" + rename.from;
    }
    return quoted(rename.from) + " is " + words + "; write " + ways;
  }

  /// Thousands of models may share the renamed thing.
  void check_clashes() {
    std::set<OwnedName> wanted;
    for (const auto& [name, to] : new_names_) {
      if (!wanted.insert({name.owner, name.kind, to}).second) {
        fail("two things cannot get the same name " + quoted(to));
      }
    }
    for_each([&](Owner owner, const Reference& one) {
      const OwnedName name{owner, one.kind, one.name};
      if (!one.is_definition || !wanted.contains(name) || new_names_.contains(name)) return;
      fail("there is a " + thing(one.kind, one.name) + " already, at " +
           place_text(sources_, one.span));
    });
  }

  void collect() {
    for_each([&](Owner owner, const Reference& one) {
      if (!one.is_known()) return;
      const auto found = new_names_.find(OwnedName{owner, one.kind, one.name});
      if (found == new_names_.end()) return;
      const bool is_alias = one.span.begin >= one.text.end || one.span.end <= one.text.begin;
      NewText change{is_alias ? inside(one.text) : one.span, found->second};
      if (one.is_computed) {
        std::optional<NewText> piece = new_piece(one, found->second);
        if (!piece) return fail(computed(one));
        change = std::move(*piece);
      }
      ChangedText& text = texts_[key_of(one, change.span)];
      if (text.reference == nullptr) text.reference = &one;
      const bool is_in_xacro =
          one.is_computed || path::extension(sources_.path(change.span.source)) == ".xacro";
      if (is_in_xacro &&
          !(one.is_computed ? is_plain_part(change.text) : is_plain_name(change.text))) {
        fail(quoted(found->second) + " could be read as an expression or a number at " +
             place_text(sources_, change.span) + "; use letters, digits and `_`");
      }
      // In a program, or in a list of words such as `args="0 0 1 base laser"`.
      const bool is_inside = one.around != Reference::Around::no && one.span != one.text;
      const bool is_in_program = one.notation == Reference::Notation::program;
      if ((is_inside || is_in_program) && !is_plain_name(change.text)) {
        fail(quoted(found->second) + " could be read as something else at " +
             place_text(sources_, change.span) + "; use letters, digits and `_`");
      }
      const auto [known, is_new] =
          text.parts.try_emplace(change.span.begin, change.span, change.text);
      const auto& [place, text_there] = known->second;  // of the same file, perhaps read again
      if (!is_new && (place.end != change.span.end || text_there != change.text)) {
        fail("the text at " + place_text(sources_, one.text) + " names two things");
      }
    });
    // Other references in these texts would also change.
    for_each([&](Owner owner, const Reference& one) {
      if (!one.is_known() || new_names_.contains(OwnedName{owner, one.kind, one.name})) return;
      if (!one.is_computed) return check_other(one, one.span);
      // The name of a transmission may be made from that of its joint.
      if (one.kind != NameKind::link && one.kind != NameKind::joint) return;
      for (const xacro::Copied& piece : one.copied) check_other(one, piece.span);
    });
  }

  /// Parts of a text of XML change independently of each other.
  std::pair<std::string_view, std::uint32_t> key_of(const Reference& one, Span part) const {
    const Span span = is_yaml(one) ? one.text : part;
    return {sources_.path(span.source), span.begin};
  }

  void check_other(const Reference& one, Span part) {
    const auto text = texts_.find(key_of(one, part));
    if (text == texts_.end() || !text->second.parts.contains(part.begin)) return;
    fail("the text at " + place_text(sources_, part) + " also names the " +
         thing(one.kind, one.name));
  }

  /// Why a computed name cannot change.
  std::string computed(const Reference& one) const {
    const std::string place = place_text(sources_, one.span);
    const auto longest = std::max_element(one.copied.begin(), one.copied.end(),
                                          [](const xacro::Copied& a, const xacro::Copied& b) {
                                            return a.end - a.begin < b.end - b.begin;
                                          });
    if (longest == one.copied.end()) {
      return "the " + thing(one.kind, one.name) + " is made by an expression at " + place +
             "; change it there";
    }
    std::string form(one.name.substr(0, longest->begin));
    form.append("NEW").append(one.name.substr(longest->end));
    return "only a part of the " + thing(one.kind, one.name) +
           " is written as it is, the rest is made by an expression at " + place +
           "; choose a name like " + quoted(form);
  }

  Span inside(Span scalar) const {
    const std::string_view text = sources_.text(scalar);
    const bool is_quoted = text.starts_with('\'') || text.starts_with('"');
    return is_quoted ? Span{scalar.source, scalar.begin + 1, scalar.end - 1} : scalar;
  }

  /// Adds the edits of one text.
  void edit(const ChangedText& text, std::vector<Edit>& edits) {
    const Span whole = text.reference->text;
    const std::string_view raw = sources_.text(whole);
    const bool is_in_yaml = is_yaml(*text.reference);
    const char first = raw.empty() ? '\0' : raw.front();
    if (is_in_yaml && (first == '|' || first == '>')) {
      return fail("the name at " + place_text(sources_, whole) + " spans several lines");
    }
    std::vector<Edit> plain;
    for (const auto& [begin, part] : text.parts) {
      const auto& [span, to] = part;
      if (is_in_yaml && first == '\'') {
        edits.push_back({span, with_doubled(to, "'", '\'')});
      } else if (is_in_yaml && first == '"') {
        edits.push_back({span, with_doubled(to, "\"\\", '\\')});
      } else if (is_in_yaml) {
        plain.push_back({{span.source, span.begin - whole.begin, span.end - whole.begin}, to});
      } else {
        const bool is_attribute = !text.reference->is_computed &&
                                  text.reference->notation == Reference::Notation::xml_attribute;
        const char quote = is_attribute ? sources_.text(whole.source)[whole.begin - 1] : '\0';
        edits.push_back({span, escape_for(to, quote)});
      }
    }
    if (plain.empty()) return;
    std::string changed = apply_edits(raw, plain);
    // Within a text that needs no quotes, such as `joints(shoulder,elbow)`, a name of letters does
    // not make them necessary.
    const bool is_inside = std::all_of(text.parts.begin(), text.parts.end(), [&](const auto& part) {
      return part.first > whole.begin && is_plain_name(part.second.second);
    });
    if (!is_inside && !is_plain(changed))
      changed = "\"" + with_doubled(changed, "\"\\", '\\') + "\"";
    edits.push_back({whole, std::move(changed)});
  }

  void apply() {
    std::map<std::string_view, std::vector<Edit>> files;
    std::map<std::string_view, SourceId> ids;
    for (const auto& [place, text] : texts_) {
      edit(text, files[place.first]);
      ids.emplace(place.first, text.reference->text.source);
    }
    for (const auto& [path, edits] : files) {
      const std::string_view before = sources_.text(ids.at(path));
      std::string after = apply_edits(before, edits);
      if (after == before) continue;
      result_.texts.push_back({std::string(path), std::move(after)});
      result_.edits.insert(result_.edits.end(), edits.begin(), edits.end());
    }
  }

  Loaded loaded_;
  std::span<const Rename> renames_;
  const SourceMap& sources_;
  std::map<OwnedName, std::string> new_names_;
  /// Sorted by file and position.
  std::map<std::pair<std::string_view, std::uint32_t>, ChangedText> texts_;
  Renamed result_;
};

bool means_the_same(const Reference& a, const Reference& b) {
  return a.kind == b.kind && a.item == b.item && a.model == b.model && a.kinds == b.kinds &&
         a.is_definition == b.is_definition && a.place == b.place;
}

}  // namespace

Renamed rename(std::span<const std::vector<Reference>> loaded, std::span<const Rename> renames,
               const SourceMap& sources) {
  return Renamer(loaded, renames, sources).run();
}

std::vector<std::string> changed_meanings(std::span<const std::vector<Reference>> before,
                                          std::span<const std::vector<Reference>> after,
                                          const SourceMap& sources) {
  std::vector<std::string> changed;
  // RViz may remember a link of another robot, and does nothing with a name that it does not know.
  const auto skip_memory = [](auto at, auto end) {
    return std::find_if(
        at, end, [](const Reference& one) { return one.around != Reference::Around::memory; });
  };
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto& old = before[i];
    const std::vector<Reference> none;
    const auto& now = i < after.size() ? after[i] : none;
    auto a = skip_memory(old.begin(), old.end());
    auto b = skip_memory(now.begin(), now.end());
    while (a != old.end() && b != now.end() && means_the_same(*a, *b)) {
      a = skip_memory(std::next(a), old.end());
      b = skip_memory(std::next(b), now.end());
    }
    if (b != now.end()) {
      changed.push_back(place_text(sources, b->span) + ": " + quoted(b->name) +
                        " would refer to something else than before");
    } else if (a != old.end()) {
      changed.push_back(place_text(sources, a->span) + ": " + quoted(a->name) +
                        " would no longer refer to anything");
    }
  }
  return changed;
}

}  // namespace smurf
