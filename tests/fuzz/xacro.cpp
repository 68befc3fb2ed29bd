// SPDX-License-Identifier: BSD-3-Clause
// A robot of xacro with the files that it includes: expansion, places, and all that follows.
#include "fuzz/bundle.hpp"
#include "fuzz/clock.hpp"
#include "smurf/load.hpp"

using namespace smurf;
using namespace smurf::test;

namespace {

bool is_inside(const SourceMap& sources, Span span) {
  return static_cast<std::size_t>(span.source) < sources.size() && span.begin <= span.end &&
         span.end <= sources.text(span.source).size();
}

/// The parts of the result follow each other, and bytes called exact are those of their origin.
void check_map(const xacro::Expansion& expansion, const SourceMap& sources, Exercise& result) {
  const std::string_view text = sources.text(expansion.source);
  std::uint32_t last = 0;
  for (const xacro::Leaf& leaf : expansion.leaves) {
    if (leaf.begin < last || leaf.begin > leaf.end || leaf.end > text.size()) {
      result.broken.emplace_back("parts of the expansion are not in order");
      return;
    }
    last = leaf.begin;
    if (!is_inside(sources, leaf.origin) || !is_inside(sources, leaf.use)) {
      result.broken.emplace_back("an origin beyond the end of its file");
      return;
    }
    if (!leaf.is_exact) continue;
    if (sources.text(leaf.origin) != text.substr(leaf.begin, leaf.end - leaf.begin)) {
      result.broken.emplace_back("bytes called exact are not those of their origin");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const smurf::test::Clock clock(2);
  const std::string path = "r.urdf.xacro";
  const MemoryFiles files =
      unbundle(std::string_view(reinterpret_cast<const char*>(data), size), path);
  SourceMap sources;
  Limits limits;
  limits.xacro_steps = 200'000;
  limits.xacro_elements = 10'000;
  limits.xacro_bytes = 20'000'000;
  DiagnosticSink sink(limits);
  LoadContext context{sources, files, sink, limits, {}};
  context.xacro.arguments["name"] = "r";
  Exercise result;
  const xacro::Expansion expansion = load_xacro(path, context);
  for (const Diagnostic& one : sink.diagnostics()) {
    if (!is_inside(sources, one.span)) {
      result.broken.emplace_back("a finding beyond the end of its file");
    }
  }
  if (expansion.is_complete) {
    check_map(expansion, sources, result);
  } else if (!sink.has_errors()) {
    result.broken.emplace_back("an expansion fails without an error");
  }
  // The rules and reports, for results that are not larger than a fuzzed URDF.
  constexpr std::size_t kLargest = 50'000;
  const bool is_small = expansion.is_complete && sources.text(expansion.source).size() < kLargest;
  if (result.broken.empty() && is_small) result = exercise(files, path, {.fixes = true});
  require_kept(result);
  return 0;
}
