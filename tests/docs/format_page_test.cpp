// SPDX-License-Identifier: BSD-3-Clause
// docs/format/keys.md is made from the tables that the readers use; this test fails when it is
// stale. SMURF_UPDATE_SNAPSHOTS=1 writes it.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "ast/format.hpp"
#include "docs/page.hpp"
#include "smurf/readers.hpp"

using namespace smurf;

namespace {

std::string anchor_of(std::string_view name) {
  std::string anchor(name);
  std::replace(anchor.begin(), anchor.end(), ' ', '-');
  return anchor;
}

std::string code(std::string_view text) {
  return text.empty() ? "" : "`" + std::string(text) + "`";
}

void write_part(std::ostream& page, const FormatPart& part) {
  page << "\n## " << part.name << "\n\n" << part.doc << " Written as " << part.form << ".\n";
  if (!part.aliases.empty()) {
    page << "\nAlso written:";
    for (const std::string_view alias : part.aliases) page << " " << code(alias);
    page << ".\n";
  }
  if (!part.read_by.empty()) page << "\nRead by: " << part.read_by << ".\n";
  if (!part.more.empty()) {
    page << "\nAn entry may also have the keys of [" << part.more << "](#" << anchor_of(part.more)
         << ").\n";
  }
  page << "\n| key | type | unit | default | read by | meaning |\n|---|---|---|---|---|---|\n";
  for (const KeyDescription& key : part.keys) {
    page << "| `" << key.path << "`" << (key.is_required ? " (required)" : "") << " | " << key.type
         << " | " << key.unit << " | " << code(key.fallback) << " | " << key.read_by << " | "
         << key.doc << " |\n";
  }
}

std::string keys_page() {
  std::ostringstream page;
  page << "# Keys\n\n"
          "Every section and key of SMURF models and scenes. Made from the key tables in "
          "`libsmurf/src/ast` by `format_page_test`; do not edit. How the files fit together is "
          "described in [the guide](README.md).\n\n"
          "The default is that of MARS 1; no default means that nothing changes when the key is "
          "absent. An empty \"read by\" means the readers of the whole section. \"nobody\" means "
          "that programs write the key, and none reads it. Keys that are not listed are kept for "
          "plug-ins. `smurf-lint --explain SECTION` prints the same tables.\n\n";
  const std::vector<FormatPart> parts = describe_format();
  for (const FormatPart& part : parts) {
    page << "- [" << part.name << "](#" << anchor_of(part.name) << "): " << part.doc << "\n";
  }
  for (const FormatPart& part : parts) write_part(page, part);
  return page.str();
}

}  // namespace

TEST_CASE("docs/format/keys.md is what the key tables say") {
  test::check_page("format/keys.md", keys_page());
}

TEST_CASE("The readers of a key are named as in the table of readers") {
  std::set<std::string_view> titles = {"nobody", "Rock"};
  for (const Reader* reader : all_readers()) titles.insert(reader->title);
  for (const FormatPart& part : describe_format()) {
    for (const KeyDescription& key : part.keys) {
      std::string_view left = key.read_by;
      while (!left.empty()) {
        const std::size_t comma = std::min(left.find(", "), left.size());
        CHECK_MESSAGE(titles.contains(left.substr(0, comma)), part.name << ": " << key.path);
        left.remove_prefix(std::min(comma + 2, left.size()));
      }
    }
  }
}
