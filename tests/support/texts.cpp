// SPDX-License-Identifier: BSD-3-Clause
#include "support/texts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace smurf::test {

std::vector<std::string> texts_below(const std::string& folder,
                                     std::span<const std::string_view> extensions) {
  std::vector<std::string> texts;
  if (!std::filesystem::exists(folder)) return texts;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (!entry.is_regular_file() || std::ranges::count(extensions, extension) == 0) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

std::string mutated(std::string text, std::string (*token)(Random&), Random& random) {
  for (std::size_t i = 1 + random.below(3); i > 0 && !text.empty(); --i) {
    const std::size_t at = random.below(text.size());
    const std::size_t count = 1 + random.below(random.one_in(3) ? 20 : 2);
    switch (random.below(4)) {
    case 0: text.erase(at, count); break;
    case 1: text.insert(at, token(random)); break;
    case 2: text.insert(at, text.substr(random.below(text.size()), count)); break;
    default: text.replace(at, std::min(count, text.size() - at), token(random)); break;
    }
  }
  return text;
}

std::string some_lines(const std::string& text, Random& random) {
  std::size_t begin = text.rfind('\n', random.below(text.size() + 1));
  begin = begin == std::string::npos ? 0 : begin + 1;
  std::size_t end = begin;
  for (std::size_t lines = 1 + random.below(8); lines > 0 && end < text.size(); --lines) {
    end = std::min(text.find('\n', end), text.size() - 1) + 1;
  }
  return text.substr(begin, end - begin);
}

void compare_files(std::span<const std::string_view> extensions, Compare compare, double share) {
  for (const std::string folder : {SMURF_FIXTURES, SMURF_SHARED "/corpus"}) {
    const std::vector<std::string> texts = texts_below(folder, extensions);
    const auto compared = static_cast<double>(std::ranges::count_if(texts, compare));
    MESSAGE(folder << ": " << compared << " of " << texts.size() << " files are compared");
    CHECK(compared >= share * static_cast<double>(texts.size()));
  }
}

void compare_made(std::span<const std::string_view> extensions, Compare compare, double share,
                  std::string (*make)(const std::string& seed, Random& random)) {
  std::vector<std::string> seeds = texts_below(SMURF_FIXTURES, extensions);
  std::erase_if(seeds, [](const std::string& text) { return text.empty() || text.size() > 20000; });
  REQUIRE(seeds.size() > 100);
  const char* given = std::getenv("SMURF_TEST_CASES");
  const std::size_t count = given != nullptr ? std::strtoull(given, nullptr, 10) : 20000;
  Random random;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < count; ++i) {
    compared += compare(make(seeds[random.below(seeds.size())], random)) ? 1U : 0U;
  }
  MESSAGE(compared << " of " << count << " made texts are compared");
  CHECK(static_cast<double>(compared) > share * static_cast<double>(count));
}

}  // namespace smurf::test
