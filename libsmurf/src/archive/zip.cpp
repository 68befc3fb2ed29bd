// SPDX-License-Identifier: BSD-3-Clause
#include "archive/zip.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <type_traits>

#include <minizip/unzip.h>

#include "base/limits.hpp"
#include "base/little_endian.hpp"
#include "base/path.hpp"

namespace smurf {
namespace {

/// The largest values that minizip accepts.
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
  if (path.empty() || path::is_absolute(path) || path.find('\\') != std::string_view::npos ||
      path.find('\0') != std::string_view::npos) {
    return false;
  }
  return !path::normalize(path).starts_with("..");
}

/// A file in the archive, with its header.
struct Packed {
  std::size_t begin = 0, end = 0;
  bool has_sizes_behind = false;  ///< sizes and checksum follow the bytes

  bool is_followed_by(std::size_t next) const {
    if (!has_sizes_behind || next < end) return next == end;
    const std::size_t behind = next - end;  // sizes have 4 or 8 bytes; a signature is optional
    return behind == 12 || behind == 16 || behind == 20 || behind == 24;
  }
};

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
    // Some programs read the first of two files, others the last.
    const auto twice = std::adjacent_find(
        archive_.files.begin(), archive_.files.end(),
        [](const ArchivedFile& a, const ArchivedFile& b) { return a.path == b.path; });
    if (twice != archive_.files.end())
      return fail("contains two files named '" + twice->path + "'");
    return std::move(archive_);
  }

 private:
  Archive fail(std::string reason) {
    archive_ = {{}, std::move(reason)};
    return std::move(archive_);
  }

  /// Whether every program finds the same files. Some read the directory that the last trailer
  /// names, some read the files from the front, and some read all entries of a directory, whatever
  /// their number.
  bool is_whole() {
    constexpr std::size_t kTrailer = 22;
    constexpr std::size_t kPlaceOfComment = 20;
    const std::string_view trailer = file_.bytes.substr(std::min(after_entry_, file_.bytes.size()));
    if (!trailer.starts_with("PK\x05\x06") || trailer.size() < kTrailer) return false;
    const std::size_t comment = read_uint16(trailer, kPlaceOfComment);
    return trailer.size() == kTrailer + comment && has_no_gap();
  }

  /// Whether the packed files follow each other from the first byte to the directory.
  bool has_no_gap() {
    std::sort(packed_.begin(), packed_.end(),
              [](const Packed& a, const Packed& b) { return a.begin < b.begin; });
    Packed last;
    for (const Packed& file : packed_) {
      if (!last.is_followed_by(file.begin)) return false;
      last = file;
    }
    return last.is_followed_by(directory_);
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
    if (name.ends_with('/')) return true;  // a folder
    if (!is_inside(name)) return refuse("contains the file '" + name + "', which is not inside it");
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
    constexpr std::size_t kPlaceOfFile = 42;   // in an entry of the directory
    constexpr std::size_t kPlaceOfSizes = 26;  // of name and extra field, in the header of a file
    constexpr std::size_t kPlaceOfName = 30;
    const std::size_t begin = read_uint32(file_.bytes, entry + kPlaceOfFile);
    const std::string_view header = file_.bytes.substr(std::min(begin, file_.bytes.size()));
    if (!header.starts_with("PK\x03\x04") || header.size() < kPlaceOfName) {
      return refuse("is a broken zip archive");
    }
    if (!header.substr(kPlaceOfName).starts_with(name)) {
      return refuse("contains the file '" + name + "', whose header has another name");
    }
    const std::size_t end = begin + kPlaceOfName + read_uint16(header, kPlaceOfSizes) +
                            read_uint16(header, kPlaceOfSizes + 2) +
                            static_cast<std::size_t>(info.compressed_size);
    constexpr unsigned kHasSizesBehind = 1U << 3U;
    packed_.push_back({begin, end, (info.flag & kHasSizesBehind) != 0});
    return true;
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
