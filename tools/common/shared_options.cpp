// SPDX-License-Identifier: BSD-3-Clause
#include "common/shared_options.hpp"

namespace smurf::tools {
namespace {

Setter set_package(std::map<std::string, std::string>& packages) {
  return [&packages](std::string_view value) -> std::optional<std::string> {
    const std::size_t equals = value.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == value.size()) {
      return "'" + std::string(value) + "' is not NAME=DIR";
    }
    packages[std::string(value.substr(0, equals))] = value.substr(equals + 1);
    return std::nullopt;
  };
}

}  // namespace

Option color_option(ColorChoice& color) {
  return {.group = "General",
          .name = "color",
          .metavar = "WHEN",
          .help = "auto (the default: on a terminal, unless NO_COLOR is set), always or never.",
          .values = {"auto", "always", "never"},
          .set = choose<ColorChoice>(color, {{"auto", ColorChoice::automatic},
                                             {"always", ColorChoice::always},
                                             {"never", ColorChoice::never}})};
}

Option quiet_option(bool& quiet, std::string_view help) {
  return {.group = "General", .letter = 'q', .name = "quiet", .help = help, .set = set_flag(quiet)};
}

Option output_option(std::string& file, std::string_view help) {
  return {.group = "Output",
          .letter = 'o',
          .name = "output",
          .metavar = "FILE",
          .help = help,
          .set = set_text(file)};
}

Option report_option(std::string_view name, std::vector<ReportRequest>& reports) {
  return {.group = "Output",
          .name = name,
          .metavar = "FORMAT[=FILE]",
          .help = report_option_help(),
          .suggestions = report_format_names(),
          .set = append_report(reports)};
}

Option fail_on_option(Threshold& threshold) {
  using Level = std::optional<Severity>;
  return {.group = "Verdict",
          .name = "fail-on",
          .metavar = "LEVEL",
          .help = "Exit with 1 when there is a finding of this severity or above: error (the "
                  "default), warning, info or never.",
          .values = {"error", "warning", "info", "never"},
          .set = choose<Level>(threshold.fail_on, {{"error", Severity::error},
                                                   {"warning", Severity::warning},
                                                   {"info", Severity::info},
                                                   {"never", std::nullopt}})};
}

Option stdin_filename_option(std::string& path) {
  return {.group = "Input",
          .name = "stdin-filename",
          .metavar = "PATH",
          .help = "What '-' is called in messages, and where its relative paths start.",
          .set = set_text(path)};
}

Option package_option(std::map<std::string, std::string>& packages) {
  return {.group = "Input",
          .name = "package",
          .metavar = "NAME=DIR",
          .help = "The folder that package://NAME/ stands for; may be repeated.",
          .set = set_package(packages)};
}

Option jobs_option(std::optional<int>& jobs) {
  return {.group = "General",
          .letter = 'j',
          .name = "jobs",
          .metavar = "N",
          .help = "Threads to use at most. The output does not depend on it.",
          .set = set_number(jobs, 1)};
}

}  // namespace smurf::tools
