// SPDX-License-Identifier: BSD-3-Clause
// xacro: expands macros and expressions, and remembers where every byte of the result was written.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf::xacro {

enum class FrameId : std::uint32_t {};
inline constexpr FrameId kNoFrame{0xffffffffU};

/// The call of a macro or the include of a file that made a part of the result.
struct Frame {
  enum class Kind : std::uint8_t { root, macro, include };
  Kind kind = Kind::root;
  FrameId parent = kNoFrame;
  Span call;               ///< the tag of the call or the include
  Span definition;         ///< the tag of the macro
  std::string name;        ///< of the macro, or the path of the file
  std::string parameters;  ///< "radius=0.1 prefix=left_"
};

/// A value that went into a computed one.
struct Input {
  std::string_view name;  ///< as it is written
  Span place;
};

/// A part of the result that was written in one place.
struct Leaf {
  enum class Kind : std::uint8_t { tag, attribute, value, text, end_tag };
  std::uint32_t begin = 0, end = 0;  ///< in the result
  Kind kind = Kind::tag;
  bool is_exact = false;  ///< the bytes are those of `origin`
  FrameId frame = kNoFrame;
  Span origin;  ///< the bytes to blame
  Span use;     ///< the place where the value is used; the tag for a name
  Span whole;   ///< the element or the attribute
  std::uint32_t first_input = 0, inputs = 0;
};

/// The place of a part of the result.
struct Origin {
  Span span;
  bool is_exact = false;  ///< byte by byte
  FrameId frame = kNoFrame;
  std::vector<Input> inputs;
};

/// Bytes of the result that stand in a file as they are.
struct Copied {
  std::uint32_t begin = 0, end = 0;  ///< in the result
  Span span;                         ///< in the file
};

/// An expanded file.
struct Expansion {
  SourceId root{};                      ///< the file that was expanded
  Language language = Language::xacro;  ///< of that file
  SourceId source{};                    ///< the result, a source of its own
  std::vector<Frame> frames;
  std::vector<Leaf> leaves;  ///< in the order of the result
  std::vector<Input> inputs;
  std::vector<xml::Document> documents;  ///< of all files
  std::set<std::string> included;        ///< paths of all files that were read
  bool is_complete = false;              ///< false after a failure, which has been reported
  std::string missing_argument;          ///< it failed because this one has no value

  const Frame& frame(FrameId id) const { return frames[static_cast<std::size_t>(id)]; }
  /// The place where a part of the result was written.
  Origin origin_of(Span part) const;
  /// The pieces of a part of the result that were not computed, such as `_wheel` in
  /// `${prefix}_wheel`.
  std::vector<Copied> copied_in(Span part) const;
};

/// By the source of the result.
using Expansions = std::map<SourceId, Expansion>;

/// What the caller decides about an expansion.
struct Settings {
  std::map<std::string, std::string> arguments;
  std::set<std::string> environment;  ///< the variables that may be read
  bool needs_origins = true;          ///< false: the result has no leaves
  /// The folder of a package that a file at `near` names; none if it is unknown.
  std::function<std::optional<std::string>(const std::string& name, const std::string& near)>
      find_package;
  /// The absolute form of a path, as texts show it.
  std::function<std::string(const std::string& path)> absolute;
};

/// What an expansion reads from and reports to.
struct Context {
  SourceMap& sources;
  const FileReader& files;
  DiagnosticSink& sink;
  const Limits& limits;
};

/// Expands a file that has been read, and adds the result to the sources.
Expansion expand(SourceId root, const Settings& settings, Context& context);

/// "in `wheel`, called here with radius=0.1".
std::string label_of(const Frame& frame);

/// Whether a file is a xacro, by its name. Of a loaded model, ask LinkedModel::language.
bool is_xacro_file(std::string_view path);

}  // namespace smurf::xacro
