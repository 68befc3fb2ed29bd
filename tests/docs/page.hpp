// SPDX-License-Identifier: BSD-3-Clause
// Pages of docs/ that are made from tables: a test fails when one is stale, and writes it when
// SMURF_UPDATE_SNAPSHOTS is set.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "smurf/render.hpp"

namespace smurf::test {

/// "" if there is no such file.
inline std::string read_page(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::string in_lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// "sml14", the page of the rule in docs/rules/: one per digit, and one per two digits for the many
/// rules about URDF.
inline std::string page_of(const Rule& rule) {
  return in_lower_case(std::string(rule.id.substr(0, rule.id.starts_with("SML1") ? 5 : 4)));
}

/// "sml1408-bounds-equal", its heading on that page.
inline std::string heading_of(const Rule& rule) {
  return in_lower_case(std::string(rule.id)) + "-" + std::string(rule.name);
}

/// "[SML1408](rules/sml14.md#sml1408-bounds-equal)", for a page in docs/.
inline std::string link_to(const Rule& rule) {
  return "[" + std::string(rule.id) + "](rules/" + page_of(rule) + ".md#" + heading_of(rule) + ")";
}

/// `name` is that of a file in docs/.
inline void check_page(const std::string& name, const std::string& page) {
  const std::filesystem::path path = std::filesystem::path(SMURF_ROOT) / "docs" / name;
  if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
    std::ofstream(path, std::ios::binary) << page;
  }
  CHECK_MESSAGE(read_page(path) == page,
                "docs/" << name << " is stale: run with SMURF_UPDATE_SNAPSHOTS=1");
}

}  // namespace smurf::test
