// SPDX-License-Identifier: BSD-3-Clause
// The arguments of a robot of xacro for which an SRDF is meant.
#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "link/companions/companion_names.hpp"
#include "link/companions/places.hpp"
#include "link/package_search.hpp"
#include "link/xacro_model.hpp"
#include "smurf/companions.hpp"
#include "smurf/xacro.hpp"
#include "xacro/seen_arguments.hpp"
#include "xacro/whole_word.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostTrials = 24;           // expansions for one SRDF
constexpr std::size_t kMostValuesOfArgument = 6;  // of one
constexpr std::size_t kMostFilesOfXacro = 400;    // of xacro, around the robot
constexpr std::uint64_t kMostBytesOfXacro = 1U << 20U;
constexpr std::uint64_t kMostBytesOfNames = 1U << 30U;  // that are searched for one SRDF, by name

using Values = std::map<std::string, std::vector<std::string>>;
using Arguments = std::map<std::string, std::string>;

bool is_integer(std::string_view text) {
  return !text.empty() && text.size() <= 3 && std::all_of(text.begin(), text.end(), is_digit);
}

/// The numbers in a text: 6 in "config/6dof".
std::set<std::string> integers_in(std::string_view text) {
  std::set<std::string> found;
  for (std::size_t at = 0; at < text.size();) {
    if (!is_digit(text[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    if (is_integer(text.substr(begin, at - begin))) found.emplace(text.substr(begin, at - begin));
  }
  return found;
}

/// The literals with which a text compares a name: 6 in `${dof == 6}`.
std::set<std::string> compared_with(std::string_view text, std::string_view name) {
  std::set<std::string> found;
  for (std::size_t at = xacro::find_name(text, name); at != text.npos;
       at = xacro::find_name(text, name, at + name.size())) {
    std::size_t next = at + name.size();
    next = text.find_first_not_of(")'\" \t", next);
    if (next == text.npos || text.substr(next + 1, 1) != "=") continue;
    if (text[next] != '=' && text[next] != '!') continue;
    next = text.find_first_not_of("'\" \t", next + 2);
    if (next == text.npos) break;
    const std::size_t end = text.find_first_of("'\" \t)}<>&", next);
    if (end != text.npos && end > next && end - next < 40) {
      found.emplace(text.substr(next, end - next));
    }
  }
  return found;
}

struct ArgumentValue {
  std::string name, value;  ///< what it has now
};

/// The arguments that the files of an expansion declare.
std::vector<ArgumentValue> declared_arguments(const xacro::Expansion& expansion,
                                              const Arguments& given) {
  std::vector<ArgumentValue> found;
  for (const xml::Document& document : expansion.documents) {
    for (const xml::Element& element : document.elements) {
      if (element.name() != "xacro:arg") continue;
      const xml::View view(document, xml::ElementId(&element - document.elements.data()));
      const xml::Attribute* name = view.attribute("name");
      const xml::Attribute* value = view.attribute("default");
      if (name == nullptr || given.contains(std::string(name->value()))) continue;
      found.push_back({std::string(name->value()),
                       value == nullptr ? std::string() : std::string(value->value())});
    }
  }
  return found;
}

/// A context that loads the same files, and reports to another sink.
LoadContext quiet_context(const LoadContext& context, SourceMap& sources, DiagnosticSink& sink) {
  LoadContext quiet{sources,          context.files,           sink,    context.limits,
                    context.packages, context.package_folders, nullptr, context.schemas};
  quiet.limits.xacro_steps = steps_of_trial(context.limits);
  quiet.xacro = context.xacro;
  return quiet;
}

class VariantSearch {
 public:
  VariantSearch(const LinkedModel& model, const Values& values, LoadContext& context)
      : model_(model), values_(values), context_(context) {
    if (!model.robot) return;
    const auto expansion = context.expansions->find(model.robot->document.source);
    if (expansion == context.expansions->end()) return;
    arguments_ = declared_arguments(expansion->second, context.xacro.arguments);
    for (const xml::Document& document : expansion->second.documents) {
      texts_.push_back(context.sources.text(document.source));
    }
  }

  /// The values of arguments that give the robot the most names of a companion; none if these are
  /// its defaults.
  std::optional<Arguments> best_for(Companion& companion) {
    const std::vector<ArgumentValue> choices = choices_for(companion);
    Arguments best;
    const std::size_t before = companion.known_names;
    std::size_t known = before, trials = 0;
    for (bool is_better = true; is_better && known < companion.names;) {
      is_better = false;
      const Arguments from = best;
      for (const ArgumentValue& choice : choices) {
        Deadline::look();
        if (from.contains(choice.name)) continue;
        if (++trials > kMostTrials || known == companion.names) break;
        Arguments tried = from;
        tried.emplace(choice.name, choice.value);
        const std::size_t count = count_with(tried, companion);
        if (count <= known) continue;
        known = count;
        best = std::move(tried);
        is_better = true;
      }
    }
    companion.known_names = before;
    return best.empty() ? std::nullopt : std::optional(std::move(best));
  }

 private:
  /// Values that arguments may have, the likeliest first.
  std::vector<ArgumentValue> choices_for(const Companion& companion) const {
    const std::string& srdf = context_.sources.path(companion.source);
    std::vector<std::string> names;
    for (const ArgumentValue& one : arguments_) names.push_back(one.name);
    std::vector<xacro::SeenArgument> seen =
        xacro::seen_arguments(model_.urdf_path, names, context_.files);
    for (auto& one : xacro::seen_arguments(srdf, names, context_.files)) seen.push_back(one);
    std::vector<std::vector<std::string>> values;  // of each argument
    for (const ArgumentValue& one : arguments_) {
      std::vector<std::string>& all = values.emplace_back();
      const auto add = [&](const std::string& value) {
        const bool is_new = std::find(all.begin(), all.end(), value) == all.end();
        if (is_new && value != one.value && all.size() < kMostValuesOfArgument)
          all.push_back(value);
      };
      if (const auto wished = values_.find(one.name); wished != values_.end()) {
        for (const std::string& value : wished->second) add(value);
      }
      const std::string lower = path::to_lower(one.value);
      if (is_integer(one.value)) {
        for (const std::string& value : integers_in(srdf)) add(value);
      }
      if (lower == "true" || lower == "false") add(lower == "true" ? "false" : "true");
      for (const std::string_view text : texts_) {
        for (const std::string& value : compared_with(text, one.name)) add(value);
      }
      for (const xacro::SeenArgument& other : seen) {
        if (other.name == one.name) add(other.value);
      }
    }
    std::vector<ArgumentValue> choices;
    for (std::size_t i = 0; i < kMostValuesOfArgument; ++i) {
      for (std::size_t of = 0; of < arguments_.size(); ++of) {
        if (i < values[of].size()) choices.push_back({arguments_[of].name, values[of][i]});
      }
    }
    return choices;
  }

  /// How many names the robot has with these arguments.
  std::size_t count_with(const Arguments& arguments, Companion& companion) {
    const auto [known, is_new] = models_.try_emplace(arguments);
    if (is_new) known->second = load(arguments);
    count_names(known->second->model, companion);
    return companion.known_names;
  }

  struct Trial {
    SourceMap sources;
    LinkedModel model;
  };

  std::unique_ptr<Trial> load(const Arguments& arguments) const {
    auto trial = std::make_unique<Trial>();
    DiagnosticSink ignored(context_.limits);
    LoadContext inner = quiet_context(context_, trial->sources, ignored);
    inner.xacro.arguments.insert(arguments.begin(), arguments.end());
    trial->model = load_model(model_.path, inner);
    return trial;
  }

  const LinkedModel& model_;
  const Values& values_;  ///< of arguments, in the configuration
  LoadContext& context_;
  std::vector<ArgumentValue> arguments_;
  std::vector<std::string_view> texts_;  ///< of the files of the robot
  std::map<Arguments, std::unique_ptr<Trial>> models_;
};

std::string shown_arguments(const Arguments& arguments) {
  std::string text;
  for (const auto& [name, value] : arguments) {
    text += (text.empty() ? "" : " ") + name + ":=" + (value.empty() ? "''" : value);
  }
  return text;
}

/// Whether a text has the name as a value, or as the end of one that xacro computes.
bool writes_name(std::string_view text, std::string_view name) {
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at > 0 && (text[at - 1] == '"' || text[at - 1] == '}' ||
                                   text[at - 1] == ')' || text[at - 1] == '\'');
    if (begins && end < text.size() && (text[end] == '"' || text[end] == '\'')) return true;
  }
  return false;
}

/// Notes the unknown names that a file of xacro in the packages around the robot writes.
void note_written(const LinkedModel& model, Companion& companion, LoadContext& context) {
  std::set<std::string, std::less<>> unknown;
  for (const Reference& one : names_in_companion(model, companion)) {
    const bool is_part = one.kinds.contains(NameKind::link) || one.kinds.contains(NameKind::joint);
    if (is_part && !one.is_vague && !one.is_known()) unknown.emplace(one.name);
  }
  std::size_t count = 0;
  std::uint64_t left = kMostBytesOfNames;
  const std::string folder(path::parent(model.urdf_path));
  for (const std::string& place :
       companion_places(folder, context.files, search_of(context)).folders) {
    for (const std::string& name : context.files.list(place)) {
      if (path::extension(name) != ".xacro" || is_companion_path(name)) continue;
      if (++count > kMostFilesOfXacro || unknown.empty()) return;
      const FileContent content = context.files.read(path::join(place, name), kMostBytesOfXacro);
      if (content.status != ReadStatus::ok) continue;
      const std::uint64_t work = content.text.size() * unknown.size();
      if (work > left) return;
      left -= work;
      for (auto one = unknown.begin(); one != unknown.end();) {
        const bool is_written = writes_name(content.text, *one);
        if (is_written) companion.of_variants.insert(*one);
        one = is_written ? unknown.erase(one) : std::next(one);
      }
    }
  }
}

/// Moves a file to a variant of the robot with these arguments; an SRDF with all files beside it.
void move_to_variant(Accompanied& robot, std::size_t index, const Arguments& arguments,
                     LoadContext& context) {
  DiagnosticSink ignored(context.limits);
  LoadContext inner = quiet_context(context, context.sources, ignored);
  inner.expansions = context.expansions;
  inner.xacro.arguments.insert(arguments.begin(), arguments.end());
  Variant& variant = robot.variants.emplace_back();
  variant.model = load_model(robot.model.path, inner);
  variant.arguments = shown_arguments(arguments);
  std::vector<Companion>& files = robot.companions.files;
  const std::string folder = files[index].folder;
  const SourceId source = files[index].source;
  const bool moves_all = files[index].srdf.has_value();
  const auto moved = std::stable_partition(files.begin(), files.end(), [&](const Companion& one) {
    return moves_all ? one.folder != folder : one.source != source;
  });
  std::move(moved, files.end(), std::back_inserter(variant.companions.files));
  files.erase(moved, files.end());
  for (Companion& one : variant.companions.files) {
    count_names(variant.model, one);
    if (one.known_names < one.names) note_written(variant.model, one, context);
  }
}

}  // namespace

void split_variants(Accompanied& robot, LoadContext& context,
                    const std::map<std::string, std::vector<std::string>>& values) {
  if (!robot.model.robot || robot.model.language != Language::xacro) return;
  std::optional<VariantSearch> search;
  std::vector<Companion>& files = robot.companions.files;
  for (std::size_t i = 0; i < files.size();) {
    Companion& one = files[i];
    // A misspelt name is one with all arguments.
    const std::size_t known = one.known_names + (one.srdf ? 0 : one.near_names.size());
    if (known >= one.names || one.is_compared) {
      ++i;
      continue;
    }
    one.is_compared = true;
    if (!search) search.emplace(robot.model, values, context);
    if (const auto best = search->best_for(one)) {
      move_to_variant(robot, i, *best, context);
      i = 0;
    } else {
      note_written(robot.model, one, context);
    }
  }
}

}  // namespace smurf
