// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/digest.hpp"

#include <doctest/doctest.h>

using smurf::digest_of;
using smurf::hex_of;

// Each was printed by `b2sum --length 256`.
TEST_CASE("digests are those of BLAKE2b") {
  CHECK(hex_of(digest_of("")) ==
        "0e5751c026e543b2e8ab2eb06099daa1d1e5df47778f7787faab45cdf12fe3a8");
  CHECK(hex_of(digest_of("abc")) ==
        "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
  CHECK(hex_of(digest_of(std::string(127, 'a'))) ==
        "59e2f1aba240f20aa591016f5ef429990bc9c2131dcd0d30f0ffd75ed18f317d");
  CHECK(hex_of(digest_of(std::string(128, 'a'))) ==
        "ae2aa48507885c4c950fb809b2076f959cde9f8ea6da260d9a3587df33dac450");
  CHECK(hex_of(digest_of(std::string(129, 'a'))) ==
        "2f64744a6de0d2c0b56e64cf6e29a5aaa255010d415d51c75ccc82f73dccd865");
  CHECK(hex_of(digest_of(std::string(1000, 'a'))) ==
        "e00b0ddbf1e2cdaf5c898e1a5e8826ea3a2c339bcf2a478da2e5fca9ff126672");
  CHECK(hex_of(digest_of("abc"), 4) == "bddd813c");
}

TEST_CASE("lists of names have other digests than their parts") {
  CHECK(smurf::digest_of_names({"ab", "c"}) != smurf::digest_of_names({"a", "bc"}));
  CHECK(smurf::digest_of_names({}) == smurf::short_digest(""));
}
