// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/copy_files.hpp"

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "common/files/output.hpp"
#include "smurf/check.hpp"

namespace smurf::tools {
namespace {

/// Whether a symbolic link is on the way from the folder to the place. The file may then be
/// anywhere, so it is not compared.
bool is_behind_link(const AssetCopy& copy) {
  const std::string whole = copy.to();
  for (std::size_t end = copy.folder.size(); end != std::string::npos && end < whole.size();) {
    end = whole.find('/', end + 1);
    if (places::is_link(whole.substr(0, end))) return true;
  }
  return false;
}

bool is_in_place(const AssetCopy& copy) {
  return !is_behind_link(copy) && places::is_same(copy.from, copy.to());
}

}  // namespace

std::vector<std::string> places_of(const AssetCopies& copies, const InputFiles& inputs) {
  std::vector<std::string> places;
  for (const AssetCopy& copy : copies) {
    inputs.add(copy.from);
    if (!is_in_place(copy)) places.push_back(copy.to());
  }
  return places;
}

bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits, bool overwrite, const std::function<bool()>& write_result) {
  const DiskFiles disk;
  AssetCopies missing;
  for (const AssetCopy& copy : copies) {
    if (is_in_place(copy)) continue;
    const bool is_bin = copy.is_buffer && path::extension(copy.inside) == ".bin";
    if (!is_bin && input_kind(copy.to()) != InputKind::resource) {
      complain(tool, "cannot copy '" + copy.from +
                         "': its name is not that of a mesh or image; nothing was written");
      return false;
    }
    // The writer reports links and files that cannot be read.
    if (overwrite || is_behind_link(copy)) {
      missing.push_back(copy);
      continue;
    }
    const FileContent there = disk.read(copy.to(), limits.mesh_bytes);
    const FileContent wanted = renamed(files.read(copy.from, limits.mesh_bytes), copy);
    if (there.status == ReadStatus::not_found || wanted.status != ReadStatus::ok) {
      missing.push_back(copy);
    } else if (there.status != ReadStatus::ok || there.text != wanted.text) {
      complain(tool, "cannot write '" + copy.to() +
                         "': another file is there; see --overwrite; nothing was written");
      return false;
    }
  }
  RepeatedReads repeated(files, limits);
  std::vector<OutputFile> outputs;
  for (const AssetCopy& copy : missing) {
    outputs.push_back({.folder = copy.folder, .path = copy.inside, .read = [&repeated, &copy] {
                         return renamed(repeated.read(copy.from), copy);
                       }});
  }
  return write_files(tool, outputs, overwrite, write_result);
}

}  // namespace smurf::tools
