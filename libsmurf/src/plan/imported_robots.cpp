// SPDX-License-Identifier: BSD-3-Clause
#include "plan/imported_robots.hpp"

#include <algorithm>
#include <set>

#include "base/files/path.hpp"
#include "base/files/standard_input.hpp"
#include "base/text/words.hpp"
#include "imports/imports.hpp"
#include "mjcf/mjcf.hpp"
#include "sdf/sdf.hpp"
#include "smurf/companions.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/source.hpp"

namespace smurf {
namespace {

/// The files that `<include file="...">` names, as they are written.
std::vector<std::string_view> parts_in(std::string_view text) {
  std::vector<std::string_view> parts;
  constexpr std::string_view kTag = "<include";
  constexpr std::string_view kName = "file=";
  for (std::size_t at = text.find(kTag); at != std::string_view::npos;
       at = text.find(kTag, at + kTag.size())) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    const std::size_t name = tag.find(kName);
    if (name == std::string_view::npos || name + kName.size() >= tag.size()) continue;
    const std::string_view value = tag.substr(name + kName.size());
    const std::size_t end = value.find(value.front(), 1);
    if (end != std::string_view::npos) parts.push_back(value.substr(1, end - 1));
  }
  return parts;
}

}  // namespace

bool may_be_imported(std::string_view path) {
  return is_one_of(path::to_lower(path::extension(path)), {".xml", ".mjcf", ".sdf", ".world"}) &&
         !is_companion_path(path);
}

bool is_imported(std::string_view text) {
  return sdformat::is_sdf(text) || (mjcf::is_mjcf(text) && !mjcf::is_part(text));
}

std::string standard_input_name(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '<') return {};
  const std::string name(kStandardInput);
  if (mjcf::is_mjcf(text)) return name + ".xml";
  if (sdformat::is_sdf(text)) return name + ".sdf";
  const bool is_xacro = imports::root_tag(text).find("xmlns:xacro") != std::string_view::npos;
  return name + (is_xacro ? ".urdf.xacro" : ".urdf");
}

std::vector<std::string> imported_robots(const std::vector<std::string>& files,
                                         const FileReader& reader, const Limits& limits) {
  std::vector<std::string> robots;
  // MuJoCo looks from the folder of the main file, which may be any, so only names are compared.
  std::set<std::string, std::less<>> parts;
  for (const std::string& file : files) {
    const FileContent content = reader.read(file, limits.file_bytes);
    if (content.status != ReadStatus::ok) continue;
    if (mjcf::is_mjcf(content.text)) {
      for (const std::string_view part : parts_in(content.text))
        parts.emplace(path::file_name(part));
    }
    if (is_imported(content.text)) robots.push_back(file);
  }
  std::erase_if(robots,
                [&](const std::string& one) { return parts.contains(path::file_name(one)); });
  return robots;
}

}  // namespace smurf
