// SPDX-License-Identifier: BSD-3-Clause
#include "plan/launched_values.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "link/surroundings/stated_ties.hpp"
#include "plan/xacro_text.hpp"
#include "smurf/plan.hpp"
#include "xacro/xacro_cases.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytesOfRobot = 1U << 20U;

xacro::Expansion expand_quietly(const std::string& path, LoadContext& context,
                                const std::vector<xacro::SeenArgument>& values) {
  SourceMap sources;
  DiagnosticSink found(context.limits);
  LoadContext quiet{sources,          context.files,           found,   context.limits,
                    context.packages, context.package_folders, nullptr, context.schemas};
  quiet.xacro = context.xacro;
  quiet.xacro.needs_origins = false;
  quiet.package_search = context.package_search;
  for (const xacro::SeenArgument& one : values) {
    quiet.xacro.arguments.emplace(one.name, one.value);
  }
  return load_xacro(path, quiet);
}

/// The arguments of a file that have no value where they are used, or an empty one, which may stand
/// for none.
struct OpenArguments {
  std::set<std::string> undeclared, empty;
  std::vector<xacro::SeenArgument> defaults;  ///< that stand below the first use
};

OpenArguments open_arguments(const std::string& path, const LoadContext& context) {
  OpenArguments open;
  const std::string text = context.files.read(path, kMostBytesOfRobot).text;
  for (std::string& name : xacro::undeclared_arguments(text))
    open.undeclared.insert(std::move(name));
  for (const XacroName& one : read_xacro_text(text).names) {
    const bool is_empty = one.has_value && one.value.empty();
    if (one.kind != XacroNameKind::argument) continue;
    if (is_empty) open.empty.insert(one.name);
    const bool is_known = one.has_value && one.value.find('$') == std::string::npos;
    if (is_known && open.undeclared.contains(one.name)) {
      open.defaults.push_back({one.name, one.value, path});
    }
  }
  return open;
}

class Values {
 public:
  Values(const std::string& path, const OpenArguments& open, LoadContext& context)
      : path_(path), open_(open), context_(context) {}

  /// Adds a value for each of these names that has none; false if nothing was added.
  bool add(const std::set<std::string>& names) {
    std::vector<std::string> wanted;
    for (const std::string& name : names) {
      const bool is_given = context_.xacro.arguments.contains(name);
      if (!is_given && asked_.insert(name).second) wanted.push_back(name);
    }
    if (wanted.empty()) return false;
    // What is given to this robot counts more than what is called so.
    std::vector<xacro::SeenArgument> seen = stated();
    for (xacro::SeenArgument& one : xacro::seen_arguments(path_, wanted, context_.files)) {
      seen.push_back(std::move(one));
    }
    seen.insert(seen.end(), open_.defaults.begin(), open_.defaults.end());
    const std::size_t before = used_.size();
    for (const std::string& name : wanted) {
      const auto first =
          std::find_if(seen.begin(), seen.end(), [&](const auto& one) { return one.name == name; });
      if (first != seen.end()) used_.push_back(*first);
    }
    return used_.size() > before;
  }

  std::vector<xacro::SeenArgument>& used() { return used_; }

  const std::vector<xacro::SeenArgument>& stated() {
    if (!stated_) stated_ = stated_arguments(path_, context_);
    return *stated_;
  }

  /// All values that one file gives to the robot, for each such file.
  std::vector<std::vector<xacro::SeenArgument>> sets() {
    constexpr std::size_t kMostSets = 4;
    std::vector<std::vector<xacro::SeenArgument>> sets;
    for (const xacro::SeenArgument& one : stated()) {
      if (context_.xacro.arguments.contains(one.name)) continue;
      const bool is_new = sets.empty() || sets.back().front().file != one.file;
      if (is_new && sets.size() == kMostSets) break;
      if (is_new) sets.emplace_back();
      sets.back().push_back(one);
    }
    return sets;
  }

 private:
  const std::string& path_;
  const OpenArguments& open_;
  LoadContext& context_;
  std::optional<std::vector<xacro::SeenArgument>> stated_;
  std::vector<xacro::SeenArgument> used_;
  std::set<std::string> asked_;
};

/// Calls `use` with the context of a file that nobody loads.
template <class Use>
auto with_context(const std::map<std::string, std::string>& arguments, const FileReader& files,
                  const Limits& limits, Use&& use) {
  SourceMap sources;
  DiagnosticSink ignored(limits);
  LoadContext context{sources, files, ignored, limits, {}, ros_package_folders(), nullptr, nullptr};
  context.xacro.arguments = arguments;
  return use(context);
}

}  // namespace

std::vector<xacro::SeenArgument> launched_values(const std::string& path, LoadContext& context) {
  constexpr int kMostAttempts = 6;
  if (!xacro::is_xacro_file(path)) return {};
  const OpenArguments open = open_arguments(path, context);
  Values values(path, open, context);
  for (int i = 0; i < kMostAttempts; ++i) {
    const xacro::Expansion attempt = expand_quietly(path, context, values.used());
    if (attempt.is_complete) return std::move(values.used());
    std::set<std::string> missing;
    // A missing argument is the first of those that the file does not declare.
    if (!attempt.missing_argument.empty()) {
      missing = open.undeclared;
      missing.insert(attempt.missing_argument);
    }
    if (!values.add(missing) && !values.add(open.empty)) break;
  }
  // Some values only go together.
  std::vector<std::vector<xacro::SeenArgument>> sets = values.sets();
  for (auto& set : sets) {
    const xacro::Expansion attempt = expand_quietly(path, context, set);
    // With all values, what is wrong is wrong in the robot.
    if (attempt.is_complete || attempt.missing_argument.empty()) return std::move(set);
  }
  return {};
}

std::vector<xacro::SeenArgument>
launched_values(const std::string& path, const std::map<std::string, std::string>& arguments,
                const FileReader& files, const Limits& limits) {
  return with_context(arguments, files, limits,
                      [&](LoadContext& context) { return launched_values(path, context); });
}

void report_late_defaults(const std::string& path, const std::vector<xacro::SeenArgument>& values,
                          LoadContext& context) {
  SourceId source{};
  std::optional<XacroText> parsed;
  const auto with_values = context.xacro.arguments;
  for (const xacro::SeenArgument& one : values) context.xacro.arguments.erase(one.name);
  for (const xacro::SeenArgument& late : values) {
    if (late.file != path) continue;
    std::vector<xacro::SeenArgument> others = values;
    std::erase_if(others, [&](const auto& one) { return one.name == late.name; });
    if (expand_quietly(path, context, others).missing_argument != late.name) continue;
    if (!parsed) {
      source = context.sources.add(path, context.files.read(path, kMostBytesOfRobot).text);
      parsed = read_xacro_text(context.sources.text(source));
    }
    const auto own =
        std::find_if(parsed->names.begin(), parsed->names.end(), [&](const XacroName& one) {
          return one.kind == XacroNameKind::argument && one.name == late.name;
        });
    if (own == parsed->names.end()) continue;
    const auto span_of = [&](std::size_t begin, std::size_t end) {
      return Span{source, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    };
    const Span declared = span_of(own->place.begin, own->place.end);
    const std::string use = "$(arg " + late.name + ")";
    const std::size_t at = context.sources.text(source).find(use);
    const bool is_above = at < own->place.begin;
    Diagnostic& found = context.sink.report(
        rules::sml3313_xacro_unknown_argument, is_above ? span_of(at, at + use.size()) : declared,
        "the argument " + quoted(late.name) + " is used above its default");
    found.severity = Severity::warning;  // somebody may give a value
    found.when(xacro::kLateDefault)
        .help("move `<xacro:arg name=\"" + late.name +
              "\">` above its first use; xacro stops here otherwise");
    if (is_above) found.label(declared, "declared here");
  }
  context.xacro.arguments = with_values;
}

bool is_expandable(const std::string& path, const std::map<std::string, std::string>& arguments,
                   const FileReader& files, const Limits& limits) {
  return with_context(arguments, files, limits, [&](LoadContext& context) {
    return expand_quietly(path, context, {}).is_complete;
  });
}

std::string describe(const std::vector<xacro::SeenArgument>& values) {
  std::map<std::string, std::string> by_file;
  for (const xacro::SeenArgument& one : values) {
    std::string& text = by_file[one.file];
    text += (text.empty() ? "`" : " ") + one.name + ":=" + one.value;
  }
  std::string text;
  for (const auto& [file, given] : by_file) {
    text += (text.empty() ? "" : ", ") + given + "`, from `" + file + "`";
  }
  return text;
}

}  // namespace smurf
