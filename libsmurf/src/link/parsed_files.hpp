// SPDX-License-Identifier: BSD-3-Clause
// Keeps parsed files of models for the next check: a keystroke changes one file of many.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Annotation files and robots that were the same in two checks. Excludes files with findings,
/// because parsing reports the findings.
class ParsedFiles {
 public:
  struct File {
    SourceMap text;  ///< the source with its number; the parsed objects point into it
    std::optional<yaml::Document> document;
    Annotations annotations;
    std::optional<urdf::Robot> robot;
  };

  /// The file of a source with the same text, to be moved from; null if it is not kept.
  File* find(const SourceMap& sources, SourceId source);
  /// The source map for parsing a source: it contains the same text under the same number.
  const SourceMap& home_of(const SourceMap& sources, SourceId source);

  /// Loading has ended and has reported `found`. Releases files that were not requested.
  void end_loading(const SourceMap& sources, const DiagnosticSink& found);
  /// Takes back the files of a loaded model.
  void keep(LinkedModel&& model);

  std::size_t bytes() const;  ///< of the texts

 private:
  std::map<SourceId, File> files_;
  std::set<SourceId> asked_for_, with_findings_;
  bool has_lost_findings_ = false;  ///< in any file
  SourceMap before_;                ///< of the last check
};

}  // namespace smurf
