// SPDX-License-Identifier: BSD-3-Clause
#include "common/cli/shared_options.hpp"

#include <algorithm>

#include "base/files/system.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/did_you_mean.hpp"
#include "render/wrap.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {
namespace {

Setter set_package(std::map<std::string, std::string>& packages) {
  return [&packages](std::string_view value) -> std::optional<std::string> {
    const std::size_t equals = value.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == value.size()) {
      return "'" + std::string(value) + "' is not NAME=DIR";
    }
    packages[std::string(value.substr(0, equals))] = sys::from_user(value.substr(equals + 1));
    return std::nullopt;
  };
}

std::optional<std::string> set_limit(std::string_view item, Limits& limits) {
  const std::size_t equals = std::min(item.find('='), item.size());
  const std::string_view name = item.substr(0, equals);
  const auto* info = std::find_if(kLimits.begin(), kLimits.end(),
                                  [&](const LimitInfo& one) { return one.name == name; });
  if (info == kLimits.end()) {
    std::vector<std::string_view> names;
    for (const LimitInfo& one : kLimits) names.push_back(one.name);
    return "there is no limit '" + std::string(name) + "'" + did_you_mean(name, names) +
           "; --limit help lists them";
  }
  if (equals == item.size()) return "'" + std::string(item) + "' is not NAME=N";
  const std::string_view text = item.substr(equals + 1);
  const std::optional<std::int64_t> number = parse_integer(text);
  if (!number || *number < 1 || static_cast<std::uint64_t>(*number) > info->most) {
    return "'" + std::string(text) + "' is not a whole number from 1 to " +
           std::to_string(info->most);
  }
  limits.*info->value = static_cast<std::uint64_t>(*number);
  return std::nullopt;
}

/// A table of all limits, for `--limit help`.
std::string limits_page() {
  std::size_t longest = 0;
  for (const LimitInfo& info : kLimits) longest = std::max(longest, info.name.size());
  std::string page = "Limits, their defaults and what they bound:\n\n";
  for (const LimitInfo& info : kLimits) {
    constexpr std::size_t kDigits = 10;
    constexpr std::size_t kColumns = 80;
    const std::string number = std::to_string(Limits{}.*info.value);
    page.append("  ").append(info.name).append(longest - info.name.size() + 2, ' ');
    page.append(kDigits - std::min(kDigits, number.size()), ' ').append(number).append("  ");
    const std::size_t indent = longest + kDigits + 6;
    page.append(render::wrap(info.counts, indent, kColumns).substr(indent));
  }
  return page + "\nSet one with --limit NAME=N, several separated by commas.\n";
}

}  // namespace

Option open_option(bool& opens) {
  return {.group = "Output",
          .name = "open",
          .help = "Open the result in the browser, as a page: that of --format html, or, without "
                  "it, one in a temporary file.",
          .set = set_flag(opens)};
}

Option color_option(ColorChoice& color) {
  return {.group = "General",
          .name = "color",
          .metavar = "WHEN",
          .help =
              "Use colours: auto (the default: on a terminal, unless NO_COLOR is set), always or "
              "never.",
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
          .suggestions = report_format_names,
          .help_page = report_formats_page,
          .set = append_report(reports)};
}

Option fail_on_option(Threshold& threshold) {
  using Level = std::optional<Severity>;
  return {
      .group = "Exit code",
      .name = "fail-on",
      .metavar = "LEVEL",
      .help =
          "Exit with 1 on findings of this severity or above: error (the default), warning, info "
          "or never.",
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
          .help = "Use PATH as the name of standard input in messages, and resolve relative paths "
                  "in the input from the folder of PATH.",
          .set = set_text(path)};
}

Option xacro_env_option(std::set<std::string>& names) {
  return {
      .group = "Input",
      .name = "xacro-env",
      .metavar = "NAMES",
      .help =
          "Let `$(env NAME)` and `$(optenv NAME)` in xacro files read these variables of the environment, "
          "comma-separated; all others count as not set.",
      .set = [&names](std::string_view value) -> std::optional<std::string> {
        for (const std::string_view name : split_items(value)) names.emplace(name);
        return std::nullopt;
      }};
}

bool take_xacro_argument(std::string_view value, XacroSettings& xacro) {
  const std::size_t mark = value.find(":=");
  if (mark == std::string_view::npos || mark == 0) return false;
  xacro.arguments[std::string(value.substr(0, mark))] = value.substr(mark + 2);
  return true;
}

Option package_option(std::map<std::string, std::string>& packages) {
  return {.group = "Input",
          .name = "package",
          .metavar = "NAME=DIR",
          .help = "Use the folder DIR for package://NAME/; may be repeated.",
          .set = set_package(packages)};
}

Option limit_option(Limits& limits) {
  return {.group = "Input",
          .name = "limit",
          .metavar = "NAME=N",
          .help = "Change a limit on the input, such as yaml-depth=200; `--limit help` lists the "
                  "limits.",
          .help_page = limits_page,
          .set = [&limits](std::string_view list) -> std::optional<std::string> {
            for (const std::string_view item : split_items(list)) {
              if (auto wrong = set_limit(item, limits)) return wrong;
            }
            return std::nullopt;
          }};
}

Option max_seconds_option(std::uint64_t& seconds) {
  static_assert(kMaxSeconds == 120, "the help says so");
  return {.group = "Input",
          .name = "max-seconds",
          .metavar = "N",
          .help = "Leave a file that takes more than N seconds of processor time with all that it "
                  "loads, and report that; 0: never. The default is 120.",
          .set = [&seconds](std::string_view value) -> std::optional<std::string> {
            const auto parsed = parse_integer(value);
            if (!parsed || *parsed < 0) {
              return "'" + std::string(value) + "' is not a whole number of at least 0";
            }
            seconds = static_cast<std::uint64_t>(*parsed);
            return std::nullopt;
          }};
}

Option jobs_option(std::optional<int>& jobs) {
  return {.group = "General",
          .letter = 'j',
          .name = "jobs",
          .metavar = "N",
          .help = "Use at most N threads. The output does not depend on N.",
          .set = set_number(jobs, 1)};
}

Option allow_outside_option(bool& allow_outside) {
  return {
      .group = "Input",
      .name = "allow-outside",
      .help =
          "Read all files that models name, wherever those files are. By default, only files in "
          "the current folder, in the repository or package of the input, and in packages are "
          "read.",
      .set = set_flag(allow_outside)};
}

}  // namespace smurf::tools
