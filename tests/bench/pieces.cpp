// SPDX-License-Identifier: BSD-3-Clause
// Compares the parts of a run with other programs for the same task, in one process. The folder of
// SMURF_BENCH_MODEL holds a model of generate.py; scripts/bench makes it.
#include <benchmark/benchmark.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>
#include <yaml-cpp/parser.h>

#include <cstdlib>
#include <sstream>

#include "smurf/flatten.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "support/null_events.hpp"
#include "syntax/yaml_reader.hpp"

using namespace smurf;

namespace {

std::string path_of(const std::string& file) {
  const char* folder = std::getenv("SMURF_BENCH_MODEL");
  return (folder != nullptr ? std::string(folder) : ".") + "/" + file;
}

std::string text_of(const std::string& file) {
  const FileContent content = DiskFiles().read(path_of(file), Limits{}.file_bytes);
  if (content.status != ReadStatus::ok) {
    std::fprintf(stderr, "%s: %s\n", path_of(file).c_str(), content.reason.c_str());
    std::exit(2);
  }
  return content.text;
}

LinkedModel load(const std::string& file, SourceMap& sources, DiagnosticSink& sink) {
  const DiskFiles files;
  LoadContext context{sources, files, sink, {}, {}};
  return load_model(path_of(file), context);
}

void urdf_load(benchmark::State& state) {
  for (auto step : state) {
    SourceMap sources;
    DiagnosticSink sink;
    benchmark::DoNotOptimize(load("urdf/m.urdf", sources, sink));
  }
}
BENCHMARK(urdf_load);

void urdf_urdfdom(benchmark::State& state) {
  const std::string text = text_of("urdf/m.urdf");
  for (auto step : state) benchmark::DoNotOptimize(::urdf::parseURDF(text));
}
BENCHMARK(urdf_urdfdom);

void model_load(benchmark::State& state) {
  for (auto step : state) {
    SourceMap sources;
    DiagnosticSink sink;
    benchmark::DoNotOptimize(load("smurf/m.smurf", sources, sink));
  }
}
BENCHMARK(model_load);

void model_load_and_lint(benchmark::State& state) {
  for (auto step : state) {
    SourceMap sources;
    DiagnosticSink sink;
    lint_model(load("smurf/m.smurf", sources, sink), {}, sink);
    benchmark::DoNotOptimize(sink);
  }
}
BENCHMARK(model_load_and_lint);

void yaml_yaml_cpp_events(benchmark::State& state) {
  const std::string text = text_of("smurf/m_motors.yml");
  for (auto step : state) {
    std::istringstream stream(text);
    test::NullEvents handler;
    YAML::Parser(stream).HandleNextDocument(handler);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK(yaml_yaml_cpp_events);

void yaml_tree(benchmark::State& state, YamlEngine engine) {
  SourceMap sources;
  const SourceId id = sources.add("m.yml", text_of("smurf/m_motors.yml"));
  for (auto step : state) {
    DiagnosticSink sink;
    benchmark::DoNotOptimize(parse_yaml_by(engine, sources, id, {}, sink));
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * sources.text(id).size()));
}
BENCHMARK_CAPTURE(yaml_tree, yaml_cpp, YamlEngine::yaml_cpp);
BENCHMARK_CAPTURE(yaml_tree, scanner_first, YamlEngine::scanner_first);

}  // namespace
