// SPDX-License-Identifier: BSD-3-Clause
// Keyword arguments as settings of a check.
#include <algorithm>
#include <functional>
#include <map>

#include "common.hpp"

namespace smurf::python {
const Reader* from_target(const std::string& name) {
  if (const Reader* reader = find_target(name)) return reader;
  std::string known;
  for (const std::string_view target : target_names()) known += " " + std::string(target);
  throw py::value_error("'" + name + "' is not one of the targets:" + known);
}

namespace {

/// A rule, or a prefix of several.
std::string from_rule(std::string pattern) {
  const auto rules = all_rules();
  if (std::none_of(rules.begin(), rules.end(),
                   [&](const Rule* rule) { return matches(*rule, pattern); })) {
    throw py::value_error("there is no rule '" + pattern + "'");
  }
  return pattern;
}

std::vector<std::string> from_rules(const py::handle& rules, const char* argument) {
  std::vector<std::string> patterns = from_texts(rules, argument);
  for (std::string& pattern : patterns) pattern = from_rule(std::move(pattern));
  return patterns;
}

Severity from_severity(const std::string& name) {
  for (const Severity severity : {Severity::info, Severity::warning, Severity::error}) {
    if (to_string(severity) == name) return severity;
  }
  throw py::value_error("'" + name + "' is not one of info, warning, error");
}

py::dict from_dict(const py::handle& value, const char* argument) {
  if (!py::isinstance<py::dict>(value)) {
    throw py::type_error(std::string(argument) + " must be a dict");
  }
  return py::reinterpret_borrow<py::dict>(value);
}

bool from_bool(const py::handle& value, const char* argument) {
  if (!py::isinstance<py::bool_>(value)) {
    throw py::type_error(std::string(argument) + " must be a bool");
  }
  return value.cast<bool>();
}

unsigned from_jobs(const py::handle& value) {
  if (!py::isinstance<py::int_>(value)) throw py::type_error("jobs must be an int");
  const py::ssize_t jobs = PyNumber_AsSsize_t(value.ptr(), nullptr);
  if (jobs < 0 || jobs > 1024) throw py::value_error("jobs must be from 0 to 1024");
  return static_cast<unsigned>(jobs);
}

std::uint64_t from_seconds(const py::handle& value) {
  if (!py::isinstance<py::int_>(value)) throw py::type_error("max_seconds must be an int");
  const py::ssize_t seconds = PyNumber_AsSsize_t(value.ptr(), nullptr);
  if (seconds < 0) throw py::value_error("max_seconds must be at least 0");
  return static_cast<std::uint64_t>(seconds);
}

/// A text, or a number or truth value as xacro writes it.
std::string from_argument(const py::handle& value) {
  const bool is_number = py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value);
  return is_number ? std::string(py::str(value)) : from_text(value, "a value in args");
}

using Setter = std::function<void(CheckSettings& settings, const py::handle& value)>;

const std::map<std::string, Setter>& setters() {
  static const std::map<std::string, Setter> setters = {
      {"config", [](auto& to, const auto& value) { to.config = from_path(value); }},
      {"isolated",
       [](auto& to, const auto& value) { to.is_isolated = from_bool(value, "isolated"); }},
      {"select",
       [](auto& to, const auto& value) { to.selection.select = from_rules(value, "select"); }},
      {"ignore",
       [](auto& to, const auto& value) { to.selection.ignore = from_rules(value, "ignore"); }},
      {"severities",
       [](auto& to, const auto& value) {
         for (const auto& [rule, level] : from_dict(value, "severities")) {
           to.selection.severities[from_rule(from_text(rule, "a rule"))] =
               from_severity(from_text(level, "a severity"));
         }
       }},
      {"targets",
       [](auto& to, const auto& value) {
         for (const std::string& name : from_texts(value, "targets")) {
           auto& targets = to.selection.targets;
           const Reader* reader = from_target(name);
           if (std::find(targets.begin(), targets.end(), reader) == targets.end()) {
             targets.push_back(reader);
           }
         }
       }},
      {"packages",
       [](auto& to, const auto& value) {
         for (const auto& [name, folder] : from_dict(value, "packages")) {
           to.packages[from_text(name, "the name of a package")] = from_path(folder);
         }
       }},
      {"args",
       [](auto& to, const auto& value) {
         for (const auto& [name, argument] : from_dict(value, "args")) {
           to.xacro.arguments[from_text(name, "a name in args")] = from_argument(argument);
         }
       }},
      {"xacro_env",
       [](auto& to, const auto& value) {
         for (std::string& name : from_texts(value, "xacro_env")) {
           to.xacro.environment.insert(std::move(name));
         }
       }},
      {"baseline", [](auto& to, const auto& value) { to.baseline = from_path(value); }},
      {"no_ignores",
       [](auto& to, const auto& value) {
         to.heeds_comments = to.heeds_baseline = !from_bool(value, "no_ignores");
       }},
      {"allow_outside",
       [](auto& to, const auto& value) { to.allows_outside = from_bool(value, "allow_outside"); }},
      {"max_seconds", [](auto& to, const auto& value) { to.max_seconds = from_seconds(value); }},
      {"jobs", [](auto& to, const auto& value) { to.jobs = from_jobs(value); }},
  };
  return setters;
}

}  // namespace

CheckSettings settings_of(const py::kwargs& keywords) {
  CheckSettings settings;
  for (const auto& [key, value] : keywords) {
    const std::string name = from_text(key, "the name of an argument");
    const auto setter = setters().find(name);
    if (setter == setters().end()) {
      throw py::type_error("there is no argument '" + name + "'");
    }
    if (!value.is_none()) setter->second(settings, value);
  }
  if (settings.is_isolated && !settings.config.empty()) {
    throw py::value_error("isolated reads no configuration, config names one");
  }
  return settings;
}

}  // namespace smurf::python
