// SPDX-License-Identifier: BSD-3-Clause
// One YAML text, checked by the typed readers and, together with many others, by a JSON Schema
// validator.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schema/validator.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/source.hpp"
#include "smurf/yaml.hpp"

namespace smurf::test {

enum class FileKind { model, annotations, scene };

/// By extension; none for other files.
std::optional<FileKind> kind_of(const std::filesystem::path& path);

/// A text that was parsed and read.
struct Reading {
  SourceMap sources;
  DiagnosticSink sink;
  std::optional<yaml::Document> document;  ///< none if the text is not YAML

  Reading(FileKind kind, std::string text);
  /// Faults that readers and schemas both check: kinds of values, words, ranges and missing keys.
  std::vector<const Diagnostic*> shape_findings() const;
};

/// Cases to be passed to the validator.
class CaseFile {
 public:
  /// False if the text is not YAML; then it is not a case.
  bool add(FileKind kind, std::string text);
  std::size_t size() const { return cases_.size(); }
  std::size_t valid_count() const { return valid_count_; }

  /// Texts with different verdicts, and their verdicts; none if there is no validator.
  std::optional<std::vector<std::string>> disagreements() const;

 private:
  struct Case {
    std::string text;
    bool is_valid;
    std::string findings;
  };
  std::vector<Case> cases_;
  std::vector<Instance> instances_;
  std::size_t valid_count_ = 0;
};

}  // namespace smurf::test
