#include "acquisition/foundation/input_file.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <streambuf>
#include <system_error>
#include <unistd.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

const char* kind_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::block:
    case fs::file_type::character:
      return "a device";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    default:
      return "something else";
  }
}

}  // namespace

void check_input(const fs::path& file, std::uintmax_t most_bytes) {
  std::error_code fault;
  const fs::file_status there = fs::status(file, fault);
  if (!fs::exists(there)) return;
  if (!fs::is_regular_file(there)) {
    throw InputError(
        fmt::format("is {}, and no file that can be read",
                    kind_of(there.type())),
        file.string(),
        "name a regular file; copy into one what a device or pipe delivers");
  }
  const std::uintmax_t bytes = fs::file_size(file, fault);
  if (fault || bytes <= most_bytes) return;
  throw InputError(fmt::format("has {} MB, {} MB are the most that is read",
                               bytes >> 20U,
                               most_bytes >> 20U),
                   file.string(),
                   "see whether this is the file that was meant");
}

std::string no_file(const fs::path& file) {
  std::error_code fault;
  const fs::file_status there = fs::status(file, fault);
  return fs::exists(there)
             ? fmt::format("{} is {}, and no file that can be read",
                           file.string(),
                           kind_of(there.type()))
             : fmt::format("there is no file {}", file.string());
}

std::ifstream open_input(const fs::path& file, std::uintmax_t most_bytes) {
  check_input(file, most_bytes);
  return std::ifstream(file, std::ios::binary);
}

std::string read_input(const fs::path& file) {
  std::ifstream stream = open_input(file, most_text_bytes);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool take_line(std::istream& text, std::string& line) {
  line.clear();
  if (!text) return false;
  try {
    std::streambuf& in = *text.rdbuf();
    for (int c = in.sbumpc(); c != EOF; c = in.sbumpc()) {
      if (c == '\r' && in.sgetc() == '\n') c = in.sbumpc();
      if (c == '\n' || c == '\r') return true;
      line += static_cast<char>(c);
    }
    text.setstate(std::ios::eofbit);
  } catch (const std::ios_base::failure&) {
    text.setstate(std::ios::badbit);
  }
  return !line.empty();
}

std::uintmax_t most_table_bytes() {
  return static_cast<std::uintmax_t>(0.5 * most_matrix_bytes());
}

double most_matrix_bytes() {
  return 0.5 * static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(::sysconf(_SC_PAGESIZE));
}

}  // namespace tapfit::acquisition
