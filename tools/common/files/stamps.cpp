// SPDX-License-Identifier: BSD-3-Clause
#include "common/files/stamps.hpp"

#include <csignal>
#include <vector>

#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/text/counted.hpp"

namespace smurf::tools {
namespace {

volatile std::sig_atomic_t is_interrupted = 0;

extern "C" void note_interruption(int) {
  is_interrupted = 1;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

Interruption::Interruption() {
  is_interrupted = 0;
  std::signal(SIGINT, note_interruption);
}

Interruption::~Interruption() { std::signal(SIGINT, SIG_DFL); }

bool Interruption::has_come() { return is_interrupted != 0; }

Stamp stamp_of(const std::string& path) {
  sys::Status status{};
  if (sys::stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::tuple(static_cast<std::int64_t>(status.st_mtim.tv_sec),
                    static_cast<std::int64_t>(status.st_mtim.tv_nsec),
                    static_cast<std::int64_t>(status.st_size));
}

Stamps stamps_of(const std::set<std::string>& paths) {
  Stamps stamps;
  for (const std::string& path : paths) stamps.emplace(path, stamp_of(path));
  return stamps;
}

std::string describe_changes(const Stamps& before, const Stamps& after) {
  std::vector<std::string> names;
  for (const auto& [path, stamp] : after) {
    const auto old = before.find(path);
    if ((old == before.end() || old->second != stamp) && !places::is_folder(path)) {
      names.push_back(path);
    }
  }
  for (const auto& [path, stamp] : before) {
    if (!after.contains(path)) names.push_back(path);
  }
  if (names.empty()) return "a folder has changed";
  if (names.size() == 1) return names.front() + " has changed";
  return names.front() + " and " + counted(names.size() - 1, "more file") + " have changed";
}

}  // namespace smurf::tools
