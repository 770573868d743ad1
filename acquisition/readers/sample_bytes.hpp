// How many bytes of samples a sound file says it holds, and how many are there,
// for containers with lengths of 64 bits: libsndfile opens those that are cut
// off without a word.
//
//   container  begins   a chunk is            lengths       samples in
//   RF64       RF64     id(4) length(4)       without head  data, and its
//   length
//                                                           in ds64
//   Wave64     riff..   id(16) length(8)      with head     data..
//
// Source: EBU Tech 3306 (RF64); Sony Pictures Digital, "Wave64 file format".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace tapfit::acquisition {

struct SampleBytes {
  std::uint64_t announced = 0;
  std::uint64_t present = 0;  ///< from the first sample to the file's end
};

/// Empty for files of other kinds, and where the length is not known yet: a
/// recorder that writes as it goes leaves all ones until it is stopped.
[[nodiscard]] std::optional<SampleBytes> sample_bytes(
    const std::filesystem::path& file);

}  // namespace tapfit::acquisition
