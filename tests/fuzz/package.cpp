// SPDX-License-Identifier: BSD-3-Clause
// A ROS package: a robot with its parameter files, SRDF, launch files, package.xml and build files.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"
#include "smurf/check.hpp"
#include "smurf/render.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string robot = "p/robot.urdf.xacro";
  const MemoryFiles files = unbundle(bytes, robot);
  Session session(files);
  Plan plan;
  plan.configs.emplace_back();
  plan.models.push_back({robot, 0});
  const Report report = session.check(plan);
  Exercise result;
  for (const Diagnostic& one : report.diagnostics) {
    if (one.span.begin > one.span.end ||
        one.span.end > session.sources().text(one.span.source).size()) {
      result.broken.push_back(std::string(one.rule->id) + ": a span beyond the end of the file");
    }
    if (render_full(one, session.sources(), {}).empty()) result.broken.emplace_back("no report");
  }
  require_kept(result);
  return 0;
}
