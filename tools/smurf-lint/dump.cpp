// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/dump.hpp"

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "base/findings/limits.hpp"
#include "common/files/input.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/check.hpp"
#include "smurf/confine.hpp"
#include "smurf/write.hpp"

namespace smurf::tools {
namespace {

/// The path to load, which may be in an archive. Reports an error and returns none if it cannot be
/// loaded.
std::optional<std::string> main_file(const std::string& path, const FileReader& files) {
  std::optional<std::string> main = find_main_file(kSmurfLint, path, files);
  if (!main || *main != path) return main;
  const InputKind kind = input_kind(path);
  if (kind != InputKind::resource && kind != InputKind::other) return main;
  complain(kSmurfLint, "'" + path + "' is not a model, scene, URDF or annotation file");
  return std::nullopt;
}

/// The result as JSON, and the findings of reading.
struct Dump {
  std::optional<std::string> json;
  std::vector<Diagnostic> found;
};

Dump dump(const std::string& path, Session& session, const LintOptions& options) {
  const InputKind kind = input_kind(path);
  const CheckSettings settings = check_settings(options);
  const std::uint64_t most = options.limits.scene_bytes;
  if (kind == InputKind::scene || kind == InputKind::drawing) {
    LoadedScene loaded = session.load_scene(path, settings);
    return {write_scene_json(loaded.scene, *loaded.sources, most),
            session.settle(loaded, loaded.found.take())};
  }
  LoadedModel loaded = session.load_model(path, settings);
  return {write_model_json(loaded.model, *loaded.sources, most),
          session.settle(loaded, loaded.found.take())};
}

}  // namespace

ExitCode dump_model(const LintOptions& options) {
  ConfinedFiles disk;
  confine(disk, std::array{options.dump_model, options.config}, options.packages,
          options.allow_outside);
  disk.allow(options.config);
  const InputFiles files(disk);
  Session session(files, options.limits);
  const auto path = main_file(options.dump_model, session.files());
  if (!path) return kFailed;
  const Dump dumped = dump(*path, session, options);
  if (!tools::keeps_inputs(kSmurfLint, files, std::span(&options.output, 1))) return kFailed;
  if (!dumped.json) {
    complain(kSmurfLint, "what is in '" + options.dump_model + "' has more than " +
                             std::to_string(options.limits.scene_bytes) + " bytes of JSON; " +
                             raise_limit("scene-bytes"));
    return kFailed;
  }
  if (!write_output(kSmurfLint, options.output, *dumped.json)) return kFailed;
  for (const Diagnostic& one : dumped.found) {
    write_error(
        render_concise(one, session.loaded_sources(), style_for(Stream::error, options.color)));
  }
  return judge(summarize(dumped.found), options.threshold);
}

}  // namespace smurf::tools
