// SPDX-License-Identifier: BSD-3-Clause
// Converts between bytes of a text and positions of the protocol, in the negotiated units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "smurf-lsp/json.hpp"
#include "smurf/source.hpp"

namespace smurf::lsp {

enum class Encoding : std::uint8_t { utf8, utf16, utf32 };
std::string_view to_string(Encoding encoding);

/// Units in a text of one line.
std::uint32_t units_in(std::string_view text, Encoding encoding);
/// The bytes of the first `units`; all bytes when there are fewer.
std::size_t bytes_of(std::string_view line, std::uint32_t units, Encoding encoding);

/// The byte of a position. As the protocol demands, a position behind the end of a line is its end.
std::size_t offset_in(std::string_view text, const Json& position, Encoding encoding);

/// Converts places of a source map to those of the protocol.
class Positions {
 public:
  Positions(const SourceMap& sources, Encoding encoding) : sources_(sources), encoding_(encoding) {}

  Json position(SourceId source, std::uint32_t offset) const;
  Json range(Span span) const;
  std::uint32_t offset(SourceId source, const Json& position) const;

 private:
  const SourceMap& sources_;
  Encoding encoding_;
};

}  // namespace smurf::lsp
