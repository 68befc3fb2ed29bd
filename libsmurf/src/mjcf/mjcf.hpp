// SPDX-License-Identifier: BSD-3-Clause
// MJCF, the language of MuJoCo: makes a URDF and SMURF annotations of a model, and remembers where
// every byte of them was written.
#pragma once

#include <string_view>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/source.hpp"
#include "smurf/xacro.hpp"

namespace smurf::mjcf {

/// What a model is read from and reported to.
struct Context {
  SourceMap& sources;
  const FileReader& files;
  DiagnosticSink& sink;
  const Limits& limits;
};

/// The results of one model. Both are sources of their own, which are in no file.
struct Imported {
  xacro::Expansion robot;        ///< a URDF
  xacro::Expansion annotations;  ///< a YAML file of SMURF
};

/// Reads a file that has been read, with all that it includes, and adds the results to the sources.
Imported expand(SourceId root, Context& context);

/// The mark of a leaf that nobody wrote, as its `first_input`: it belongs to an element that is
/// needed to say in a URDF what the file says otherwise, such as the link between two joints of a
/// body; or it is a value that a URDF must have, such as the velocity of a joint without a limit.
inline constexpr std::uint32_t kMade = 0xffffffffU;
/// Whether a part of a result is such a leaf.
bool is_made(const xacro::Expansion& result, Span part);

/// Whether the root element of a text is one of MJCF. Reads the beginning only.
bool is_mjcf(std::string_view text);

}  // namespace smurf::mjcf
