// SPDX-License-Identifier: BSD-3-Clause
// The files that belong to the robots of a scene by evidence, for conversions, which do not report
// what is wrong in them: smurf-lint does that.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "smurf/companions.hpp"
#include "smurf/conversion.hpp"
#include "smurf/load.hpp"

namespace smurf {

class OwnCompanions {
 public:
  /// Both must outlive it.
  OwnCompanions(Session& session, LoadedScene& loaded);
  OwnCompanions(const OwnCompanions&) = delete;
  OwnCompanions& operator=(const OwnCompanions&) = delete;

  /// Those of a model of the scene, the strongest evidence first. They are loaded once.
  const Companions& of(const LinkedModel& model);
  /// A file that the user named; none if it is not of this kind.
  std::optional<Companion> named(const std::string& path, CompanionKind kind);
  const SourceMap& sources() const { return context_.sources; }

 private:
  DiagnosticSink quiet_;
  LoadContext context_;
  std::map<const LinkedModel*, Companions> known_;
};

}  // namespace smurf
