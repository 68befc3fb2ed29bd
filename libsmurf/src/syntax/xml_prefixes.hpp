// SPDX-License-Identifier: BSD-3-Clause
// Prefixes of XML names and where they are declared.
#pragma once

#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// The prefixes that the open elements declare. At a prefix without `xmlns:`, expat, lxml and
/// browsers refuse the file; tinyxml2 ignores it (SML1002).
class XmlPrefixes {
 public:
  XmlPrefixes(std::string_view text, DiagnosticSink& sink) : text_(text), sink_(sink) {}

  /// Begins an element: prefixes declared from here on are valid until leave().
  void enter() { elements_.push_back(open_.size()); }
  void leave();
  void declare(std::string_view prefix);
  /// Reports the prefix of a name, once per file.
  void check(Span name);

 private:
  std::string_view text_;
  DiagnosticSink& sink_;
  std::vector<std::size_t> elements_;  ///< prefixes declared before each open element
  std::vector<std::string_view> open_;
  std::map<std::string_view, std::uint32_t> declared_;  ///< number of declarations in open_
  std::set<std::string_view> reported_;
};

}  // namespace smurf
