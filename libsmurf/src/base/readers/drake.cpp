// SPDX-License-Identifier: BSD-3-Clause
// Drake, which has its own URDF reader.
#include "base/readers.hpp"

namespace smurf::readers::drake_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18",
     {&drake, refuses, "refuses a vector with an unreadable number; reads a single one as 0",
      "Drake detail_tinyxml.h:60-73"}},
};

constexpr Fact kUnread[] = {
    {&drake, ignores, "does not read what `drake_ignore` marks",
     "Drake detail_urdf_parser.cc:187-191, 533-538", "#drake-ignored"},
};

}  // namespace

extern constinit const Reader drake{.name = "drake",
                                    .title = "Drake",
                                    .basis = "be259df (2026-08), read",
                                    .like = &urdf,
                                    .families = kFamilies,
                                    .unread = kUnread};

}  // namespace smurf::readers::drake_file
