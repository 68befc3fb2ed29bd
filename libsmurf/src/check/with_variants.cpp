// SPDX-License-Identifier: BSD-3-Clause
#include "check/with_variants.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/files/canonical_paths.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"

namespace smurf {
namespace {

const ConfigXacro* configured(const PlannedFile& file, const CheckGroups& groups,
                              const CheckContext& context) {
  if (!xacro::is_xacro_file(file.path)) return nullptr;
  const auto id_of = [&](const std::string& path) {
    return identity(path, context.paths, context.files);
  };
  const std::vector<ConfigXacro>& robots = groups[file.config].config.xacro;
  const auto found = std::find_if(robots.begin(), robots.end(), [&](const ConfigXacro& one) {
    return id_of(one.file.value) == id_of(file.path);
  });
  return found == robots.end() ? nullptr : &*found;
}

void append_variants(const PlannedFile& file, const ConfigXacro& robot, const CheckGroup& group,
                     std::uint64_t most, std::vector<Judged>& found,
                     std::vector<PlannedFile>& all) {
  auto combinations = combinations_of(robot, group.settings.xacro.arguments, most);
  if (combinations.size() > most) {
    combinations.resize(most);
    DiagnosticSink sink;
    sink.report(rules::sml9002_wrong_setting, robot.file.span,
                "the arguments have more than " + std::to_string(most) +
                    " combinations; only the first are checked")
        .help(raise_limit("xacro-variants"));
    append(sink.take(), found[file.config].diagnostics);
  }
  for (auto& arguments : combinations) {
    PlannedArguments planned;
    for (const auto& [name, values] : robot.arguments) {
      if (values.size() < 2) continue;
      planned.shown +=
          (planned.shown.empty() ? "" : " ") + name.value + ":=" + arguments.at(name.value);
    }
    planned.values = std::move(arguments);
    PlannedFile& variant = all.emplace_back(file);
    variant.may_be_part = false;
    variant.arguments = std::make_shared<const PlannedArguments>(std::move(planned));
  }
}

}  // namespace

std::vector<PlannedFile> with_variants(const std::vector<PlannedFile>& planned,
                                       const CheckGroups& groups, const CheckContext& context,
                                       std::vector<Judged>& found) {
  std::vector<PlannedFile> all;
  for (const PlannedFile& file : planned) {
    if (const ConfigXacro* robot = configured(file, groups, context)) {
      append_variants(file, *robot, groups[file.config], context.limits.xacro_variants, found, all);
    } else {
      all.push_back(file);
    }
  }
  return all;
}

}  // namespace smurf
