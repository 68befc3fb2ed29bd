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

/// "[SML1408](rules/sml14.md#sml1408-bounds-equal)", for a page in docs/.
inline std::string link_to(const Rule& rule) {
  const std::string address = rule_address(rule, "");
  return "[" + std::string(rule.id) + "](" + address.substr(address.find("rules/")) + ")";
}

/// `name` is that of a file in docs/.
inline void check_page(const std::string& name, const std::string& page) {
  const std::filesystem::path path = std::filesystem::path(SMURF_FIXTURES) / ".." / "docs" / name;
  if (std::getenv("SMURF_UPDATE_SNAPSHOTS") != nullptr) {
    std::ofstream(path, std::ios::binary) << page;
  }
  CHECK_MESSAGE(read_page(path) == page,
                "docs/" << name << " is stale: run with SMURF_UPDATE_SNAPSHOTS=1");
}

}  // namespace smurf::test
