// SPDX-License-Identifier: BSD-3-Clause
// '%.3f' % x and '{:.3f}'.format(x).
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

constexpr int kMostWidth = 1000;  // characters

struct Spec {
  char fill = ' ';
  char align = '\0';  ///< '<', '>', '^' or '='
  char sign = '-';    ///< '+', '-' or ' '
  bool is_alternate = false;
  bool groups = false;  ///< thousands by ','
  int width = 0;
  int precision = -1;
  char type = '\0';
};

/// "1.500000e+00" or as %g.
std::string scientific(double value, int precision, bool keeps_zeros) {
  const Decimal decimal = rounded_decimal(value, precision + 1);
  std::string digits = decimal.digits;
  if (keeps_zeros) digits.resize(static_cast<std::size_t>(precision) + 1, '0');
  std::string text = digits.substr(0, 1);
  if (digits.size() > 1) text += "." + digits.substr(1);
  const std::string power = std::to_string(std::abs(decimal.exponent));
  return text + "e" + (decimal.exponent < 0 ? "-" : "+") + (power.size() < 2 ? "0" : "") + power;
}

std::string general_text(double value, int precision) {
  const int digits = precision == 0 ? 1 : precision;
  const Decimal decimal = rounded_decimal(value, digits);
  if (value != 0 && (decimal.exponent < -4 || decimal.exponent >= digits)) {
    return scientific(value, digits - 1, false);
  }
  std::string text = fixed_text(value, std::max(0, digits - 1 - decimal.exponent));
  if (text.find('.') == std::string::npos) return text;
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::string upper_text(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  return text;
}

/// The magnitude of a float.
std::string real_digits(double value, const Spec& spec) {
  value = std::fabs(value);
  const bool is_upper = spec.type >= 'A' && spec.type <= 'Z';
  std::string text;
  const int precision = spec.precision < 0 ? 6 : spec.precision;
  if (!std::isfinite(value)) {
    text = std::isnan(value) ? "nan" : "inf";
  } else if (spec.type == 'e' || spec.type == 'E') {
    text = scientific(value, precision, true);
  } else if (spec.type == 'g' || spec.type == 'G') {
    text = general_text(value, precision);
  } else if (spec.type == '%') {
    text = fixed_text(value * 100, precision) + "%";
  } else {
    text = fixed_text(value, precision);
  }
  return is_upper ? upper_text(text) : text;
}

std::string integer_digits(const BigInt& value, const Spec& spec, Meter& meter) {
  const BigInt magnitude = value.is_negative() ? value.negated() : value;
  switch (spec.type) {
  case 'x': return (spec.is_alternate ? "0x" : "") + magnitude.to_text(meter, 16);
  case 'X': return (spec.is_alternate ? "0X" : "") + upper_text(magnitude.to_text(meter, 16));
  case 'o': return (spec.is_alternate ? "0o" : "") + magnitude.to_text(meter, 8);
  case 'b': return (spec.is_alternate ? "0b" : "") + magnitude.to_text(meter, 2);
  default: return magnitude.to_text(meter);
  }
}

std::string grouped(const std::string& digits) {
  const std::size_t whole = std::min(digits.find_first_not_of("0123456789"), digits.size());
  std::string text;
  for (std::size_t i = 0; i < whole; ++i) {
    if (i > 0 && (whole - i) % 3 == 0) text.push_back(',');
    text.push_back(digits[i]);
  }
  return text + digits.substr(whole);
}

std::string padded(const std::string& sign, const std::string& text, const Spec& spec,
                   char default_align) {
  const auto size = static_cast<int>(utf8::count_code_points(text) + sign.size());
  const int room = std::max(0, spec.width - size);
  const char align = spec.align != '\0' ? spec.align : default_align;
  const auto fill = [&](int count) {
    return std::string(static_cast<std::size_t>(count), spec.fill);
  };
  if (align == '<') return sign + text + fill(room);
  if (align == '=') return sign + fill(room) + text;
  if (align == '^') return fill(room / 2) + sign + text + fill(room - room / 2);
  return fill(room) + sign + text;
}

std::string number_text(const std::string& digits, bool is_negative, const Spec& spec) {
  const std::string sign = is_negative ? "-" : spec.sign == '-' ? "" : std::string(1, spec.sign);
  return padded(sign, spec.groups ? grouped(digits) : digits, spec, '>');
}

bool is_real_type(char type) {
  return std::string_view("eEfFgG%").find(type) != std::string_view::npos;
}

/// A value in the form of a spec of format(); `problem` says why there is none.
std::string formatted(Evaluator& evaluator, const Value& value, const Spec& spec) {
  constexpr std::uint64_t kStepsOfNumber = 50;  // hundreds of digits
  evaluator.step(value.is_number() ? kStepsOfNumber : 2);
  if (value.is_number() && value.kind != Kind::boolean) {
    if (value.is_integral() && !is_real_type(spec.type)) {
      return number_text(integer_digits(to_big(value), spec, evaluator.meter()),
                         to_big(value).is_negative(), spec);
    }
    const auto real = to_real(value);
    if (!real) {
      evaluator.fail("the integer is too large for a number");
      return {};
    }
    if (spec.type != '\0' && !is_real_type(spec.type)) {
      evaluator.fail(std::string("the format `") + spec.type + "` needs an integer");
      return {};
    }
    std::string digits;
    if (spec.type == '\0') {
      digits = spec.precision < 0 ? float_text(std::fabs(*real)) : "";
      if (spec.precision >= 0) {
        evaluator.fail_unsupported("a format with digits and without `f`, `e` or `g`");
        return {};
      }
    } else {
      digits = real_digits(*real, spec);
    }
    return number_text(digits, std::signbit(*real), spec);
  }
  const bool has_spec = spec.width != 0 || spec.precision >= 0 || spec.type != '\0';
  if (!value.is_text() && has_spec) {
    evaluator.fail(std::string(kind_name(value)) + " has no such format");
    return {};
  }
  if (spec.type != '\0' && spec.type != 's') {
    evaluator.fail(std::string("the format `") + spec.type + "` needs a number");
    return {};
  }
  std::string text = evaluator.string_of(value);
  if (spec.precision >= 0) {
    std::size_t end = 0;
    for (int i = 0; i < spec.precision && end < text.size(); ++i) {
      end += utf8::decode(std::string_view(text).substr(end)).size;
    }
    text.resize(end);
  }
  return padded("", text, spec, '<');
}

/// Reads digits; -1 if there are none.
int read_count(std::string_view text, std::size_t& at) {
  int count = -1;
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
    count = std::min(kMostWidth, std::max(count, 0) * 10 + (text[at] - '0'));
  }
  return count;
}

bool is_too_wide(Evaluator& evaluator, const Spec& spec) {
  if (spec.width < kMostWidth && spec.precision < kMostWidth) return false;
  evaluator.fail(rules::sml3312_xacro_limit,
                 "the format is wider than " + std::to_string(kMostWidth - 1) + " characters");
  return true;
}

class PercentFormatter {
 public:
  PercentFormatter(Evaluator& evaluator, const std::string& format, const Value& values)
      : evaluator_(evaluator), format_(format), mapping_(values) {
    if (values.kind == Kind::tuple) {
      evaluator.step(values.list->items.size());
      values_ = values.list->items;
    } else {
      values_ = {values};
      may_stay_ = values.kind == Kind::dict || values.is_sequence();
    }
  }

  Value run() {
    evaluator_.step(format_.size() / 8);
    const std::uint64_t most = evaluator_.limits().xacro_text_bytes;
    for (std::size_t at = 0; at < format_.size() && !evaluator_.has_failed();) {
      if (result_.size() > most) break;  // reported below
      if (format_[at] != '%') {
        result_.push_back(format_[at++]);
      } else {
        ++at;
        item(at);
      }
    }
    if (!evaluator_.has_failed() && result_.size() <= most && next_ < values_.size() &&
        !may_stay_) {
      evaluator_.fail("the format does not use all values");
    }
    return evaluator_.has_failed() ? Value::failure() : evaluator_.text(std::move(result_));
  }

 private:
  void item(std::size_t& at) {
    std::optional<Value> member;
    if (at < format_.size() && format_[at] == '(') {
      const std::size_t end = std::min(format_.find(')', at), format_.size());
      member = member_of(format_.substr(at + 1, end - at - 1));
      at = std::min(end + 1, format_.size());
    }
    Spec spec;
    bool is_left = false;
    bool has_zeros = false;
    for (; at < format_.size(); ++at) {
      const char c = format_[at];
      if (c == '-') {
        is_left = true;
      } else if (c == '+' || c == ' ') {
        if (spec.sign != '+') spec.sign = c;
      } else if (c == '0') {
        has_zeros = true;
      } else if (c == '#') {
        spec.is_alternate = true;
      } else {
        break;
      }
    }
    spec.width = std::max(0, read_count(format_, at));
    if (at < format_.size() && format_[at] == '.') {
      ++at;
      spec.precision = std::max(0, read_count(format_, at));
    }
    if (is_too_wide(evaluator_, spec)) return;
    if (at >= format_.size()) {
      evaluator_.fail("the format ends after `%`");
      return;
    }
    spec.type = format_[at++];
    spec.align = is_left ? '<' : '>';
    if (spec.type == '%') {
      result_.push_back('%');
      return;
    }
    const Value value = member ? *member : next();
    if (evaluator_.has_failed()) return;
    if (has_zeros && !is_left && value.is_number()) {
      spec.fill = '0';
      spec.align = '=';
    }
    add(value, spec);
  }

  void add(const Value& value, Spec spec) {
    switch (spec.type) {
    case 's':
    case 'r':
    case 'a': {
      const std::string text =
          spec.type == 's' ? evaluator_.string_of(value) : evaluator_.repr(value);
      spec.type = 's';
      if (!evaluator_.has_failed()) result_ += formatted(evaluator_, evaluator_.text(text), spec);
      return;
    }
    case 'd':
    case 'i':
    case 'u': {
      if (!value.is_number()) break;
      const double real = to_real(value).value_or(0);
      if (!std::isfinite(real)) break;
      spec.type = 'd';
      const BigInt whole = value.kind == Kind::real ? BigInt::from_double(real) : to_big(value);
      result_ += formatted(evaluator_, evaluator_.integer(whole), spec);
      return;
    }
    case 'x':
    case 'X':
    case 'o':
      if (!value.is_integral()) break;
      result_ += formatted(evaluator_, evaluator_.integer(to_big(value)), spec);
      return;
    case 'e':
    case 'E':
    case 'f':
    case 'F':
    case 'g':
    case 'G': {
      const auto real = to_real(value);
      if (!real) break;
      result_ += formatted(evaluator_, Value::of(*real), spec);
      return;
    }
    default: evaluator_.fail_unsupported(std::string("the format `%") + spec.type + "`"); return;
    }
    evaluator_.fail(std::string("the format `%") + spec.type + "` needs a number, not " +
                    std::string(kind_name(value)));
  }

  Value next() {
    if (next_ >= values_.size()) return evaluator_.fail("there are too few values for the format");
    return values_[next_++];
  }

  Value member_of(const std::string& key) {
    if (mapping_.kind != Kind::dict) return evaluator_.fail("the format needs a dictionary");
    evaluator_.step(1 + key.size() / 8);
    const Value* value = mapping_.dict->find("t" + key);
    return value != nullptr ? *value : evaluator_.fail("the dictionary has no key " + quoted(key));
  }

  Evaluator& evaluator_;
  const std::string& format_;
  Value mapping_;
  std::vector<Value> values_;
  std::size_t next_ = 0;
  bool may_stay_ = false;
  std::string result_;
};

/// "[[fill]align][sign][#][0][width][,][.precision][type]"; false if it is something else.
bool read_spec(std::string_view text, Spec& spec) {
  std::size_t at = 0;
  const auto is_align = [](char c) { return c == '<' || c == '>' || c == '^' || c == '='; };
  if (text.size() > 1 && is_align(text[1])) {
    spec.fill = text[0];
    spec.align = text[1];
    at = 2;
  } else if (!text.empty() && is_align(text[0])) {
    spec.align = text[at++];
  }
  const auto next = [&] { return at < text.size() ? text[at] : '\0'; };
  if (next() == '+' || next() == '-' || next() == ' ') spec.sign = text[at++];
  if (next() == '#') {
    spec.is_alternate = true;
    ++at;
  }
  if (next() == '0') {
    spec.fill = '0';
    if (spec.align == '\0') spec.align = '=';
    ++at;
  }
  spec.width = std::max(0, read_count(text, at));
  if (next() == ',') {
    spec.groups = true;
    ++at;
  }
  if (next() == '.') {
    ++at;
    spec.precision = read_count(text, at);
    if (spec.precision < 0) return false;
  }
  if (at < text.size()) spec.type = text[at++];
  return at == text.size();
}

/// The value of "0", "name" or "" in a format.
Value field_of(Call& call, const std::string& name, std::size_t& next) {
  Evaluator& evaluator = call.evaluator;
  std::size_t position = next;
  if (name.empty()) {
    ++next;
  } else if (name.find_first_not_of("0123456789") == std::string::npos && name.size() < 6) {
    position = static_cast<std::size_t>(std::stoul(name));
  } else if (name.find_first_of(".[") != std::string::npos) {
    return evaluator.fail_unsupported("`.` or `[` in a format");
  } else {
    evaluator.step(1 + call.keywords.size() / 8);
    for (const auto& [keyword, value] : call.keywords) {
      if (keyword == name) return value;
    }
    return evaluator.fail("there is no value " + quoted(name) + " for the format");
  }
  if (position >= call.count()) return evaluator.fail("there are too few values for the format");
  return call.values[position];
}

}  // namespace

Value percent_format(Evaluator& evaluator, const std::string& format, const Value& values) {
  return PercentFormatter(evaluator, format, values).run();
}

Value brace_format(Call& call) {
  const std::string& format = *call.self.text;
  Evaluator& evaluator = call.evaluator;
  evaluator.step(format.size() / 8);
  std::string result;
  std::size_t next = 0;
  for (std::size_t at = 0; at < format.size(); ++at) {
    if (result.size() > evaluator.limits().xacro_text_bytes) break;  // reported below
    const char c = format[at];
    if (c != '{' && c != '}') {
      result.push_back(c);
      continue;
    }
    if (at + 1 < format.size() && format[at + 1] == c) {
      result.push_back(c);
      ++at;
      continue;
    }
    const std::size_t end = format.find('}', at);
    if (c == '}' || end == std::string::npos) return evaluator.fail("a single brace in the format");
    const std::string field = format.substr(at + 1, end - at - 1);
    at = end;
    const std::size_t colon = std::min(field.find(':'), field.size());
    std::string name = field.substr(0, colon);
    const bool is_repr = name.ends_with("!r");
    if (is_repr || name.ends_with("!s")) name.resize(name.size() - 2);
    Value value = field_of(call, name, next);
    if (value.is_failed()) return value;
    if (is_repr) value = evaluator.text(evaluator.repr(value));
    Spec spec;
    const std::string_view wanted =
        std::string_view(field).substr(std::min(colon + 1, field.size()));
    if (!read_spec(wanted, spec)) return evaluator.fail_unsupported("the format " + quoted(wanted));
    if (is_too_wide(evaluator, spec)) return Value::failure();
    if (wanted.empty()) {
      result += evaluator.string_of(value);
    } else {
      result += formatted(evaluator, value, spec);
    }
    if (evaluator.has_failed()) return Value::failure();
  }
  return evaluator.text(std::move(result));
}

}  // namespace smurf::xacro
