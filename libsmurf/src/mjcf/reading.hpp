// SPDX-License-Identifier: BSD-3-Clause
// What all parts of the reader have in common: what it reads from and reports to, and how MuJoCo
// reads numbers and words.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "mjcf/mjcf.hpp"
#include "mjcf/traced_xml.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/pose.hpp"
#include "smurf/xml.hpp"

namespace smurf::mjcf {

using xml::Attribute;
using xml::View;

/// Reports. Findings of one rule at one place are one finding: a class acts on many elements.
class Reporter {
 public:
  explicit Reporter(Context& context) : context_(context) {}

  /// MuJoCo refuses the model for this.
  Diagnostic& refuse(Span place, std::string message, std::string help);
  /// The model is larger than a limit; `name` is that of the limit.
  Diagnostic& exceed(Span place, std::string message, std::string_view name);
  /// A file is not there.
  Diagnostic& miss(Span place, std::string message, std::string help);
  Diagnostic& report(const Rule& rule, Span place, std::string message);
  bool has_refused() const { return has_refused_; }
  Context& context() { return context_; }

 private:
  Context& context_;
  bool has_refused_ = false;
  Diagnostic ignored_;
  std::set<std::tuple<const Rule*, SourceId, std::uint32_t>> known_;
};

/// The numbers of an attribute; reports what MuJoCo refuses, and returns those before.
std::vector<double> numbers_of(const Attribute& attribute, std::size_t least, std::size_t most,
                               Reporter& reporter);
/// One of `words`; reports others.
std::optional<std::size_t> word_of(const Attribute& attribute,
                                   std::span<const std::string_view> words, Reporter& reporter);
std::optional<bool> truth_of(const Attribute& attribute, Reporter& reporter);
inline constexpr double kDegree = 3.14159265358979323846 / 180;
/// With blanks between them.
std::string words_of(const Vector3& numbers);

enum class Auto : std::uint8_t { no, yes, automatic };
Auto auto_of(const Attribute& attribute, Reporter& reporter);

}  // namespace smurf::mjcf
