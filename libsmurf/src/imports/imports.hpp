// SPDX-License-Identifier: BSD-3-Clause
// What the readers of other languages than URDF have in common: what they read from, what they
// return, and how they report.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/pose.hpp"
#include "smurf/source.hpp"
#include "smurf/xacro.hpp"
#include "smurf/xml.hpp"

namespace smurf::imports {

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
  /// Names of links that must not touch each other, which an SRDF says.
  std::vector<std::pair<std::string, std::string>> excluded;
};

/// The mark of a leaf that nobody wrote, as its `first_input`: it belongs to an element that is
/// needed to say in a URDF what the file says otherwise, such as the link between two joints of a
/// body; or it is a value that a URDF must have, such as the velocity of a joint without a limit.
inline constexpr std::uint32_t kMade = 0xffffffffU;
/// Whether a part of a result is such a leaf.
bool is_made(const xacro::Expansion& result, Span part);

/// Parses as TinyXML-2 does, which MuJoCo and libsdformat have: what only other readers of XML
/// refuse, such as `--` in a comment, is a warning, and a prefix that nothing declares is no
/// mistake. None, with an error, where TinyXML-2 refuses the text, too.
std::optional<xml::Document> parse_lenient_xml(SourceId source, Context& context);

/// The name of the root element of a text; "" if there is none. Reads the beginning only.
std::string_view root_name(std::string_view text);
/// The start tag of the root element, from its name to before its ">"; "" if there is none.
std::string_view root_tag(std::string_view text);
/// The name of the first element in the root element.
std::string_view first_name(std::string_view text);

/// The rules of one language, and what its findings begin with: "MuJoCo refuses this: ".
struct Family {
  const Rule& refused;
  const Rule& missing;  ///< a file is not there
  const Rule& limit;    ///< the model is larger than a limit
  std::string_view refusal;
};

/// Reports. Findings of one rule at one place are one finding: a class acts on many elements.
class Reporter {
 public:
  Reporter(Context& context, const Family& family) : context_(context), family_(family) {}

  /// The reader of the language refuses the model for this.
  Diagnostic& refuse(Span place, std::string message, std::string help);
  /// The same for a name that nothing has. If an included file is missing, the name may be defined
  /// in it; then only the missing file is reported.
  Diagnostic& refuse_name(Span place, std::string message, std::string help);
  /// From now on, an included file is known to be missing.
  void lack_file() { lacks_file_ = true; }
  bool lacks_file() const { return lacks_file_; }
  /// The model is larger than a limit; `name` is that of the limit.
  Diagnostic& exceed(Span place, std::string message, std::string_view name);
  /// A file is not there.
  Diagnostic& miss(Span place, std::string message, std::string help);
  Diagnostic& report(const Rule& rule, Span place, std::string message);
  /// The result lacks something. `others`, such as "lost tendons": all of a file are one finding.
  Diagnostic& lose(Span place, std::string message, std::string_view others);
  bool has_refused() const { return has_refused_; }
  Context& context() { return context_; }

 private:
  Context& context_;
  const Family& family_;
  bool has_refused_ = false;
  bool lacks_file_ = false;
  Diagnostic ignored_;
  std::set<std::tuple<const Rule*, SourceId, std::uint32_t>> known_;
};

/// Three numbers with blanks between them.
std::string words_of(const Vector3& numbers);

}  // namespace smurf::imports
