// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml1811_unicode_digit_or_space_file {

extern constinit const Rule sml1811_unicode_digit_or_space{
    .id = "SML1811",
    .name = "unicode-digit-or-space",
    .severity = Severity::error,
    .summary = "A number contains a character that only looks like a digit, minus sign or space.",
    .why = "A Unicode minus or a no-break space comes with text that was pasted from a document.",
    .remedy = "Type the number again."};

}  // namespace smurf::rules::sml1811_unicode_digit_or_space_file
