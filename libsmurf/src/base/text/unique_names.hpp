// SPDX-License-Identifier: BSD-3-Clause
// Makes names unique: "a", "a_2", "a_3".
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

namespace smurf {

class UniqueNames {
 public:
  bool empty() const { return taken_.empty(); }
  void take(std::string name) { taken_.insert(std::move(name)); }

  /// `base`, with the first number that makes the name unique if necessary.
  std::string add(const std::string& base) {
    if (taken_.insert(base).second) return base;
    int& number = numbers_.try_emplace(base, 1).first->second;
    std::string name;
    do {
      name = base + "_" + std::to_string(++number);
    } while (!taken_.insert(name).second);
    return name;
  }

 private:
  std::set<std::string> taken_;
  std::map<std::string, int> numbers_;  ///< the last number that was tried, by base
};

}  // namespace smurf
