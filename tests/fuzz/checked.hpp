// SPDX-License-Identifier: BSD-3-Clause
// Checks a bundle of files as the command line would.
#pragma once

#include "fuzz/bundle.hpp"
#include "smurf/check.hpp"
#include "smurf/render.hpp"

namespace smurf::test {

/// Checks `model` with the configuration `config` ("": none). Every finding must keep the promises
/// of check_findings(), and have a report.
inline void require_checked(const MemoryFiles& files, const std::string& model,
                            const std::string& config = {}) {
  Session session(files);
  Plan plan;
  plan.configs.push_back(config);
  plan.models.push_back({model, 0});
  const Report report = session.check(plan);
  Exercise result;
  check_findings(report.diagnostics, session.sources(), result);
  for (const Diagnostic& one : report.diagnostics) {
    if (render_full(one, session.sources(), {}).empty()) result.broken.emplace_back("no report");
  }
  require_kept(result);
}

}  // namespace smurf::test
