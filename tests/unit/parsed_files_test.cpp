// SPDX-License-Identifier: BSD-3-Clause
// Files of a model that are not parsed again.
#include <doctest/doctest.h>

#include <string>

#include "link/parsed_files.hpp"
#include "smurf/load.hpp"

using namespace smurf;

namespace {

constexpr const char* kUrdf = "<robot name=\"r\"><link name=\"a\"/></robot>\n";
constexpr const char* kMotors = "motors:\n- {name: m, joint: j}\nown section: [1]\n";
constexpr const char* kMoreMotors = "motors:\n- {name: n, joint: j}\n";

/// Does the same as a session for each check.
class Checks {
 public:
  Checks() {
    set("/m.smurf", "modelname: r\nfiles: [r.urdf, a.yml, b.yml]\nmotors: [{name: own}]\n");
    set("/r.urdf", kUrdf);
    set("/a.yml", kMotors);
    set("/b.yml", kMoreMotors);
  }

  void set(const std::string& path, const std::string& text) { files_.add(path, text); }

  /// The names of the motors.
  std::string run() {
    sources_ = {};
    DiagnosticSink sink;
    LoadContext context{sources_, files_, sink, {}, {}};
    context.parsed = &parsed_;
    LinkedModel model = load_model("/m.smurf", context);
    std::string names;
    for (const Motor& motor : model.annotations.motors) names += motor.name.value_or("?") + " ";
    if (model.robot) names += std::to_string(model.robot->links.size());
    parsed_.end_loading(sources_, sink);
    parsed_.keep(std::move(model));
    return names;
  }

  /// Sorted by their first letters.
  std::string known() {
    std::string names;
    for (std::uint32_t i = 0; i < sources_.size(); ++i) {
      if (parsed_.find(sources_, SourceId{i}) != nullptr) names += sources_.path(SourceId{i})[1];
    }
    return names;
  }

 private:
  MemoryFiles files_;
  SourceMap sources_;
  ParsedFiles parsed_;
};

}  // namespace

TEST_CASE("a file that is the same in two checks is not parsed again") {
  Checks checks;
  CHECK(checks.run() == "own m n 1");
  CHECK(checks.known().empty());
  CHECK(checks.run() == "own m n 1");
  CHECK(checks.known() == "rab");
  CHECK(checks.run() == "own m n 1");
  CHECK(checks.known() == "rab");

  checks.set("/a.yml", "motors:\n- {name: other, joint: j}\n");
  CHECK(checks.run() == "own other n 1");
  CHECK(checks.known() == "rb");
  checks.set("/r.urdf", "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/></robot>\n");
  CHECK(checks.run() == "own other n 2");
  CHECK(checks.known() == "ab");
}

TEST_CASE("a file with findings, or under another number, is parsed again") {
  Checks checks;
  checks.set("/a.yml", std::string(kMotors) + "motors: 1\n");  // a duplicate key
  for (int i = 0; i < 3; ++i) checks.run();
  CHECK(checks.known() == "rb");
  checks.set("/a.yml", kMotors);
  for (int i = 0; i < 2; ++i) checks.run();
  CHECK(checks.known() == "rab");
  checks.set("/m.smurf", "modelname: r\nfiles: [b.yml, r.urdf]\n");
  CHECK(checks.run() == "n 1");
  CHECK(checks.known().empty());
}
