// A short name for data: 128 bits that differ when the data do.
//
// MurmurHash3_x64_128. Two different data share it by chance once in 2^128; it
// does not withstand somebody who looks for such a pair, and has not to: the
// data are the user's own.
// Source: A. Appleby, SMHasher, MurmurHash3.cpp (public domain).
#pragma once

#include "updating/structure/solve/system.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::updating {

using Digest = std::array<std::uint64_t, 2>;

/// @param seed starts another, independent digest
[[nodiscard]] Digest digest_of(std::span<const std::byte> bytes,
                               std::uint32_t seed = 0);

/// 32 hexadecimal digits.
[[nodiscard]] std::string hexadecimal(const Digest& digest);

/// The digest of several things in their order. Each goes in by its own digest,
/// so that where one ends and the next begins counts too.
class ContentDigest {
 public:
  void add(std::string_view text);
  void add(double number);
  void add(const std::vector<int>& numbers);
  void add(const std::vector<bool>& flags);
  void add(const structure::SparseMatrix& matrix);  ///< compressed

  [[nodiscard]] Digest digest() const;

 private:
  template <class T>
  void add_items(std::span<const T> items);

  std::vector<Digest> parts_;
};

}  // namespace tapfit::updating
