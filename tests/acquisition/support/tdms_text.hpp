// TDMS files byte by byte, for tests: segments of a lead-in of 28 bytes,
// metadata, and raw values.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace tapfit::testing {

/// Puts numbers and texts together in one byte order.
class TdmsBytes {
 public:
  explicit TdmsBytes(bool big = false) : big_(big) {}

  template <class Number>
  TdmsBytes& add(Number number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    if (big_ == (std::endian::native == std::endian::little)) {
      std::reverse(bytes.begin(), bytes.end());
    }
    text_ += bytes;
    return *this;
  }
  TdmsBytes& add(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    text_ += text;
    return *this;
  }
  TdmsBytes& raw(const std::string& bytes) {
    text_ += bytes;
    return *this;
  }

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool big() const { return big_; }

 private:
  bool big_;
  std::string text_;
};

/// Contents of a segment.
enum TdmsContents : std::uint32_t {
  TdmsMetadata = 2,
  TdmsNewList = 4,
  TdmsRawData = 8,
  TdmsInterleaved = 32,
  TdmsBigEndian = 64,
  TdmsDaqmx = 128
};

/// An object of the metadata: no raw values, the same as before, or `count`
/// values of a type in each chunk.
inline void tdms_object(TdmsBytes& bytes, const std::string& path) {
  bytes.add(path).add(std::uint32_t{0xffffffff});
}
inline void tdms_object_as_before(TdmsBytes& bytes, const std::string& path) {
  bytes.add(path).add(std::uint32_t{0});
}
inline void tdms_object(TdmsBytes& bytes,
                        const std::string& path,
                        std::uint32_t type,
                        std::uint64_t count) {
  bytes.add(path).add(std::uint32_t{20}).add(type).add(std::uint32_t{1});
  bytes.add(count);
}

inline void tdms_property(TdmsBytes& bytes,
                          const std::string& name,
                          const std::string& text) {
  bytes.add(name).add(std::uint32_t{0x20}).add(text);
}
inline void tdms_property(TdmsBytes& bytes,
                          const std::string& name,
                          double value) {
  bytes.add(name).add(std::uint32_t{10}).add(value);
}

inline std::string tdms_segment(std::uint32_t contents,
                                const TdmsBytes& metadata,
                                const TdmsBytes& raw) {
  TdmsBytes numbers(metadata.big());
  numbers.add(std::uint32_t{4713})
      .add(std::uint64_t{metadata.text().size() + raw.text().size()})
      .add(std::uint64_t{metadata.text().size()});
  if (metadata.big()) contents |= TdmsBigEndian;
  TdmsBytes mask;
  mask.add(contents);
  return "TDSm" + mask.text() + numbers.text() + metadata.text() + raw.text();
}

/// Hammer in N and accelerometer in g, doubles one channel after the other,
/// 2048 Hz.
inline std::string tdms_hammer_test(const std::vector<double>& force,
                                    const std::vector<double>& acceleration,
                                    bool big = false) {
  TdmsBytes metadata(big);
  metadata.add(std::uint32_t{4});
  tdms_object(metadata, "/");
  metadata.add(std::uint32_t{1});
  tdms_property(metadata, "title", "tap");
  tdms_object(metadata, "/'Run'");
  metadata.add(std::uint32_t{0});
  const auto channel =
      [&](const std::string& path, std::size_t count, const std::string& unit) {
        tdms_object(metadata, path, 10, count);
        metadata.add(std::uint32_t{2});
        tdms_property(metadata, "wf_increment", 1.0 / 2048.0);
        tdms_property(metadata, "unit_string", unit);
      };
  channel("/'Run'/'Hammer'", force.size(), "N");
  channel("/'Run'/'Acc 12Z+'", acceleration.size(), "g");
  TdmsBytes raw(big);
  for (const double value : force) raw.add(value);
  for (const double value : acceleration) raw.add(value);
  return tdms_segment(TdmsMetadata | TdmsNewList | TdmsRawData, metadata, raw);
}

}  // namespace tapfit::testing
