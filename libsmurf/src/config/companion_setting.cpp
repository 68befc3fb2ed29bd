// SPDX-License-Identifier: BSD-3-Clause
#include "config/companion_setting.hpp"

#include "base/files/path.hpp"
#include "base/text/quoted.hpp"
#include "config/setting_findings.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostOfCompanions = 1000;  // robots, and files of a robot

class CompanionSetting {
 public:
  CompanionSetting(const std::string& folder, const FileReader& files, DiagnosticSink& sink)
      : folder_(folder), files_(files), sink_(sink) {}

  void read_all(yaml::View value, std::vector<ConfigCompanions>& robots) {
    if (value.is_mapping()) return read_one(value, robots);
    if (!value.is_sequence()) return expect(value, "a list of robots with their files");
    for (const yaml::View robot : value) {
      if (robots.size() >= kMostOfCompanions) return wrong(robot, "only 1000 robots are read");
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

  /// A file that exists; none after a finding.
  std::optional<Spanned<std::string>> file(yaml::View value) {
    if (!value.is_scalar()) {
      expect(value, "the path of a file");
      return std::nullopt;
    }
    std::string path = path::join(folder_, value.text());
    if (files_.is_file(path)) return Spanned<std::string>{std::move(path), value.span()};
    wrong(value, "there is no file " + quoted(path));
    return std::nullopt;
  }

  void read_one(yaml::View value, std::vector<ConfigCompanions>& robots) {
    if (!value.is_mapping()) return expect(value, "`robot` and `files`");
    ConfigCompanions one;
    bool has_robot = false;
    for (const yaml::View entry : value) {
      if (entry.key() == "robot") {
        has_robot = true;
        if (auto robot = file(entry)) one.robot = std::move(*robot);
      } else if (entry.key() == "files") {
        read_files(entry, one);
      } else {
        wrong(entry, "a robot of `companions` has no setting " + quoted(entry.key()) +
                         "; known are `robot` and `files`");
      }
    }
    if (!has_robot) return wrong(value, "this entry of `companions` has no `robot`");
    if (!one.robot.value.empty()) robots.push_back(std::move(one));
  }

  void read_files(yaml::View value, ConfigCompanions& one) {
    if (value.is_scalar()) {
      if (auto found = file(value)) one.files.push_back(std::move(*found));
    } else if (value.is_sequence()) {
      for (const yaml::View item : value) {
        if (one.files.size() >= kMostOfCompanions) return wrong(item, "only 1000 files are read");
        if (auto found = file(item)) one.files.push_back(std::move(*found));
      }
    } else {
      expect(value, "a path or a list of paths");
    }
  }

  const std::string& folder_;
  const FileReader& files_;
  DiagnosticSink& sink_;
};

}  // namespace

void read_companion_setting(yaml::View value, const std::string& folder, const FileReader& files,
                            DiagnosticSink& sink, std::vector<ConfigCompanions>& robots) {
  CompanionSetting(folder, files, sink).read_all(value, robots);
}

}  // namespace smurf
