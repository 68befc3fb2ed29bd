// SPDX-License-Identifier: BSD-3-Clause
#include "check/given_arguments.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "smurf/xacro.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf {
namespace {

void report_unknown(const std::string& name, Span place, const std::string& owner,
                    const std::set<std::string>& arguments, bool is_xacro, bool needs_near,
                    DiagnosticSink& sink) {
  const std::vector<std::string_view> known(arguments.begin(), arguments.end());
  const auto near = nearest(name, known);
  if (!near && needs_near) return;
  Diagnostic& found =
      sink.report(rules::sml9002_wrong_setting, place, owner + " no argument " + quoted(name));
  if (is_xacro) found.note("xacro ignores it without a message");
  if (near) {
    found.help("did you mean " + quoted(*near) + "?");
  } else if (!is_xacro) {
    found.help("delete it, or give the xacro file: only files of xacro have arguments");
  } else if (known.empty()) {
    found.help("delete it, or add `<xacro:arg name=\"" + name + "\" default=\"...\"/>`");
  } else {
    found.help("write one of its arguments: " + choices(known));
  }
}

/// The root element of a file that was read; its beginning, if there is none.
std::optional<Span> root_of(const std::string& path, const SourceMap& sources) {
  const std::string wanted = path::normalize(path);
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    const SourceId source{i};
    if (sources.path(source) != wanted) continue;
    constexpr std::string_view kRoot = "<robot";
    const std::size_t at = sources.text(source).find(kRoot);
    if (at == std::string_view::npos) return Span{source, 0, 0};
    return Span{source, static_cast<std::uint32_t>(at + 1),
                static_cast<std::uint32_t>(at + kRoot.size())};
  }
  return std::nullopt;
}

}  // namespace

std::set<std::string> arguments_of(const SourceMap& sources, std::size_t first_source) {
  std::set<std::string> found;
  for (std::size_t i = first_source; i < sources.size(); ++i) {
    const SourceId source{static_cast<std::uint32_t>(i)};
    if (!xacro::is_xacro_file(sources.path(source)) &&
        path::extension(sources.path(source)) != ".urdf") {
      continue;
    }
    for (std::string& one : xacro::all_arguments(sources.text(source))) {
      found.insert(std::move(one));
    }
  }
  return found;
}

void GivenArguments::take(const std::string& path, std::size_t config,
                          const std::set<std::string>& arguments, bool is_expanded) {
  const std::string id = identity(path, context_.paths, context_.files);
  Robot& robot = robots_.try_emplace(id, Robot{path, config, {}, true}).first->second;
  robot.arguments.insert(arguments.begin(), arguments.end());
  robot.is_expanded = robot.is_expanded && is_expanded;
}

void GivenArguments::report(const std::map<std::string, std::string>& given,
                            const CheckGroups& groups, SourceMap& sources,
                            std::vector<Judged>& found) const {
  if (robots_.empty()) return;
  std::set<std::string> all;
  bool are_expanded = true, is_any_xacro = false;
  for (const auto& [id, robot] : robots_) {
    is_any_xacro = is_any_xacro || xacro::is_xacro_file(robot.path);
    all.insert(robot.arguments.begin(), robot.arguments.end());
    are_expanded = are_expanded && robot.is_expanded;
  }
  const Robot& first = robots_.begin()->second;
  for (const auto& [name, value] : given) {
    const auto place = all.contains(name) ? std::nullopt : root_of(first.path, sources);
    if (!place) continue;
    DiagnosticSink sink(context_.limits);
    const std::string owner =
        robots_.size() == 1 ? quoted(first.path) + " has" : "the robots that are checked have";
    report_unknown(name, *place, owner, all, is_any_xacro || !all.empty(), !are_expanded, sink);
    append(sink.take(), found[first.config].diagnostics);
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const ConfigXacro& one : groups[i].config.xacro) {
      const auto robot = robots_.find(identity(one.file.value, context_.paths, context_.files));
      if (robot == robots_.end()) continue;
      DiagnosticSink sink(context_.limits);
      for (const auto& [name, values] : one.arguments) {
        if (robot->second.arguments.contains(name.value)) continue;
        report_unknown(name.value, name.span, quoted(robot->second.path) + " has",
                       robot->second.arguments, xacro::is_xacro_file(robot->second.path),
                       !robot->second.is_expanded, sink);
      }
      append(sink.take(), found[i].diagnostics);
    }
  }
}

}  // namespace smurf
