// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include <smurf/check.hpp>

int main(int, char** argv) {
  smurf::Session session;
  smurf::LoadedModel loaded = session.load_model(argv[1]);
  const smurf::Report report = session.check(loaded);
  std::printf("%zu motors, %zu findings\n", loaded.model.annotations.motors.size(),
              report.diagnostics.size());
  return report.summary.errors > 0 ? 1 : 0;
}
