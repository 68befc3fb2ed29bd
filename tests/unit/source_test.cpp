// SPDX-License-Identifier: BSD-3-Clause
#include <doctest/doctest.h>

#include "smurf/source.hpp"

using namespace smurf;

TEST_CASE("source: lines and columns count code points") {
  struct Row {
    std::string text;
    std::uint32_t offset;
    Position position;
  };
  const Row rows[] = {
      {"", 0, {1, 1}},
      {"ab", 0, {1, 1}},
      {"ab", 2, {1, 3}},
      {"a\nb", 1, {1, 2}},
      {"a\nb", 2, {2, 1}},
      {"a\n", 2, {2, 1}},
      {"\n\n\n", 2, {3, 1}},
      {"a\r\nb", 3, {2, 1}},
      {"\xC3\xA4\xE2\x82\xACx", 2, {1, 2}},
      {"\xC3\xA4\xE2\x82\xACx", 5, {1, 3}},
      {"\xF0\x9F\xA4\x96x", 4, {1, 2}},
      {"\xEF\xBB\xBF"
       "ab",
       0,
       {1, 1}},
      {"\xEF\xBB\xBF"
       "ab",
       3,
       {1, 1}},
      {"\xEF\xBB\xBF"
       "ab",
       4,
       {1, 2}},
      {"\xEF\xBB\xBF"
       "a\nb",
       5,
       {2, 1}},
      {"a\n\xEF\xBB\xBF"
       "b",
       5,
       {2, 2}},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CAPTURE(row.offset);
    SourceMap sources;
    const SourceId id = sources.add("a", row.text);
    const Position at = sources.position(id, row.offset);
    CHECK(at.line == row.position.line);
    CHECK(at.column == row.position.column);
    CHECK(sources.line_of(id, row.offset) == row.position.line);
  }
}

TEST_CASE("source: bytes of a line") {
  SourceMap sources;
  const SourceId id = sources.add("a", "one\ntwo\r\n\nlast");
  REQUIRE(sources.line_count(id) == 4);
  CHECK(sources.text(sources.line_span(id, 1)) == "one");
  CHECK(sources.text(sources.line_span(id, 2)) == "two");
  CHECK(sources.text(sources.line_span(id, 3)).empty());
  CHECK(sources.text(sources.line_span(id, 4)) == "last");
  const SourceId ends = sources.add("b", "x\n");
  CHECK(sources.line_count(ends) == 2);
  CHECK(sources.text(sources.line_span(ends, 2)).empty());
}

TEST_CASE("source: views stay valid while the map grows") {
  SourceMap sources;
  const SourceId first = sources.add("first", "short");
  const std::string_view text = sources.text(first);
  for (int i = 0; i < 1000; ++i) sources.add("more", "x");
  CHECK(text == "short");
  CHECK(text.data() == sources.text(first).data());
  CHECK(sources.size() == 1001);
}

TEST_CASE("source: what could not be read has a path and no text") {
  SourceMap sources;
  const SourceId id = sources.add_unreadable("gone.urdf");
  CHECK(sources.path(id) == "gone.urdf");
  CHECK(!sources.is_readable(id));
  CHECK(sources.text(id).empty());
  CHECK(sources.position(id, 0) == Position{1, 1});
}

TEST_CASE("source: copies share the texts") {
  SourceMap sources;
  const SourceId id = sources.add("config", std::string(1000, 'x'));
  const SourceMap copy = sources;
  CHECK(copy.text(id).data() == sources.text(id).data());
  CHECK(copy.path(id) == "config");
}

TEST_CASE("source: what is taken twice is kept once, unless it has changed meanwhile") {
  SourceMap all;
  const SourceId config = all.add("config", "c");
  const auto taken = [&](const std::string& text) {
    SourceMap other;
    other.add("config", "c");
    const SourceId id = other.add("r.urdf", text);
    return all.take(std::move(other), 1)(Span{id, 0, 1}).source;
  };
  const SourceId first = taken("one");
  const SourceId second = taken("one");
  const SourceId changed = taken("two");
  CHECK(all.size() == 4);
  CHECK(first != second);
  CHECK(all.text(first).data() == all.text(second).data());
  CHECK(all.text(second) == "one");
  CHECK(all.text(changed) == "two");
  CHECK(all.path(changed) == "r.urdf");
  CHECK(all.text(config) == "c");
}

TEST_CASE("source: spans are half open") {
  const Span span{SourceId{0}, 2, 4};
  CHECK(!span.contains(1));
  CHECK(span.contains(2));
  CHECK(span.contains(3));
  CHECK(!span.contains(4));
  CHECK(!span.empty());
  CHECK(Span{}.empty());
}

TEST_CASE("lines of a long text are where a count from its beginning finds them") {
  // Lines of all lengths: some empty, and one longer than any block for counting.
  std::string text;
  for (std::size_t i = 0; i < 3000; ++i) text += std::string(i % 17, 'x') + '\n';
  text += std::string(20000, 'y') + '\n';
  for (std::size_t i = 0; i < 3000; ++i) text += std::string(i % 5, 'z') + '\n';
  SourceMap sources;
  const SourceId id = sources.add("long.txt", text);
  std::uint32_t line = 1;
  std::uint32_t begin = 0;
  for (std::uint32_t at = 0; at <= text.size(); ++at) {
    CAPTURE(at);
    REQUIRE(sources.position(id, at) == Position{line, at - begin + 1});
    if (at == text.size() || text[at] != '\n') continue;
    REQUIRE(sources.line_span(id, line) == Span{id, begin, at});
    ++line;
    begin = at + 1;
  }
  CHECK(sources.line_count(id) == line);
}
