// The segments of a TDMS file (National Instruments): what they say of the
// file's objects, and where raw values of channels lie.
//
//   lead-in    "TDSm", contents (bits), version, where the next segment begins,
//              where the raw values begin
//   metadata   per object: path, kind and number of its values in each chunk,
//              properties; what is not told again is as in the segment before
//   raw data   chunks: the values of channel after channel, or, interleaved,
//              of all channels sample after sample
//
// Source: National Instruments, "TDMS File Format Internal Structure".
#pragma once

#include "acquisition/instruments/binary_numbers.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tapfit::acquisition {

/// A property's value; times and the like are left out.
using TdmsProperty = std::variant<double, std::string>;

/// A channel "/'Group'/'Channel'", a group or the file itself, "/".
struct TdmsObject {
  std::string path;
  std::map<std::string, TdmsProperty> properties;
  bool has_numbers = false;  ///< raw values that are numbers, in any segment
};

/// Raw values of one object that follow each other.
struct TdmsPiece {
  std::size_t object = 0;  ///< index into what was read
  const char* bytes = nullptr;
  std::size_t stride = 0;  ///< bytes from one value to the next
  NumberType type = NumberType::Float64;
  ByteOrder order = ByteOrder::Little;
  std::size_t count = 0;
};

/// Reads all segments.
///
/// @param take gets the pieces in the order of the samples
/// @throws InputError for a file that is none or ends early, for values as the
///   DAQmx driver writes them, for kinds of values that are not known
[[nodiscard]] std::vector<TdmsObject> read_tdms_segments(
    std::string_view bytes,
    const std::filesystem::path& file,
    const std::function<void(const TdmsPiece&)>& take);

}  // namespace tapfit::acquisition
