// SPDX-License-Identifier: BSD-3-Clause
#include "render/line_hash.hpp"

#include <doctest/doctest.h>

using smurf::render::LineHashes;

namespace {

std::vector<std::string> line_hashes(std::string_view text) {
  const LineHashes hashes(text);
  std::vector<std::string> all;
  for (std::size_t line = 0; line < hashes.size(); ++line) all.push_back(hashes.of(line));
  return all;
}

}  // namespace

TEST_CASE("line hashes are those of GitHub code scanning") {
  using Hashes = std::vector<std::string>;
  // The first vector is one of codeql-action's own tests.
  const Hashes expected = {"271789c17abda88f:1", "54703d4cd895b18:1", "180aee12dab6264:1",
                           "a23a3dc5e078b07b:1"};
  CHECK(line_hashes(" a\nb\n  \t\tc\n d") == expected);
  CHECK(line_hashes(" a\r\nb\r\n  \t\tc\r\n d") == expected);
  CHECK(line_hashes(" a\rb\r  \t\tc\r d") == expected);
  CHECK(line_hashes("").size() == 1);
  // Equal lines are distinguished by the following lines, and at the end by their number.
  const std::string same(200, '\n');
  CHECK(line_hashes(same).size() == 201);
  CHECK(line_hashes(same)[99].ends_with(":100"));
}
