// SPDX-License-Identifier: BSD-3-Clause
#include "config/xacro_setting.hpp"

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "config/setting_findings.hpp"
#include "smurf/xacro.hpp"

namespace smurf {
namespace {

/// Robots, arguments of a robot, and values of an argument.
constexpr std::size_t kMostOfXacro = 1000;

class XacroSetting {
 public:
  XacroSetting(const std::string& folder, const FileReader& files, DiagnosticSink& sink)
      : folder_(folder), files_(files), sink_(sink) {}

  void read_all(yaml::View value, std::vector<ConfigXacro>& robots) {
    if (value.is_mapping()) return read_one(value, robots);
    if (!value.is_sequence()) return expect(value, "a list of robots");
    for (const yaml::View robot : value) {
      if (robots.size() >= kMostOfXacro) return wrong(robot, "only 1000 robots are read");
      read_one(robot, robots);
    }
  }

 private:
  void wrong(yaml::View value, std::string message) {
    wrong_setting(value, value.place(), std::move(message), sink_);
  }

  void expect(yaml::View value, std::string_view expected) {
    expect_setting(value, expected, sink_);
  }

  void read_one(yaml::View value, std::vector<ConfigXacro>& robots) {
    if (!value.is_mapping()) return expect(value, "`file` and `arguments`");
    ConfigXacro robot;
    for (const yaml::View entry : value) {
      if (entry.key() == "file") {
        if (!entry.is_scalar()) return expect(entry, "the path of a .xacro file");
        robot.file = {path::join(folder_, entry.text()), entry.span()};
      } else if (entry.key() == "arguments") {
        if (!entry.is_mapping()) return expect(entry, "a mapping from arguments to values");
        for (const yaml::View argument : entry) read_argument(argument, robot);
      } else {
        wrong(entry, "a robot of `xacro` has no setting " + quoted(entry.key()) +
                         "; known are `file` and `arguments`");
      }
    }
    if (robot.file.value.empty()) return wrong(value, "this robot of `xacro` has no `file`");
    if (!xacro::is_xacro_file(robot.file.value)) {
      sink_.report(rules::sml9002_wrong_setting, robot.file.span,
                   quoted(robot.file.value) + " is not a .xacro file");
      return;
    }
    if (!files_.is_file(robot.file.value)) {
      sink_.report(rules::sml9002_wrong_setting, robot.file.span,
                   "there is no file " + quoted(robot.file.value));
      return;
    }
    robots.push_back(std::move(robot));
  }

  void read_argument(yaml::View value, ConfigXacro& robot) {
    std::vector<std::string> values;
    if (value.is_scalar()) {
      values.emplace_back(value.text());
    } else if (value.is_sequence()) {
      for (const yaml::View item : value) {
        if (!item.is_scalar()) return expect(item, "a text");
        if (values.size() < kMostOfXacro) values.emplace_back(item.text());
      }
    }
    if (values.empty()) return expect(value, "a value or a list of values");
    robot.arguments.emplace_back(Spanned<std::string>{std::string(value.key()), value.key_span()},
                                 std::move(values));
  }

  const std::string& folder_;
  const FileReader& files_;
  DiagnosticSink& sink_;
};

}  // namespace

void read_xacro_setting(yaml::View value, const std::string& folder, const FileReader& files,
                        DiagnosticSink& sink, std::vector<ConfigXacro>& robots) {
  XacroSetting(folder, files, sink).read_all(value, robots);
}

std::vector<std::map<std::string, std::string>>
combinations_of(const ConfigXacro& robot, const std::map<std::string, std::string>& given,
                std::size_t most) {
  std::vector<std::map<std::string, std::string>> all{given};
  for (const auto& [name, values] : robot.arguments) {
    if (given.contains(name.value)) continue;
    std::vector<std::map<std::string, std::string>> longer;
    for (const auto& one : all) {
      for (const std::string& value : values) {
        if (longer.size() > most) break;
        longer.push_back(one);
        longer.back()[name.value] = value;
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace smurf
