// SPDX-License-Identifier: BSD-3-Clause
// Prefixes of XML names and where they are declared.
#pragma once

#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

/// The prefixes that the open elements declare. A prefix without `xmlns:` makes expat, lxml and
/// browsers refuse the file, tinyxml2 does not look (SML1002).
class XmlPrefixes {
 public:
  XmlPrefixes(std::string_view text, DiagnosticSink& sink) : text_(text), sink_(sink) {}

  std::size_t count() const { return open_.size(); }
  void declare(std::string_view prefix);
  /// Forgets what was declared since there were `count` of them.
  void close(std::size_t count);
  /// Reports the prefix of a name, once a file.
  void check(Span name);

 private:
  std::string_view text_;
  DiagnosticSink& sink_;
  std::vector<std::string_view> open_;
  std::unordered_map<std::string_view, std::uint32_t> declared_;  ///< how often in open_
  std::unordered_set<std::string_view> reported_;
};

}  // namespace smurf
