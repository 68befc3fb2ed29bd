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

#include "imports/mass.hpp"
#include "imports/traced_xml.hpp"
#include "mjcf/mjcf.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/pose.hpp"
#include "smurf/xml.hpp"

namespace smurf::mjcf {

using xml::Attribute;
using xml::View;

using imports::Context;
using imports::Extent;
using imports::Imported;
using imports::kMade;
using imports::MassProperties;
using imports::Place;
using imports::Principal;
using imports::Reporter;
using imports::Tensor;
using imports::TracedXml;
using imports::words_of;

/// The numbers of an attribute; reports what MuJoCo refuses, and returns those before.
std::vector<double> numbers_of(const Attribute& attribute, std::size_t least, std::size_t most,
                               Reporter& reporter);
inline constexpr double kLargestInteger = 2147483647;
/// The same for integers: "1.0" is none.
void integers_of(const Attribute& attribute, std::size_t least, std::size_t most,
                 Reporter& reporter);
/// One of `words`; reports others.
std::optional<std::size_t> word_of(const Attribute& attribute,
                                   std::span<const std::string_view> words, Reporter& reporter);
std::optional<bool> truth_of(const Attribute& attribute, Reporter& reporter);
inline constexpr double kDegree = 3.14159265358979323846 / 180;

enum class Auto : std::uint8_t { no, yes, automatic };
Auto auto_of(const Attribute& attribute, Reporter& reporter);

}  // namespace smurf::mjcf
