// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/one_model.hpp"

#include <array>
#include <optional>
#include <span>

#include "common/files/input.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/check.hpp"
#include "smurf/confine.hpp"

namespace smurf::tools {

ExitCode show_model(const LintOptions& options, const std::string& path,
                    const std::function<std::optional<std::string>(const LinkedModel&)>& show) {
  ConfinedFiles disk;
  confine(disk, std::array{path, options.config}, options.packages, options.allow_outside);
  disk.allow(options.config);
  const InputFiles files(disk);
  Session session(files, options.limits);
  const std::optional<std::string> main = find_main_file(kSmurfLint, path, session.files());
  if (!main) return kFailed;
  const InputKind kind = input_kind(*main);
  if (kind != InputKind::model && kind != InputKind::urdf) {
    complain(kSmurfLint, "'" + path + "' is not a model or URDF");
    return kFailed;
  }
  const LoadedModel loaded = session.load_model(*main, check_settings(options));
  if (!loaded.model.robot) {
    complain(kSmurfLint, "'" + path + "' has no robot that can be read");
    return kFailed;
  }
  if (!keeps_inputs(kSmurfLint, files, std::span(&options.output, 1))) return kFailed;
  const std::optional<std::string> text = show(loaded.model);
  return text && write_output(kSmurfLint, options.output, *text) ? kDone : kFailed;
}

}  // namespace smurf::tools
