// SPDX-License-Identifier: BSD-3-Clause
#include "check/launched_values.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/findings/rules.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytesOfRobot = 1U << 20U;

/// Whether the file cannot be expanded, because an argument has no value.
bool lacks_value(const std::string& path, const LoadContext& context) {
  SourceMap sources;
  DiagnosticSink found(context.limits);
  LoadContext quiet{sources,          context.files,           found,   context.limits,
                    context.packages, context.package_folders, nullptr, context.schemas};
  quiet.xacro = context.xacro;
  quiet.package_search = context.package_search;
  load_xacro(path, quiet);
  return found.count_of(rules::sml3313_xacro_unknown_argument) > 0;
}

}  // namespace

std::string add_launched_values(const std::string& path, LoadContext& context) {
  if (!xacro::is_xacro_file(path)) return {};
  const FileContent content = context.files.read(path, kMostBytesOfRobot);
  std::vector<std::string> names = xacro::undeclared_arguments(content.text);
  std::erase_if(names, [&](const auto& one) { return context.xacro.arguments.contains(one); });
  if (names.empty() || !lacks_value(path, context)) return {};
  std::map<std::string, std::string> from;  // files to values
  std::map<std::string, std::string> added;
  for (const xacro::SeenArgument& one : xacro::seen_arguments(path, names, context.files)) {
    if (!added.emplace(one.name, one.value).second) continue;
    std::string& values = from[one.file];
    values += (values.empty() ? "`" : " ") + one.name + ":=" + one.value;
  }
  if (added.empty()) return {};
  context.xacro.arguments.merge(added);
  std::string text;
  for (const auto& [file, values] : from) {
    text += (text.empty() ? "" : ", ") + values + "`, from `" + file + "`";
  }
  return text;
}

}  // namespace smurf
