// SPDX-License-Identifier: BSD-3-Clause
#include "xacro/python_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "base/files/path.hpp"
#include "base/numbers/floating.hpp"
#include "base/text/utf8.hpp"
#include "xacro/value.hpp"

namespace smurf::xacro {
namespace {

/// The zeros of all scripts; nine digits follow each.
constexpr std::array<char32_t, 66> kZeros = {
    0x30,    0x660,   0x6f0,   0x7c0,   0x966,   0x9e6,   0xa66,   0xae6,   0xb66,   0xbe6,
    0xc66,   0xce6,   0xd66,   0xde6,   0xe50,   0xed0,   0xf20,   0x1040,  0x1090,  0x17e0,
    0x1810,  0x1946,  0x19d0,  0x1a80,  0x1a90,  0x1b50,  0x1bb0,  0x1c40,  0x1c50,  0xa620,
    0xa8d0,  0xa900,  0xa9d0,  0xa9f0,  0xaa50,  0xabf0,  0xff10,  0x104a0, 0x10d30, 0x11066,
    0x110f0, 0x11136, 0x111d0, 0x112f0, 0x11450, 0x114d0, 0x11650, 0x116c0, 0x11730, 0x118e0,
    0x11950, 0x11c50, 0x11d50, 0x11da0, 0x16a60, 0x16ac0, 0x16b50, 0x1d7ce, 0x1d7d8, 0x1d7e2,
    0x1d7ec, 0x1d7f6, 0x1e140, 0x1e2f0, 0x1e950, 0x1fbf0};

/// Splits "-1.25e-05" into its digits and its exponent.
Decimal split(std::string_view text) {
  Decimal decimal;
  if (text.starts_with('-')) {
    decimal.is_negative = true;
    text.remove_prefix(1);
  }
  const std::size_t e = text.find('e');
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view written = text.substr(e + 1);
    if (written.starts_with('+')) written.remove_prefix(1);
    std::from_chars(written.data(), written.data() + written.size(), exponent);
    text = text.substr(0, e);
  }
  const std::size_t point = std::min(text.find('.'), text.size());
  for (const char c : text) {
    if (c != '.') decimal.digits.push_back(c);
  }
  const std::size_t zeros = std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size());
  decimal.exponent = exponent + static_cast<int>(point) - 1 - static_cast<int>(zeros);
  decimal.digits.erase(0, zeros);
  while (!decimal.digits.empty() && decimal.digits.back() == '0') decimal.digits.pop_back();
  if (decimal.digits.empty()) {
    decimal.digits = "0";
    decimal.exponent = 0;
  }
  return decimal;
}

/// In ASCII, with the digits of other scripts replaced; none if there are other characters.
std::optional<std::string> in_ascii(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    const int digit = decimal_digit(point.value);
    if (digit >= 0) {
      ascii.push_back(static_cast<char>('0' + digit));
    } else if (point.value < 0x80) {
      ascii.push_back(static_cast<char>(point.value));
    } else {
      return std::nullopt;
    }
    text.remove_prefix(point.size);
  }
  return ascii;
}

/// Removes underscores, which must be between digits.
bool remove_underscores(std::string& text) {
  if (text.find('_') == std::string::npos) return true;
  const auto is_digit = [&](std::size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '_' && (i == 0 || !is_digit(i - 1) || !is_digit(i + 1))) return false;
  }
  std::erase(text, '_');
  return true;
}

}  // namespace

int decimal_digit(char32_t code_point) {
  if (code_point < 0x80) {
    return code_point >= '0' && code_point <= '9' ? static_cast<int>(code_point - '0') : -1;
  }
  const auto above = std::upper_bound(kZeros.begin(), kZeros.end(), code_point);
  const char32_t distance = code_point - *std::prev(above);
  return distance < 10 ? static_cast<int>(distance) : -1;
}

bool is_python_blank(char32_t c) {
  return (c >= 0x09 && c <= 0x0d) || (c >= 0x1c && c <= 0x20) || c == 0x85 || c == 0xa0 ||
         c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x2028 || c == 0x2029 || c == 0x202f ||
         c == 0x205f || c == 0x3000;
}

std::string_view without_blanks(std::string_view text) {
  const auto is_plain = [](char c) { return c > ' ' && c <= '~'; };
  if (!text.empty() && is_plain(text.front()) && is_plain(text.back())) return text;
  std::size_t begin = 0;
  while (begin < text.size() && (text[begin] == ' ' || text[begin] == '\n')) ++begin;
  text.remove_prefix(begin);
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    if (!is_python_blank(point.value)) break;
    text.remove_prefix(point.size);
  }
  while (!text.empty()) {
    std::size_t last = text.size() - 1;
    while (last > 0 && utf8::is_continuation(text[last])) --last;
    if (!is_python_blank(utf8::decode(text.substr(last)).value)) break;
    text = text.substr(0, last);
  }
  return text;
}

Decimal shortest_decimal(double value) { return split(shortest(value, Notation::scientific)); }

Decimal rounded_decimal(double value, int digits) { return split(general(value, digits)); }

namespace {

/// The digits of a number with `decimals` digits behind the point.
Decimal decimal_with(double value, int decimals) {
  // general() cannot print less than one digit, and rounding may make one more.
  const Decimal first = split(general(value, 17));
  const int wanted = first.exponent + 1 + decimals;
  constexpr int kMost = 400;  // no double has more digits that matter
  if (wanted > 0) return split(general(value, std::min(wanted, kMost)));
  Decimal none{std::signbit(value), "0", 0};
  if (wanted < 0) return none;
  // Exactly half of the last place goes to the even digit, which is 0.
  const Decimal all = split(general(value, 60));
  const bool is_more = all.digits[0] > '5' || (all.digits[0] == '5' && all.digits.size() > 1);
  if (is_more) return {none.is_negative, "1", -decimals};
  return none;
}

}  // namespace

std::string fixed_text(double value, int decimals) {
  const Decimal decimal = decimal_with(value, decimals);
  std::string text = std::signbit(value) ? "-" : "";
  if (decimal.exponent < 0 || decimal.digits == "0") {
    text += "0";
  } else {
    for (int i = 0; i <= decimal.exponent; ++i) {
      const auto at = static_cast<std::size_t>(i);
      text.push_back(at < decimal.digits.size() ? decimal.digits[at] : '0');
    }
  }
  if (decimals > 0) text.push_back('.');
  for (int i = 1; i <= decimals; ++i) {
    const int at = decimal.exponent + i;
    const bool is_digit = at >= 0 && static_cast<std::size_t>(at) < decimal.digits.size();
    text.push_back(is_digit ? decimal.digits[static_cast<std::size_t>(at)] : '0');
  }
  return text;
}

double rounded(double value, int decimals) {
  if (!std::isfinite(value) || value == 0) return value;
  const Decimal decimal = decimal_with(value, decimals);
  const std::string text = (decimal.is_negative ? "-0." : "0.") + decimal.digits + "e" +
                           std::to_string(decimal.exponent + 1);
  return read_float(text).value_or(value);
}

std::string float_text(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  const Decimal decimal = shortest_decimal(value);
  std::string text = std::signbit(value) ? "-" : "";
  const std::string& digits = decimal.digits;
  const int exponent = decimal.exponent;
  const auto count = static_cast<int>(digits.size());
  if (exponent < -4 || exponent >= 16) {
    text += digits[0];
    if (count > 1) text += "." + digits.substr(1);
    const std::string power = std::to_string(std::abs(exponent));
    return text + "e" + (exponent < 0 ? "-" : "+") + (power.size() < 2 ? "0" : "") + power;
  }
  if (exponent < 0) {
    return text + "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
  }
  if (count <= exponent + 1) {
    return text + digits + std::string(static_cast<std::size_t>(exponent + 1 - count), '0') + ".0";
  }
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  return text + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string quoted_text(std::string_view text) {
  const bool has_single = text.find('\'') != std::string_view::npos;
  const char quote = has_single && text.find('"') == std::string_view::npos ? '"' : '\'';
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string quoted(1, quote);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == quote || c == '\\') {
      quoted += {'\\', c};
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (c == '\t') {
      quoted += "\\t";
    } else if (c == '\r') {
      quoted += "\\r";
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += {'\\', 'x', kHex[byte >> 4U], kHex[byte & 15U]};
    } else {
      quoted.push_back(c);
    }
  }
  quoted.push_back(quote);
  return quoted;
}

namespace {

/// Whether a text may be a number, by its first character: most texts of robots are names.
bool may_be_number(std::string_view text) {
  const char c = text.empty() ? 'a' : text.front();
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return !is_letter && c != '/' && c != '$' && c != '(';
}

/// An integer in ASCII of so few digits that it cannot overflow; none for all others.
std::optional<std::int64_t> short_integer(std::string_view text) {
  constexpr std::size_t kMostDigits = 18;
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  const std::string_view digits = text.substr(has_sign ? 1 : 0);
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return text.front() == '-' ? -value : value;
}

/// Whether a text consists of digits and a point, with a sign.
bool is_plain_decimal(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && text.size() < 16 && text != "." &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

}  // namespace

std::optional<Value> read_integer(std::string_view written, Heap& heap, unsigned base) {
  if (base == 10) {
    if (!may_be_number(written)) return std::nullopt;
    if (const auto value = short_integer(written)) return Value::of(*value);
    if (is_plain_decimal(written)) return std::nullopt;
  }
  auto text = in_ascii(without_blanks(written));
  if (!text) return std::nullopt;
  const bool is_negative = text->starts_with('-');
  if (is_negative || text->starts_with('+')) text->erase(0, 1);
  if (base != 10 && text->size() > 2 && (*text)[0] == '0') {
    const char letter = base == 16 ? 'x' : base == 8 ? 'o' : 'b';
    if (((*text)[1] | 0x20) == letter) text->erase(0, 2);
  }
  if (text->empty() || !remove_underscores(*text)) return std::nullopt;
  for (const char c : *text) {
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!is_digit && !is_letter) return std::nullopt;
    const unsigned digit =
        is_digit ? static_cast<unsigned>(c - '0') : static_cast<unsigned>((c | 0x20) - 'a') + 10;
    if (digit >= base) return std::nullopt;
  }
  if (text->size() > kMostIntegerDigits) return std::nullopt;
  const BigInt magnitude = BigInt::from_digits(*text, base, heap.meter());
  return heap.integer(is_negative ? magnitude.negated() : magnitude);
}

std::optional<double> read_float(std::string_view written) {
  if (is_plain_decimal(written)) {
    const bool has_sign = written[0] == '-' || written[0] == '+';
    const std::string_view digits = written.substr(has_sign ? 1 : 0);
    double value = 0;
    const auto [end, error] = read_floating(digits, value);
    if (end != digits.data() + digits.size()) return std::nullopt;
    if (error == std::errc{}) return written[0] == '-' ? -value : value;
  } else if (!may_be_number(written)) {
    // "inf" and "nan" in any case
    if (written.empty() || std::string_view("iInN").find(written[0]) == std::string_view::npos) {
      return std::nullopt;
    }
  }
  auto text = in_ascii(without_blanks(written));
  if (!text) return std::nullopt;
  const bool is_negative = text->starts_with('-');
  if (is_negative || text->starts_with('+')) text->erase(0, 1);
  const std::string lower = path::to_lower(*text);
  const double sign = is_negative ? -1.0 : 1.0;
  if (lower == "inf" || lower == "infinity") return sign * std::numeric_limits<double>::infinity();
  if (lower == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text->empty() || !remove_underscores(*text)) return std::nullopt;
  const char first = (*text)[0];
  if (first != '.' && (first < '0' || first > '9')) return std::nullopt;
  double value = 0;
  const auto [end, error] = read_floating(*text, value);
  if (end != text->data() + text->size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too large, or too small: the exponent decides.
    const Decimal decimal = split(lower);
    value = decimal.exponent > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  } else if (error != std::errc{}) {
    return std::nullopt;
  }
  return sign * value;
}

}  // namespace smurf::xacro
