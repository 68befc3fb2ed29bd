// SPDX-License-Identifier: BSD-3-Clause
// smurf-diff: compares two versions of a model or scene, by their effect on the robot.
#include <algorithm>
#include <string_view>
#include <vector>

#include "base/files/places.hpp"
#include "common/cli/browser.hpp"
#include "common/cli/process.hpp"
#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "smurf-diff/difference_picture.hpp"
#include "smurf-diff/git.hpp"
#include "smurf-diff/options.hpp"
#include "smurf-diff/versions.hpp"
#include "smurf/confine.hpp"
#include "smurf/found_inputs.hpp"

using namespace smurf;
using namespace smurf::tools;

namespace {

/// The file for an operand, which may be in an archive. Reports an error and returns none if it
/// cannot be read or compared.
std::optional<InputVersion> open(const std::string& operand, const Options& options,
                                 const Session& session) {
  if (operand == "-") {
    MemoryFiles memory;
    const auto name =
        read_standard_input(kSmurfDiff, options.stdin_filename, options.limits, memory);
    if (!name) return std::nullopt;
    return InputVersion{*name, "-", *name, memory.read(*name, options.limits.file_bytes).text};
  }
  if (const auto reason = why_unreadable(operand, session.files())) {
    complain(kSmurfDiff, "cannot read '" + operand + "': " + *reason);
    return std::nullopt;
  }
  const auto path = find_main_file(kSmurfDiff, operand, session.files());
  if (!path) return std::nullopt;
  const InputKind kind = input_kind(*path);
  if (kind == InputKind::resource || kind == InputKind::other) {
    complain(kSmurfDiff, "'" + operand + "' is not a model, scene, URDF or annotation file");
    return std::nullopt;
  }
  return InputVersion{*path, operand};
}

std::string render(const Compared& compared, const Session& session, const Options& options,
                   const std::string& picture) {
  const SourceMap& sources = session.loaded_sources();
  const DiffInputs inputs{shown_operand(options, 0), shown_operand(options, 1), options.tolerance};
  const ToolName tool{kSmurfDiff, kVersion};
  const auto& differences = compared.differences;
  if (options.format == DiffFormat::json) {
    return render_diff_json(differences, sources, inputs, tool);
  }
  if (options.format == DiffFormat::html) {
    return render_diff_html(differences, sources, inputs, tool, picture);
  }
  const bool is_for_people = options.output.empty() || options.output == "-";
  const TextStyle style = is_for_people ? style_for(Stream::output, options.color) : TextStyle{};
  return render_diff(differences, sources, style);
}

/// Replaces folders by the model in them. False if one has none, or several.
bool find_models(Options& options) {
  constexpr InputKind kKinds[] = {InputKind::model, InputKind::urdf, InputKind::scene};
  for (std::string& operand : options.operands) {
    if (operand == "-" || !places::is_folder(operand)) continue;
    const auto found = find_only_input(kSmurfDiff, operand, kKinds, options.limits);
    if (!found) return false;
    operand = *found;
  }
  return true;
}

/// Opens the page, after writing it to the file of the user or to a temporary one.
bool open_page(const Options& options, const std::string& text) {
  std::string file = options.output;
  if (file.empty() || file == "-") {
    file = write_temporary_page(kSmurfDiff, "changes", text);
  } else if (!write_output(kSmurfDiff, file, text)) {
    return false;
  }
  return !file.empty() && show_page(kSmurfDiff, file);
}

ExitCode compare_operands(const Options& options) {
  ConfinedFiles disk;
  std::vector<std::string> inputs = options.operands;
  std::ranges::replace(inputs, "-", options.stdin_filename);
  confine(disk, inputs, options.packages, options.allow_outside);
  const InputFiles files(disk);
  Session session(files, options.limits);
  auto before = open(options.operands[0], options, session);
  auto after = open(options.operands[1], options, session);
  if (!before || !after) return kFailed;
  before->xacro = options.xacro[0];
  after->xacro = options.xacro[1];
  const Compared compared = compare_versions(session, *before, *after, options);
  std::string picture;
  const bool has_picture = options.format == DiffFormat::html && !options.quiet;
  if (has_picture && compared.is_known() && !compared.differences.empty()) {
    picture = picture_of(session, *before, *after, options);
  }
  if (!tools::keeps_inputs(kSmurfDiff, files, std::span(&options.output, 1))) return kFailed;
  for (const Diagnostic& finding : compared.trouble) {
    write_error(
        render_full(finding, session.loaded_sources(), style_for(Stream::error, options.color)));
  }
  if (!compared.problem.empty()) complain(kSmurfDiff, compared.problem);
  if (!compared.is_known()) return kFailed;
  if (!options.quiet) {
    const std::string text = render(compared, session, options, picture);
    if (!(options.opens ? open_page(options, text)
                        : write_output(kSmurfDiff, options.output, text))) {
      return kFailed;
    }
  }
  return compared.differences.empty() ? kDone : kFindings;
}

/// The arguments that git passes after --git are names in a repository, which may look like
/// options.
std::vector<const char*> without_options_of_git(int argc, const char* const* argv) {
  std::vector<const char*> arguments(argv, argv + argc);
  const auto git = std::ranges::find(arguments, std::string_view("--git"));
  if (git != arguments.end()) arguments.insert(git + 1, "--");
  return arguments;
}

}  // namespace

int smurf_diff_main(int argc, char** argv) {
  prepare_process();
  Options options;
  const std::vector<const char*> arguments = without_options_of_git(argc, argv);
  const int count = static_cast<int>(arguments.size());
  if (const auto code = parse_command_line(make_command(options), count, arguments.data())) {
    return *code;
  }
  if (options.for_git) drop_separator(options.operands);
  if (const std::string problem = problem_of(options); !problem.empty()) {
    complain(kSmurfDiff, problem);
    return kFailed;
  }
  if (options.opens) options.format = DiffFormat::html;
  if (options.for_git) return compare_for_git(options);
  return find_models(options) ? compare_operands(options) : kFailed;
}
