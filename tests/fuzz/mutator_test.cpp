// SPDX-License-Identifier: BSD-3-Clause
// The mutator of the fuzz targets: equal seeds give equal results, within the bound, and most files
// can still be read.
#include "fuzz/mutator.hpp"

#include <doctest/doctest.h>

#include "fuzz/bundle.hpp"
#include "fuzz/xacro_changes.hpp"
#include "smurf/load.hpp"

using namespace smurf;
using namespace smurf::test;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) {
  return size;
}

namespace {

const std::string kModel =
    "%%% r.smurf\nmodelname: r\nfiles: [r.urdf, motors.yml]\n"
    "%%% motors.yml\nmotors:\n- name: m\n  joint: j\n  type: PID\n  maxSpeed: 2.0\n"
    "%%% r.urdf\n<robot name='r'><link name='a'/><link name='b'/>\n"
    "<joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint></robot>\n";

}  // namespace

TEST_CASE("mutations of a model differ, repeat themselves, and mostly can be read") {
  constexpr std::size_t kMost = 1000;
  constexpr std::uint64_t kCount = 500;
  std::set<std::string> all;
  std::size_t readable = 0;
  for (std::uint64_t seed = 0; seed < kCount; ++seed) {
    Random random(seed);
    Random again(seed);
    const std::string text = mutated_bundle(kModel, kModel, kMost, random);
    CHECK(text == mutated_bundle(kModel, kModel, kMost, again));
    CHECK(text.size() <= kMost);
    all.insert(text);
    const Exercise result = exercise(unbundle(text, "r.smurf"), "r.smurf", {.converts = true});
    CHECK(result.broken.empty());
    readable += result.unreadable.empty() ? 1U : 0U;
  }
  MESSAGE(all.size() << " texts, " << readable << " of " << kCount << " can be read");
  CHECK(all.size() > kCount / 2);
  CHECK(readable > kCount / 2);
}

TEST_CASE("expressions and elements of xacro change, and often still expand") {
  const std::string robot =
      "%%% r.urdf.xacro\n<robot name='r' xmlns:xacro='x'><xacro:property name='x' value='2'/>"
      "<xacro:macro name='m' params='x *b'><link name=\"${'l%d' % x}\"/></xacro:macro>"
      "<xacro:m x='${x + 1}'><a/></xacro:m></robot>\n";
  constexpr std::uint64_t kCount = 500;
  std::set<std::string> all;
  std::size_t expanded = 0;
  for (std::uint64_t seed = 0; seed < kCount; ++seed) {
    Random random(seed);
    std::string text = robot;
    if (!XacroChange(text, random).run()) continue;
    all.insert(text);
    const MemoryFiles files = unbundle(text, "r.urdf.xacro");
    SourceMap sources;
    const Limits limits;
    DiagnosticSink sink(limits);
    LoadContext context{sources, files, sink, limits, {}};
    expanded += load_xacro("r.urdf.xacro", context).is_complete ? 1U : 0U;
  }
  MESSAGE(all.size() << " texts, " << expanded << " expand");
  CHECK(all.size() > kCount / 2);
  CHECK(expanded > kCount / 10);
}

TEST_CASE("what is no tree stays as it is") {
  Random random(1);
  for (const char* text : {"", "a: [", "<a", "%%% a\n", "%%% ", "\xff"}) {
    CHECK(mutated_bundle(text, text, 1000, random) == text);
  }
}

TEST_CASE("nothing is read beyond the end of small bundles") {
  for (const char* text : {"a", "- a", "[a]", "{a: b}", "<a/>", "<a b=''/>", "%%% x\na: 1",
                           "- - a\n-", "a:\n", "? a\n: b\n", "- &x a\n- *x\n", "a: |\n  b\n"}) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
      Random random(seed);
      mutated_bundle(text, kModel, 1000, random);
    }
  }
}
