// SPDX-License-Identifier: BSD-3-Clause
// Indented XML, built element by element. Nothing is added after it exceeds its limit.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

class XmlText {
 public:
  using Attribute = std::pair<std::string_view, std::string>;
  using Attributes = std::initializer_list<Attribute>;

  explicit XmlText(std::uint64_t most) : most_(most), out_("<?xml version=\"1.0\"?>\n") {}

  void open(std::string_view name, Attributes attributes = {});
  void close();
  void empty(std::string_view name, Attributes attributes = {});
  void empty(std::string_view name, const std::vector<Attribute>& attributes);
  void leaf(std::string_view name, std::string_view text, Attributes attributes = {});
  void leaf(std::string_view name, double value);
  /// Two hyphens, which end a comment, become one.
  void comment(std::string text);
  /// Adds text that is already XML, on separate lines.
  void raw(std::string_view text) {
    if (!is_full()) out_ += text;
  }
  bool is_full() const { return out_.size() > most_; }
  /// Closes all open elements.
  std::string finish();

 private:
  void indent(std::size_t depth);
  void start(std::string_view name, std::span<const Attribute> attributes, std::size_t depth);

  std::uint64_t most_;
  std::string out_;
  std::vector<std::string> open_;
};

std::string join_numbers(std::initializer_list<double> values);
std::string join_numbers(const Vector3& vector);

}  // namespace smurf
