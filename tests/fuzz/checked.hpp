// SPDX-License-Identifier: BSD-3-Clause
// The whole check of a bundle of files, as a command line would run it.
#pragma once

#include "fuzz/bundle.hpp"
#include "smurf/check.hpp"
#include "smurf/render.hpp"

namespace smurf::test {

/// Checks `model` with the configuration `config` ("": none). Every finding must lie in its file
/// and must have a report.
inline void require_checked(const MemoryFiles& files, const std::string& model,
                            const std::string& config = {}) {
  Session session(files);
  Plan plan;
  plan.configs.push_back(config);
  plan.models.push_back({model, 0});
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
}

}  // namespace smurf::test
