// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/lint_plan.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "base/files/path.hpp"
#include "common/files/input.hpp"
#include "smurf/config.hpp"
#include "smurf/confine.hpp"
#include "smurf/lint.hpp"

namespace smurf::tools {
namespace {

std::vector<std::string> searched_or_named(const LintOptions& options) {
  if (!options.show_config.empty()) return {options.show_config};
  return options.paths.empty() ? std::vector<std::string>{"."} : options.paths;
}

void append_planned(const LintPlan& plan, std::vector<std::string>& paths) {
  for (const auto* planned : {&plan.scenes, &plan.models, &plan.others}) {
    for (const PlannedFile& file : *planned) paths.push_back(file.path);
  }
  // A YAML file in a home folder may be anything, and does not open the folder to models elsewhere.
  for (const PlannedFile& file : plan.companions) {
    const std::string_view folder = path::parent(file.path);
    if (!is_shared_folder(folder.empty() ? "." : std::string(folder))) paths.push_back(file.path);
  }
}

/// A remark for users of linters with subcommands: what to write instead of the word.
std::string hint_for_word(std::string_view word) {
  struct Habit {
    std::string_view word;
    std::string_view instead;
  };
  constexpr Habit kHabits[] = {
      {"check", "leave the word out"},   {"lint", "leave the word out"},
      {"run", "leave the word out"},     {"fix", "write --fix"},
      {"format", "write --fix"},         {"diff", "write --diff"},
      {"rename", "write --rename"},      {"explain", "write --explain"},
      {"rule", "write --explain"},       {"rules", "write --list-rules"},
      {"config", "write --show-config"}, {"help", "write --help"},
      {"version", "write --version"},
  };
  for (const Habit& habit : kHabits) {
    if (habit.word == word) {
      return "; smurf-lint has no subcommands: " + std::string(habit.instead);
    }
  }
  if (find_rule(word) == nullptr) return {};
  return "; to read about a rule, write --explain " + std::string(word);
}

PlanSettings plan_settings(const LintOptions& options) {
  PlanSettings settings;
  settings.paths = searched_or_named(options);
  settings.config = options.config;
  settings.is_isolated = options.isolated;
  settings.excludes_named = options.force_exclude;
  settings.heeds_ignore_files = !options.no_ignore_files;
  settings.stands_for_users = options.only_listed;
  settings.limits = options.limits;
  settings.advice = hint_for_word;
  return settings;
}

}  // namespace

std::string find_config(const std::string& path, const LintOptions& options,
                        const FileReader& files) {
  if (options.isolated) return {};
  if (!options.config.empty()) return options.config;
  return nearest_config(path, files);
}

bool can_read_named(const LintOptions& options, const FileReader& files) {
  std::vector<std::string> needed{options.config};
  if (!options.generate_baseline) needed.push_back(options.baseline);
  for (const std::string& path : needed) {
    const auto reason = path.empty() ? std::nullopt : why_unreadable(path, files);
    if (!reason) continue;
    complain(kSmurfLint, "cannot read '" + path + "': " + *reason);
    return false;
  }
  return true;
}

void confine_to_inputs(ConfinedFiles& files, const LintOptions& options) {
  confine(files, searched_or_named(options), options.packages, options.allow_outside);
  confine(files, std::array{options.stdin_filename, options.config}, {}, options.allow_outside);
  files.allow(options.config);
  files.allow(options.baseline);
}

void confine_to_found(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan) {
  std::vector<std::string> found = plan.configs;
  append_planned(plan, found);
  confine(files, found, options.packages, options.allow_outside);
  files.allow(options.config);
  files.allow(options.baseline);
}

void confine_to_changeable(ConfinedFiles& files, const LintOptions& options, const LintPlan& plan) {
  if (options.allow_outside) return files.allow("/");
  std::vector<std::string> inputs = searched_or_named(options);
  inputs.push_back(options.stdin_filename);
  append_planned(plan, inputs);
  confine_to_projects(files, inputs);
}

LintPlan make_plan(const LintOptions& options, MemoryFiles& files,
                   const std::function<void(const std::string&)>& tell) {
  PlanSettings settings = plan_settings(options);
  LintPlan plan;
  for (std::string& path : settings.paths) {
    if (path != "-") continue;
    const auto name =
        read_standard_input(kSmurfLint, options.stdin_filename, options.limits, files);
    if (!name) {
      plan.problems.emplace_back("cannot read standard input");
      return plan;
    }
    plan.standard_input = settings.given = path = *name;
  }
  static_cast<FoundPlan&>(plan) = make_plan(settings, files, tell);
  return plan;
}

}  // namespace smurf::tools
