// SPDX-License-Identifier: BSD-3-Clause
// Cases of findings that a reader or the linker reports, and that the facts of a rule elsewhere are
// about. The cases of a check stand beside it.
#pragma once

#include "smurf/diagnostic.hpp"

namespace smurf::cases {

// The kind of the file, in findings on YAML that locate() places.
inline constexpr Circumstance kInMain{"in the .smurf"};
inline constexpr Circumstance kInAnnotations{"in annotations"};
inline constexpr Circumstance kInScene{"in a scene"};
inline constexpr Circumstance kInCompanion{"in a file beside the robot"};

// In the URDF that is made of a file, which a reader of that language does not see.
inline constexpr Circumstance kOfMjcf{"in a URDF of an MJCF file"};
inline constexpr Circumstance kOfSdf{"in a URDF of an SDF file"};

// SML0004: the byte is in a URDF, where readers of XML may keep it.
inline constexpr Circumstance kInUrdf{"in a URDF"};
// SML0010
inline constexpr Circumstance kQuote{"quote"};
inline constexpr Circumstance kLine{"line"};

// SML1001: what is malformed.
inline constexpr Circumstance kFault{"fault"};
inline constexpr Circumstance kNoTag{"no tag"};
inline constexpr Circumstance kBlankTag{"blank tag"};
inline constexpr Circumstance kControl{"control character"};
inline constexpr Circumstance kDeclaration{"declaration"};
inline constexpr Circumstance kCommentBehind{"comment behind"};
inline constexpr Circumstance kInstruction{"instruction"};
inline constexpr Circumstance kInstructionAttribute{"attribute of an instruction"};
inline constexpr Circumstance kUnquotedInDeclaration{"value without quotes in the declaration"};
inline constexpr Circumstance kTextBehindDeclaration{"text behind the declaration"};
inline constexpr Circumstance kTypographicQuotes{"typographic quotes"};
inline constexpr Circumstance kEndTagAttribute{"attribute of an end tag"};
inline constexpr Circumstance kEndTagBehind{"end tag behind"};
// SML1003, SML1005, SML1008, SML1013
inline constexpr Circumstance kCharacter{"character"};
inline constexpr Circumstance kBlanks{"blanks"};
inline constexpr Circumstance kSecond{"second declaration"};
inline constexpr Circumstance kWide{"wide"};
inline constexpr Circumstance kDeclarations{"declarations"};

// SML1101: the language of the file.
inline constexpr Circumstance kSdf{"SDF"};
inline constexpr Circumstance kMjcf{"MJCF"};
inline constexpr Circumstance kForeign{"foreign"};
inline constexpr Circumstance kCased{"Robot"};
inline constexpr Circumstance kWithoutLinks{"without links"};
// SML1113: what has no name. SML1114: which element.
inline constexpr Circumstance kLinkTag{"link"};
inline constexpr Circumstance kJointTag{"joint"};
inline constexpr Circumstance kChainTag{"joint with others behind it"};
inline constexpr Circumstance kSharedMaterialTag{"material of the robot"};
inline constexpr Circumstance kColourless{"without colour"};

// SML9302: a file of its own kind, or a mesh of a built-in kind.
inline constexpr Circumstance kMadeByMujoco{"mesh of MuJoCo's own"};
// SML1604 and SML8205: no file of a package was found.
inline constexpr Circumstance kLostPackage{"package"};
// SML8207: a picture is not expected to have it.
inline constexpr Circumstance kPicture{"picture"};

// SML18: numbers of a URDF.
inline constexpr Circumstance kEmpty{"empty"};
inline constexpr Circumstance kHex{"hexadecimal"};
inline constexpr Circumstance kBroken{"broken"};
inline constexpr Circumstance kZeroOrLess{"zero or less"};
inline constexpr Circumstance kTooMany{"too many"};
inline constexpr Circumstance kTooFew{"too few"};
inline constexpr Circumstance kLongWord{"long word"};
inline constexpr Circumstance kLeading{"leading"};
inline constexpr Circumstance kUnderflow{"underflow"};
inline constexpr Circumstance kOverflow{"overflow"};
inline constexpr Circumstance kSubnormal{"subnormal"};
inline constexpr Circumstance kTooLarge{"too large"};
inline constexpr Circumstance kEnoughRead{"enough numbers readable"};  ///< as `std::cin >>` reads
inline constexpr Circumstance kEnoughWords{"enough words"};            ///< between spaces

// SML2001, SML2002, SML2009: the file is the URDF.
inline constexpr Circumstance kTheUrdf{"the URDF"};

// SML4001: the expected value.
inline constexpr Circumstance kValueWanted{"value"};      ///< a text, a number, true or false
inline constexpr Circumstance kNamesWanted{"names"};      ///< a list of names
inline constexpr Circumstance kNumbersWanted{"numbers"};  ///< a list of numbers
inline constexpr Circumstance kMappingWanted{"mapping"};
inline constexpr Circumstance kSectionWanted{"section"};
inline constexpr Circumstance kEntryWanted{"entry"};    ///< an entry of a section
inline constexpr Circumstance kEntityWanted{"entity"};  ///< an entity of a scene
// SML4001: the value that is there instead.
inline constexpr Circumstance kIsNothing{"is nothing"};
inline constexpr Circumstance kIsMapping{"is a mapping"};
inline constexpr Circumstance kIsEmptyList{"is an empty list"};
inline constexpr Circumstance kIsSingle{"is a list of one"};
inline constexpr Circumstance kIsList{"is a list"};
inline constexpr Circumstance kIsBlank{"is an empty text"};
inline constexpr Circumstance kIsQuoted{"is quoted"};
inline constexpr Circumstance kIsText{"is a text"};
inline constexpr Circumstance kHasNull{"has a null"};
inline constexpr Circumstance kHasItems{"has too many or too few items"};
inline constexpr Circumstance kIsEntity{"is an entity"};
// SML4003, SML4004
inline constexpr Circumstance kNegative{"negative"};
inline constexpr Circumstance kEmptyKey{"empty key"};
inline constexpr Circumstance kLacksFiles{"no files"};
// SML5005, SML5009, SML5034
inline constexpr Circumstance kOfScene{"scene"};
inline constexpr Circumstance kOfAnotherKind{"of another kind"};
inline constexpr Circumstance kHeights{"heights"};
inline constexpr Circumstance kSeen{"seen"};

// SML3101, SML3102: the entry that names what does not exist.
inline constexpr Circumstance kKnownCollision{"known collision"};
inline constexpr Circumstance kLaterMotor{"later motor"};
inline constexpr Circumstance kOnItsLink{"on its link"};
inline constexpr Circumstance kOfOthers{"of others"};

}  // namespace smurf::cases
