// SPDX-License-Identifier: BSD-3-Clause
#include "ast/key_renames.hpp"

#include <string>

#include "ast/keys.hpp"

namespace smurf {

bool KeyRenames::has(std::string_view name) {
  if (!keys_) {
    keys_.emplace();
    for (const yaml::View key : mapping_) keys_->insert(key.key());
  }
  return keys_->contains(name);
}

void KeyRenames::offer(std::vector<Fix>& fixes, yaml::View key, std::string_view name) {
  // Without leading dashes, a directive above would not belong to a document.
  if (key.key().starts_with("---") || !is_free(name)) return;
  const auto place = within_quotes(key.key_span(), key.key());
  if (!place) return;
  offered_.insert(name);
  fixes.push_back({Applicability::unsafe,
                   {{*place, std::string(name)}},
                   Fix::NewName{mapping_.span(), std::string(name)}});
}

}  // namespace smurf
