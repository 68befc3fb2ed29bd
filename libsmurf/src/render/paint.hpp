// SPDX-License-Identifier: BSD-3-Clause
// Terminal colours, if enabled.
#pragma once

#include <string>
#include <string_view>

#include "smurf/diagnostic.hpp"

namespace smurf::render {

enum class Ink { none, error, warning, info, frame, strong };

inline Ink ink_of(Severity severity) {
  switch (severity) {
  case Severity::info: return Ink::info;
  case Severity::warning: return Ink::warning;
  case Severity::error: return Ink::error;
  }
  return Ink::none;
}

class Painter {
 public:
  explicit Painter(bool color) : color_(color) {}

  std::string operator()(Ink ink, std::string_view text) const {
    if (!color_ || ink == Ink::none || text.empty()) return std::string(text);
    return std::string(code(ink)).append(text).append("\x1b[0m");
  }

 private:
  static std::string_view code(Ink ink) {
    switch (ink) {
    case Ink::error: return "\x1b[1;31m";
    case Ink::warning: return "\x1b[1;33m";
    case Ink::info: return "\x1b[1;34m";
    case Ink::frame: return "\x1b[34m";
    case Ink::strong: return "\x1b[1m";
    case Ink::none: break;
    }
    return "";
  }

  bool color_;
};

}  // namespace smurf::render
