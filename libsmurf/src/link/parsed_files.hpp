// SPDX-License-Identifier: BSD-3-Clause
// Files of models as they were parsed, for the next check: a key stroke changes one file of many.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// Annotation files and robots that were the same in two checks. Those with findings of their own
/// are left out, as parsing reports them.
class ParsedFiles {
 public:
  struct File {
    SourceMap text;  ///< this one, under its number; what was parsed points into it
    std::optional<yaml::Document> document;
    Annotations annotations;
    std::optional<urdf::Robot> robot;
  };

  /// The file of a source with the same text, to be moved from; null when it is not kept.
  File* find(const SourceMap& sources, SourceId source);
  /// Where to parse a source from: it has the same text and number there.
  const SourceMap& home_of(const SourceMap& sources, SourceId source);

  /// Loading has ended and has reported `found`. Gives up what it has not asked for.
  void end_loading(const SourceMap& sources, const DiagnosticSink& found);
  /// Takes back the files of a loaded model.
  void keep(LinkedModel&& model);

  std::size_t bytes() const;  ///< of the texts

 private:
  std::map<SourceId, File> files_;
  std::set<SourceId> asked_for_, with_findings_;
  bool has_lost_findings_ = false;  ///< in whatever file
  SourceMap before_;                ///< of the last check
};

}  // namespace smurf
