// Files that are read: regular ones of a bounded size. A device has no end, a
// pipe may never begin, and neither is told from a file by its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>

namespace tapfit::acquisition {

/// Of a file that is taken into memory as text: far above what people and
/// programs write there.
inline constexpr std::uintmax_t most_text_bytes = 256U << 20U;

/// Of a table of samples as text, which is taken into memory as that and as
/// numbers: a quarter of the machine's memory.
[[nodiscard]] std::uintmax_t most_table_bytes();

/// Refuses what is there and no regular file, and a file that is too large.
/// What is not there passes: whoever opens it knows what it was for.
///
/// @throws InputError naming what it is, or its size and the limit
void check_input(const std::filesystem::path& file,
                 std::uintmax_t most_bytes = UINTMAX_MAX);

/// What to say of a file that is not there, or is none but a folder or a pipe.
[[nodiscard]] std::string no_file(const std::filesystem::path& file);

/// Opens a file for reading, as check_input allows; as it is, without a
/// translation of line ends. The stream is not good where nothing is there.
/// @throws InputError as check_input
[[nodiscard]] std::ifstream open_input(const std::filesystem::path& file,
                                       std::uintmax_t most_bytes = UINTMAX_MAX);

/// The whole file; empty where nothing is there.
/// @throws InputError as check_input, with most_text_bytes as limit
[[nodiscard]] std::string read_input(const std::filesystem::path& file);

/// The next line of a text, which ends in LF, CR or both, or with the text.
/// @return false where there is none; the stream is bad where it cannot be read
bool take_line(std::istream& text, std::string& line);

/// Bytes that one matrix may take: half of the machine's memory.
[[nodiscard]] double most_matrix_bytes();

}  // namespace tapfit::acquisition
