// Sound files written byte by byte, for tests: what each container's own
// description asks for, and nothing else.
#pragma once

#include <Eigen/Core>

#include <bit>
#include <cstdint>
#include <string>

namespace tapfit::testing {

/// How one number is stored.
struct SoundNumber {
  int bits = 16;  ///< 8, 16, 24, 32 whole; 32, 64 floating point
  bool is_float = false;
  bool big_endian = false;
};

inline std::string number_bytes(std::uint64_t value, int count, bool big) {
  std::string bytes;
  for (int k = 0; k < count; ++k) {
    const int place = big ? count - 1 - k : k;
    bytes += static_cast<char>((value >> (8 * place)) & 0xFF);
  }
  return bytes;
}

/// Frames of samples in -1..1 that the number can hold without rounding.
inline std::string sound_frames(const Eigen::MatrixXd& x,
                                const SoundNumber& as) {
  std::string bytes;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    for (Eigen::Index c = 0; c < x.cols(); ++c) {
      std::uint64_t value = 0;
      if (as.is_float && as.bits == 32) {
        value = std::bit_cast<std::uint32_t>(static_cast<float>(x(i, c)));
      } else if (as.is_float) {
        value = std::bit_cast<std::uint64_t>(x(i, c));
      } else {
        value = static_cast<std::uint64_t>(
            static_cast<std::int64_t>(std::ldexp(x(i, c), as.bits - 1)));
      }
      bytes += number_bytes(value, as.bits / 8, as.big_endian);
    }
  }
  return bytes;
}

inline std::string wav_format(const Eigen::MatrixXd& x,
                              const SoundNumber& as,
                              std::uint32_t rate) {
  const auto channels = static_cast<std::uint64_t>(x.cols());
  const auto frame = channels * static_cast<std::uint64_t>(as.bits / 8);
  return number_bytes(as.is_float ? 3 : 1, 2, false) +
         number_bytes(channels, 2, false) + number_bytes(rate, 4, false) +
         number_bytes(rate * frame, 4, false) + number_bytes(frame, 2, false) +
         number_bytes(static_cast<std::uint64_t>(as.bits), 2, false);
}

inline std::string wav_bytes(const Eigen::MatrixXd& x,
                             const SoundNumber& as,
                             std::uint32_t rate) {
  const std::string data = sound_frames(x, as);
  return "RIFF" + number_bytes(36 + data.size(), 4, false) + "WAVEfmt " +
         number_bytes(16, 4, false) + wav_format(x, as, rate) + "data" +
         number_bytes(data.size(), 4, false) + data;
}

/// WAVE_FORMAT_EXTENSIBLE, as converters of 24 bits write it.
inline std::string wavex_bytes(const Eigen::MatrixXd& x,
                               const SoundNumber& as,
                               std::uint32_t rate) {
  const std::string data = sound_frames(x, as);
  std::string format = wav_format(x, as, rate);
  format.replace(0, 2, number_bytes(0xFFFE, 2, false));
  format += number_bytes(22, 2, false) +
            number_bytes(static_cast<std::uint64_t>(as.bits), 2, false) +
            number_bytes(0, 4, false) +
            number_bytes(as.is_float ? 3 : 1, 2, false) +
            std::string(
                "\x00\x00\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B"
                "\x71",
                14);
  return "RIFF" + number_bytes(60 + data.size(), 4, false) + "WAVEfmt " +
         number_bytes(format.size(), 4, false) + format + "data" +
         number_bytes(data.size(), 4, false) + data;
}

/// Lengths of 64 bits in a chunk `ds64`.
inline std::string rf64_bytes(const Eigen::MatrixXd& x,
                              const SoundNumber& as,
                              std::uint32_t rate) {
  const std::string data = sound_frames(x, as);
  return "RF64" + number_bytes(0xFFFFFFFF, 4, false) + "WAVEds64" +
         number_bytes(28, 4, false) + number_bytes(72 + data.size(), 8, false) +
         number_bytes(data.size(), 8, false) +
         number_bytes(static_cast<std::uint64_t>(x.rows()), 8, false) +
         number_bytes(0, 4, false) + "fmt " + number_bytes(16, 4, false) +
         wav_format(x, as, rate) + "data" + number_bytes(0xFFFFFFFF, 4, false) +
         data;
}

/// Sony Wave64: names are GUIDs, lengths take them in.
inline std::string w64_bytes(const Eigen::MatrixXd& x,
                             const SoundNumber& as,
                             std::uint32_t rate) {
  const std::string tail("\xF3\xAC\xD3\x11\x8C\xD1\x00\xC0\x4F\x8E\xDB\x8A",
                         12);
  const std::string riff("riff\x2E\x91\xCF\x11\xA5\xD6\x28\xDB\x04\xC1\x00\x00",
                         16);
  const std::string data = sound_frames(x, as);
  const std::string rest = "wave" + tail + "fmt " + tail +
                           number_bytes(24 + 16, 8, false) +
                           wav_format(x, as, rate) + "data" + tail +
                           number_bytes(24 + data.size(), 8, false) + data;
  return riff + number_bytes(24 + rest.size(), 8, false) + rest;
}

/// AIFF, or AIFF-C where numbers are floating point.
inline std::string aiff_bytes(const Eigen::MatrixXd& x,
                              SoundNumber as,
                              std::uint32_t rate) {
  as.big_endian = true;
  const std::string data = sound_frames(x, as);
  // The rate in 80 bits: exponent and a mantissa with its leading one.
  const int exponent = std::bit_width(rate) - 1;
  const std::string extended =
      number_bytes(static_cast<std::uint64_t>(16383 + exponent), 2, true) +
      number_bytes(std::uint64_t{rate} << (63 - exponent), 8, true);
  std::string common =
      number_bytes(static_cast<std::uint64_t>(x.cols()), 2, true) +
      number_bytes(static_cast<std::uint64_t>(x.rows()), 4, true) +
      number_bytes(static_cast<std::uint64_t>(as.bits), 2, true) + extended;
  if (as.is_float) {
    common += as.bits == 32 ? "fl32" : "fl64";
    common += std::string("\x00\x00", 2);
  }
  const std::string body =
      std::string(as.is_float ? "AIFCFVER" : "AIFF") +
      (as.is_float
           ? number_bytes(4, 4, true) + number_bytes(0xA2805140, 4, true)
           : "") +
      "COMM" + number_bytes(common.size(), 4, true) + common + "SSND" +
      number_bytes(8 + data.size(), 4, true) + std::string(8, '\0') + data;
  return "FORM" + number_bytes(body.size(), 4, true) + body;
}

/// Apple's Core Audio Format, numbers of either order.
inline std::string caf_bytes(const Eigen::MatrixXd& x,
                             const SoundNumber& as,
                             std::uint32_t rate) {
  const std::string data = sound_frames(x, as);
  const auto channels = static_cast<std::uint64_t>(x.cols());
  const std::uint64_t flags =
      (as.is_float ? 1U : 0U) | (as.big_endian ? 0U : 2U);
  return "caff" + number_bytes(1, 2, true) + number_bytes(0, 2, true) + "desc" +
         number_bytes(32, 8, true) +
         number_bytes(
             std::bit_cast<std::uint64_t>(static_cast<double>(rate)), 8, true) +
         "lpcm" + number_bytes(flags, 4, true) +
         number_bytes(
             channels * static_cast<std::uint64_t>(as.bits / 8), 4, true) +
         number_bytes(1, 4, true) + number_bytes(channels, 4, true) +
         number_bytes(static_cast<std::uint64_t>(as.bits), 4, true) + "data" +
         number_bytes(4 + data.size(), 8, true) + number_bytes(0, 4, true) +
         data;
}

}  // namespace tapfit::testing
