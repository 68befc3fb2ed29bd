// SPDX-License-Identifier: BSD-3-Clause
// An archive and its scene: names stay inside, sizes stay within the limits.
#include <algorithm>

#include "archive/zip.hpp"
#include "base/files/path.hpp"
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

std::vector<std::string> broken_promises(const Archive& archive, const Limits& limits) {
  std::vector<std::string> broken;
  std::uint64_t bytes = 0;
  for (const ArchivedFile& file : archive.files) {
    bytes += file.text.size();
    if (file.path.empty() || path::is_absolute(file.path) ||
        path::normalize(file.path) != file.path || file.path.starts_with("..")) {
      broken.push_back("a file outside of its archive: " + file.path);
    }
  }
  if (!archive.reason.empty() && !archive.files.empty()) broken.emplace_back("half an archive");
  if (bytes > limits.archive_bytes) broken.emplace_back("more bytes than the limit");
  if (archive.files.size() > limits.archive_files) broken.emplace_back("more files than the limit");
  if (!std::is_sorted(archive.files.begin(), archive.files.end(),
                      [](const auto& a, const auto& b) { return a.path < b.path; })) {
    broken.emplace_back("the files are not sorted");
  }
  return broken;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock;
  Limits limits;
  limits.archive_bytes = 1U << 20U;
  limits.archive_files = 100;
  Archive archive = read_zip({reinterpret_cast<const char*>(data), size}, limits);
  Exercise result;
  result.broken = broken_promises(archive, limits);
  require_kept(result);
  MemoryFiles files;
  std::string scene;
  for (ArchivedFile& file : archive.files) {
    if (path::extension(file.path) == ".smurfs") scene = file.path;
    files.add(file.path, std::move(file.text));
  }
  if (!scene.empty()) require_kept(exercise(files, scene));
  return 0;
}
