// SPDX-License-Identifier: BSD-3-Clause
#include "archive/zip.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <type_traits>

#include <minizip/unzip.h>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/numbers/little_endian.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

/// The bytes that minizip reads.
struct Memory {
  std::string_view bytes;
  std::size_t at = 0;
};

Memory& memory(voidpf stream) { return *static_cast<Memory*>(stream); }

voidpf open_memory(voidpf opaque, const void* /*name*/, int /*mode*/) { return opaque; }

uLong read_memory(voidpf /*opaque*/, voidpf stream, void* buffer, uLong size) {
  Memory& file = memory(stream);
  const std::size_t count = std::min<std::size_t>(size, file.bytes.size() - file.at);
  if (count > 0) std::memcpy(buffer, file.bytes.data() + file.at, count);
  file.at += count;
  return static_cast<uLong>(count);
}

ZPOS64_T tell_memory(voidpf /*opaque*/, voidpf stream) { return memory(stream).at; }

long seek_memory(voidpf /*opaque*/, voidpf stream, ZPOS64_T offset, int origin) {
  Memory& file = memory(stream);
  const std::size_t base = origin == ZLIB_FILEFUNC_SEEK_CUR   ? file.at
                           : origin == ZLIB_FILEFUNC_SEEK_END ? file.bytes.size()
                                                              : 0;
  if (offset > file.bytes.size() - base) return -1;
  file.at = base + static_cast<std::size_t>(offset);
  return 0;
}

int close_memory(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }
int error_of_memory(voidpf /*opaque*/, voidpf /*stream*/) { return 0; }

struct Close {
  void operator()(unzFile file) const { unzClose(file); }
};
using Zip = std::unique_ptr<std::remove_pointer_t<unzFile>, Close>;

bool is_inside(std::string_view path) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  if (path.size() > 1 && path[1] == ':' && kLetters.find(path[0]) != std::string_view::npos) {
    return false;  // a drive of Windows
  }
  if (path.empty() || path::is_absolute(path) || path.find('\\') != std::string_view::npos ||
      path.find('\0') != std::string_view::npos) {
    return false;
  }
  return path::file_name(path) != "." && !path::normalize(path).starts_with("..");
}

constexpr std::string_view kBeginOfSizes = "PK\x07\x08";

/// A file in the archive, with its header.
struct Packed {
  std::size_t begin = 0, end = 0;
  bool has_sizes_behind = false;  ///< checksum and sizes follow the bytes
  std::uint64_t checksum = 0, packed_size = 0, size = 0;

  /// Whether the next file, or the directory, begins where this one ends.
  bool is_followed_by(std::size_t next, std::string_view archive) const {
    if (!has_sizes_behind || next < end) return next == end;
    std::string_view behind = archive.substr(end, next - end);
    // Sizes have 4 or 8 bytes; the signature is optional.
    if (behind.size() == 16 || behind.size() == 24) {
      if (!behind.starts_with(kBeginOfSizes)) return false;
      behind.remove_prefix(kBeginOfSizes.size());
    }
    if (behind.size() != 12 && behind.size() != 20) return false;
    const std::size_t width = (behind.size() - 4) / 2;
    const auto number = [&](std::size_t at) {
      const std::uint64_t low = read_uint32(behind, at);
      return width == 4 ? low : low | std::uint64_t{read_uint32(behind, at + 4)} << 32U;
    };
    return read_uint32(behind, 0) == checksum && number(4) == packed_size &&
           number(4 + width) == size;
  }
};

/// Whether some file systems and programs leave a character out of a name: it has no width.
bool is_ignorable(char32_t c) {
  return c == 0xAD || c == 0x34F || c == 0x61C || (c >= 0x115F && c <= 0x1160) ||
         (c >= 0x17B4 && c <= 0x17B5) || (c >= 0x180B && c <= 0x180F) ||
         (c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) ||
         (c >= 0x2060 && c <= 0x206F) || (c >= 0xFE00 && c <= 0xFE0F) || c == 0xFEFF ||
         c == 0xFFA0 || (c >= 0xE0000 && c <= 0xE0FFF);
}

/// The small letter of the alphabets that most names are written in, and that of ASCII for
/// characters that some systems treat as one: KELVIN SIGN, LONG S, wide forms.
char32_t lowered(char32_t c) {
  if (c == 0x212A) return 'k';
  if (c == 0x17F) return 's';
  if (c == 0x130 || c == 0x131) return 'i';
  if (c >= 0xFF01 && c <= 0xFF5E) c = c - 0xFF01 + 0x21;
  const bool is_pair = (c >= 0x100 && c <= 0x137) || (c >= 0x14A && c <= 0x177) ||
                       (c >= 0x460 && c <= 0x481) || (c >= 0x48A && c <= 0x4BF) ||
                       (c >= 0x1E00 && c <= 0x1EFF);
  if (is_pair) return c | 1U;
  if (c >= 0x139 && c <= 0x148) return c + (c & 1U);
  const bool has_32 = (c >= 'A' && c <= 'Z') || (c >= 0xC0 && c <= 0xDE && c != 0xD7) ||
                      (c >= 0x391 && c <= 0x3A9) || (c >= 0x410 && c <= 0x42F);
  if (has_32) return c + 0x20;
  if (c >= 0x400 && c <= 0x40F) return c + 0x50;
  return c >= 0x531 && c <= 0x556 ? c + 0x30 : c;
}

std::u32string lowered(std::string_view name) {
  std::u32string all;
  for (; !name.empty(); name.remove_prefix(utf8::decode(name).size)) {
    const char32_t value = utf8::decode(name).value;
    if (!is_ignorable(value)) all += lowered(value);
  }
  return all;
}

bool is_mark(char32_t c) { return c >= 0x300 && c <= 0x36F; }

/// Equal for names that some file system treats as one: case does not count, nor how a letter with
/// a mark is written in Unicode. Letters outside of ASCII look alike.
std::string folded(std::string_view name) {
  std::string all;
  for (const char32_t c : lowered(name)) {
    if (is_mark(c) && !all.empty()) {
      all.back() = '\0';
    } else {
      all += c < 0x80 ? static_cast<char>(c) : '\0';
    }
  }
  return all;
}

/// Whether some file system treats the names of two files as one.
bool are_one_to_some(const std::string& a, const std::string& b) {
  const std::u32string one = lowered(a);
  const std::u32string other = lowered(b);
  return one == other || std::any_of(one.begin(), one.end(), is_mark) ||
         std::any_of(other.begin(), other.end(), is_mark);
}

/// Whether Windows gives a file another name: it drops points and blanks at the end of each part,
/// and a colon begins the name of a stream.
bool is_renamed_by_windows(std::string_view path) {
  const std::vector<std::string_view> parts = path::names(path);
  return path.find(':') != std::string_view::npos ||
         std::any_of(parts.begin(), parts.end(), [](std::string_view part) {
           return part != "." && part != ".." && (part.ends_with('.') || part.ends_with(' '));
         });
}

/// The mode of Unix, and a flag of DOS, say what an entry is.
bool is_plain(const unz_file_info64& info, bool is_folder) {
  constexpr uLong kTypeMask = 0170000;
  constexpr uLong kFolder = 0040000;
  constexpr uLong kFile = 0100000;
  constexpr uLong kDosFolder = 0x10;
  const uLong type = (info.external_fa >> 16U) & kTypeMask;
  if (type != 0 && type != (is_folder ? kFolder : kFile)) return false;
  return is_folder || (info.external_fa & kDosFolder) == 0;
}

/// What the extra field of an entry says about its name.
enum class NameInExtra : std::uint8_t { none, same, other_or_broken };

NameInExtra name_in(std::string_view extra, std::string_view name) {
  constexpr std::size_t kHead = 4;
  constexpr std::size_t kUnicodePath = 0x7075;
  constexpr std::size_t kPlaceOfName = 5;  // behind a version and a checksum
  NameInExtra found = NameInExtra::none;
  while (extra.size() >= kHead) {
    const std::size_t id = read_uint16(extra, 0);
    const std::size_t size = read_uint16(extra, 2);
    extra.remove_prefix(kHead);
    if (size > extra.size()) return NameInExtra::other_or_broken;
    const std::string_view content = extra.substr(0, size);
    extra.remove_prefix(size);
    if (id != kUnicodePath) continue;
    if (content.size() < kPlaceOfName || content.substr(kPlaceOfName) != name) {
      return NameInExtra::other_or_broken;
    }
    found = NameInExtra::same;
  }
  const bool is_rest_zero = extra.find_first_not_of('\0') == std::string_view::npos;
  return is_rest_zero ? found : NameInExtra::other_or_broken;
}

class Reader {
 public:
  Reader(std::string_view bytes, ArchiveBudget& budget)
      : file_{bytes}, budget_(budget), packed_left_(bytes.size()) {
    budget_.add_packed(bytes.size());
  }

  Archive run() {
    zlib_filefunc64_def functions{};
    functions.zopen64_file = open_memory;
    functions.zread_file = read_memory;
    functions.ztell64_file = tell_memory;
    functions.zseek64_file = seek_memory;
    functions.zclose_file = close_memory;
    functions.zerror_file = error_of_memory;
    functions.opaque = &file_;
    const Zip zip(unzOpen2_64(nullptr, &functions));
    if (!zip) return fail("is not a zip archive");
    int status = unzGoToFirstFile(zip.get());
    for (; status == UNZ_OK; status = unzGoToNextFile(zip.get())) {
      if (!add_file(zip.get())) return std::move(archive_);
    }
    if (status != UNZ_END_OF_LIST_OF_FILE || !is_whole()) return fail("is a broken zip archive");
    std::sort(archive_.files.begin(), archive_.files.end(),
              [](const ArchivedFile& a, const ArchivedFile& b) { return a.path < b.path; });
    if (!check_names()) return std::move(archive_);
    return std::move(archive_);
  }

 private:
  Archive fail(std::string reason) {
    archive_ = {{}, std::move(reason)};
    return std::move(archive_);
  }

  /// Some programs read the first of two files, others the last; some file systems keep only one of
  /// two names.
  bool check_names() {
    std::map<std::string, const std::string*> known;
    for (const ArchivedFile& file : archive_.files) {
      const auto [at, is_new] = known.emplace(folded(file.path), &file.path);
      if (is_new) continue;
      if (*at->second == file.path) {
        return refuse("contains two files named '" + file.path + "'");
      }
      if (are_one_to_some(*at->second, file.path)) {
        return refuse("contains the files '" + *at->second + "' and '" + file.path +
                      "', which are one file on some systems");
      }
    }
    for (const ArchivedFile& file : archive_.files) {
      for (std::size_t end = file.path.find('/'); end != std::string::npos;
           end = file.path.find('/', end + 1)) {
        const auto outer = known.find(folded(file.path.substr(0, end)));
        if (outer == known.end()) continue;
        if (!are_one_to_some(*outer->second, file.path.substr(0, end))) continue;
        return refuse("contains the file '" + *outer->second + "', which is also a folder");
      }
    }
    return true;
  }

  /// Whether every program finds the same files. Some read the directory that the last trailer
  /// names, some read the files from the front, and some read all entries of a directory, whatever
  /// their number. All places are counted from the first byte, as all programs do.
  bool is_whole() {
    constexpr std::string_view kSignature = "PK\x05\x06";
    constexpr std::size_t kTrailer = 22;
    constexpr std::size_t kPlaceOfSize = 12;
    constexpr std::size_t kPlaceOfDirectory = 16;
    constexpr std::size_t kPlaceOfComment = 20;
    const std::string_view trailer = file_.bytes.substr(std::min(after_entry_, file_.bytes.size()));
    if (!trailer.starts_with(kSignature) || trailer.size() < kTrailer) return false;
    const std::size_t comment = read_uint16(trailer, kPlaceOfComment);
    return trailer.rfind(kSignature) == 0 &&
           read_uint32(trailer, kPlaceOfDirectory) == directory_ &&
           read_uint32(trailer, kPlaceOfSize) == after_entry_ - directory_ &&
           trailer.size() == kTrailer + comment && has_no_gap();
  }

  /// Whether the packed files follow each other from the first byte to the directory.
  bool has_no_gap() {
    std::sort(packed_.begin(), packed_.end(),
              [](const Packed& a, const Packed& b) { return a.begin < b.begin; });
    Packed last;
    for (const Packed& file : packed_) {
      if (!last.is_followed_by(file.begin, file_.bytes)) return false;
      last = file;
    }
    return last.is_followed_by(directory_, file_.bytes);
  }

  bool refuse(std::string reason) {
    archive_ = {{}, std::move(reason)};
    return false;
  }

  bool add_file(unzFile zip) {
    unz_file_info64 info{};
    std::string name(1024, '\0');
    if (unzGetCurrentFileInfo64(zip, &info, name.data(), name.size(), nullptr, 0, nullptr, 0) !=
        UNZ_OK) {
      return refuse("is a broken zip archive");
    }
    constexpr std::size_t kHeader = 46;
    const auto entry = static_cast<std::size_t>(unzGetOffset64(zip));
    if (after_entry_ == 0) directory_ = entry;
    after_entry_ =
        entry + kHeader + info.size_filename + info.size_file_extra + info.size_file_comment;
    if (info.size_filename >= name.size()) return refuse("contains a file with too long a name");
    name.resize(info.size_filename);
    if (!check_header(entry, info, name)) return false;
    const bool is_folder = name.ends_with('/');
    if (!is_plain(info, is_folder)) {
      return refuse("contains '" + name + "', which is a link or no plain file");
    }
    if (!is_inside(name)) return refuse("contains the file '" + name + "', which is not inside it");
    if (is_renamed_by_windows(name)) {
      return refuse("contains the file '" + name + "', which has another name on Windows");
    }
    if (is_folder) {
      if (info.compressed_size == 0 && info.uncompressed_size == 0) return true;
      return refuse("contains the folder '" + name + "', which has content");
    }
    const std::uint64_t most_files = budget_.limits().archive_files;
    if (archive_.files.size() >= most_files) {
      return refuse("contains more than " + std::to_string(most_files) + " files; " +
                    raise_limit("archive-files"));
    }
    // Otherwise, a small archive could refer to the same bytes thousands of times.
    if (info.compressed_size > packed_left_) return refuse("contains files that share their bytes");
    packed_left_ -= info.compressed_size;
    if ((info.flag & 1U) != 0) return refuse("is encrypted");
    // This minizip may support bzip2.
    if (info.compression_method != 0 && info.compression_method != Z_DEFLATED) {
      return refuse("contains the file '" + name +
                    "', which is packed with a method other than deflate");
    }
    std::string text;
    if (!read(zip, text)) return false;
    // Only then has minizip compared the checksum.
    if (text.size() != info.uncompressed_size) return refuse("is a broken zip archive");
    archive_.files.push_back({path::normalize(name), std::move(text)});
    return true;
  }

  /// Programs that unpack a stream read the header before the bytes; others read the directory.
  bool check_header(std::size_t entry, const unz_file_info64& info, const std::string& name) {
    constexpr std::size_t kEntry = 46;
    constexpr std::size_t kPlaceOfFile = 42;   // in an entry of the directory
    constexpr std::size_t kPlaceOfSizes = 26;  // of name and extra field, in the header of a file
    constexpr std::size_t kPlaceOfName = 30;
    const std::size_t begin = read_uint32(file_.bytes, entry + kPlaceOfFile);
    const std::string_view header = file_.bytes.substr(std::min(begin, file_.bytes.size()));
    if (!header.starts_with("PK\x03\x04") || header.size() < kPlaceOfName) {
      return refuse("is a broken zip archive");
    }
    const std::size_t name_size = read_uint16(header, kPlaceOfSizes);
    const std::size_t extra_size = read_uint16(header, kPlaceOfSizes + 2);
    if (header.substr(kPlaceOfName, name_size) != name) {
      return refuse("contains the file '" + name + "', whose header has another name");
    }
    const std::size_t behind_name = entry + kEntry + name.size();
    // Programs decode a name that is not marked as UTF-8 in their own ways.
    bool is_utf8 = !utf8::find_invalid(name).has_value();
    for (const std::string_view extra :
         {header.substr(std::min(kPlaceOfName + name_size, header.size()), extra_size),
          file_.bytes.substr(std::min(behind_name, file_.bytes.size()), info.size_file_extra)}) {
      const NameInExtra other = name_in(extra, name);
      if (other == NameInExtra::other_or_broken) {
        return refuse("contains the file '" + name + "', which has a second name");
      }
      is_utf8 = is_utf8 && (other == NameInExtra::same || (info.flag & kIsUtf8) != 0);
    }
    if (!is_utf8 && utf8::ascii_prefix(name) < name.size()) {
      return refuse("contains the file '" + name +
                    "', whose name is not marked as UTF-8; give it a name of ASCII characters");
    }
    if (!has_facts(header, info)) {
      return refuse("contains the file '" + name + "', whose header differs from the directory");
    }
    return add_packed(begin, kPlaceOfName + name_size + extra_size, info, name);
  }

  bool add_packed(std::size_t begin, std::size_t header, const unz_file_info64& info,
                  const std::string& name) {
    const auto size = static_cast<std::size_t>(info.compressed_size);
    const bool has_sizes_behind = (info.flag & kHasSizesBehind) != 0;
    packed_.push_back({begin, begin + header + size, has_sizes_behind, info.crc,
                       info.compressed_size, info.uncompressed_size});
    // Then, a program that unpacks a stream may find the end of the file, and more files, in it.
    const std::string_view bytes = file_.bytes.substr(begin);
    if (!has_sizes_behind || bytes.size() <= header) return true;
    const std::string_view content = bytes.substr(header, size);
    if (content.find("PK\x03\x04") != std::string_view::npos) {
      return refuse("contains the file '" + name + "', in which another archive begins");
    }
    if (info.compression_method == 0 && content.find(kBeginOfSizes) != std::string_view::npos) {
      return refuse("contains the file '" + name + "', which may end in two places");
    }
    return true;
  }

  /// Whether the header of a file agrees with the entry in the directory: flags, method, checksum
  /// and sizes.
  static bool has_facts(std::string_view header, const unz_file_info64& info) {
    constexpr unsigned kFlags = 1U | kHasSizesBehind | kIsUtf8 | (1U << 13U);
    if (((read_uint16(header, 6) ^ info.flag) & kFlags) != 0) return false;
    if (read_uint16(header, 8) != info.compression_method) return false;
    const auto agrees = [&](std::size_t at, std::uint64_t value) {
      const std::uint32_t written = read_uint32(header, at);
      constexpr std::uint32_t kElsewhere = 0xffffffffU;
      const bool is_behind = (info.flag & kHasSizesBehind) != 0;
      return written == value || (is_behind && (written == 0 || written == kElsewhere));
    };
    return agrees(14, info.crc) && agrees(18, info.compressed_size) &&
           agrees(22, info.uncompressed_size);
  }

  /// The size in the archive may be wrong.
  bool read(unzFile zip, std::string& text) {
    if (unzOpenCurrentFile(zip) != UNZ_OK) return refuse("is a broken zip archive");
    char buffer[1U << 16U];
    int count = 0;
    while ((count = unzReadCurrentFile(zip, buffer, sizeof buffer)) > 0) {
      if (!budget_.take(static_cast<std::uint64_t>(count))) {
        return refuse(budget_.excess());
      }
      text.append(buffer, static_cast<std::size_t>(count));
    }
    // Closing compares the checksum.
    if (count < 0 || unzCloseCurrentFile(zip) != UNZ_OK) return refuse("is a broken zip archive");
    return true;
  }

  static constexpr unsigned kHasSizesBehind = 1U << 3U;
  static constexpr unsigned kIsUtf8 = 1U << 11U;

  Memory file_;
  ArchiveBudget& budget_;
  std::uint64_t packed_left_;    ///< bytes of the archive that belong to no unpacked file
  std::size_t directory_ = 0;    ///< where it begins
  std::size_t after_entry_ = 0;  ///< where the last entry of the directory ends
  std::vector<Packed> packed_;
  Archive archive_;
};

}  // namespace

/// Small archives may grow by any factor.
std::uint64_t ArchiveBudget::most_by_growth() const {
  constexpr std::uint64_t kFree = 8'000'000;
  return kFree + limits_.archive_growth * packed_;
}

std::uint64_t ArchiveBudget::most() const {
  return std::min(limits_.archive_bytes, most_by_growth());
}

bool ArchiveBudget::take(std::uint64_t bytes) {
  if (bytes > most() - std::min(most(), unpacked_)) return false;
  unpacked_ += bytes;
  return true;
}

std::string ArchiveBudget::excess() const {
  const bool is_total = limits_.archive_bytes <= most_by_growth();
  const std::string_view before = archives_ > 1 ? ", with the archives before it," : "";
  return "unpacks" + std::string(before) + " to more than " + std::to_string(most()) + " bytes; " +
         raise_limit(is_total ? "archive-bytes" : "archive-growth");
}

Archive read_zip(std::string_view bytes, ArchiveBudget& budget) {
  return Reader(bytes, budget).run();
}

}  // namespace smurf
