// SPDX-License-Identifier: BSD-3-Clause
#include "common/rename/planned_rename.hpp"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/rename/loaded_names.hpp"
#include "plan/models_around.hpp"
#include "plan/shared_files.hpp"

namespace smurf::tools {
namespace {

/// The reason why a file must not be changed: it cannot be written, or other models also read it,
/// each of which is named once.
std::vector<std::string> problems_of(const std::string& path, const LoadedNames& loaded,
                                     const FileReader& changeable, ModelsAround& around,
                                     std::set<std::string>& named) {
  if (!DiskFiles().is_file(path)) {
    return {"'" + path + "' is in an archive, which is not written"};
  }
  if (changeable.is_denied(path)) {
    return {"'" + path + "' is in no project of the named files; name it, too"};
  }
  std::vector<std::string> problems;
  for (const std::string& model : around.listing(path)) {
    if (loaded.has_read(model) || !named.insert(model).second) continue;
    problems.push_back("'" + model + "' reads '" + path + "' as well; name it, too");
  }
  return problems;
}

}  // namespace

Renamed rename_planned(const Plan& plan, CheckSettings settings, std::span<const Rename> renames,
                       Session& session, const FileReader& changeable, const std::string& input,
                       std::set<std::string>* read, bool leaves_shared) {
  settings.opens_meshes = false;
  constexpr auto kReach = LoadedNames::Reach::surroundings;
  LoadedNames before(plan, settings, session, kReach, LoadedNames::Keeps::names);
  if (!before.problem().empty()) return {{}, {}, {before.problem()}};
  if (read != nullptr) *read = before.read();
  SharedFiles shared =
      shared_files(before.names(), renames, session.loaded_sources(), session.files(),
                   [&](const std::string& path) { return before.has_read(path); });
  before.leave(shared.paths);
  Renamed renamed = rename(before.names(), renames, session.loaded_sources());
  if (!leaves_shared && !shared.problems.empty()) {
    shared.problems.insert(shared.problems.end(), renamed.problems.begin(), renamed.problems.end());
    return {{}, {}, std::move(shared.problems)};
  }
  if (!renamed.problems.empty()) return renamed;
  ModelsAround around(session.files());
  std::set<std::string> named;
  for (const FixedText& file : renamed.texts) {
    if (file.path == input) continue;
    const auto more = problems_of(file.path, before, changeable, around, named);
    renamed.problems.insert(renamed.problems.end(), more.begin(), more.end());
  }
  if (!renamed.problems.empty()) return renamed;
  for (const FixedText& file : renamed.texts) session.set_text(file.path, file.text);
  LoadedNames after(plan, settings, session, kReach, LoadedNames::Keeps::names);
  after.leave(shared.paths);
  renamed.problems = changed_meanings(before.names(), after.names(), session.loaded_sources());
  return renamed;
}

}  // namespace smurf::tools
