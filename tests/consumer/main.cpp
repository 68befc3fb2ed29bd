// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include <smurf/lint.hpp>
#include <smurf/load.hpp>

int main(int, char** argv) {
  smurf::SourceMap sources;
  smurf::DiskFiles files;
  smurf::DiagnosticSink sink;
  smurf::LoadContext context{sources, files, sink, {}, {}};
  const smurf::LinkedModel model = smurf::load_model(argv[1], context);
  smurf::lint_model(model, {}, sink);
  std::printf("%zu motors, %zu findings\n", model.annotations.motors.size(),
              sink.diagnostics().size());
  return sink.has_errors() ? 1 : 0;
}
