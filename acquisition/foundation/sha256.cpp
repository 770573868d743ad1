#include "acquisition/foundation/sha256.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tapfit::acquisition {
namespace {

using Word = std::uint32_t;
using Hash = std::array<Word, 8>;
constexpr std::size_t block_bytes = 64;

struct HashConstants {
  Hash start{};
  std::array<Word, 64> rounds{};
};

/// The first 32 bits behind the point.
Word fraction_of(double root) {
  return static_cast<Word>((root - std::floor(root)) * 0x1p32);
}

/// Of the square roots of the first 8 primes and the cube roots of the first
/// 64.
HashConstants hash_constants() {
  HashConstants found;
  std::size_t count = 0;
  for (int n = 2; count < found.rounds.size(); ++n) {
    bool prime = true;
    for (int d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    if (!prime) continue;
    if (count < found.start.size()) {
      found.start[count] = fraction_of(std::sqrt(n));
    }
    found.rounds[count++] = fraction_of(std::cbrt(n));
  }
  return found;
}

/// The block's words, most significant byte first, and what follows from them.
std::array<Word, 64> schedule(std::string_view block) {
  std::array<Word, 64> w{};
  for (std::size_t k = 0; k < block_bytes; ++k) {
    w[k / 4] = (w[k / 4] << 8U) | static_cast<unsigned char>(block[k]);
  }
  for (std::size_t t = 16; t < w.size(); ++t) {
    const Word x = w[t - 15];
    const Word y = w[t - 2];
    w[t] = w[t - 16] + w[t - 7] +
           (std::rotr(x, 7) ^ std::rotr(x, 18) ^ (x >> 3U)) +
           (std::rotr(y, 17) ^ std::rotr(y, 19) ^ (y >> 10U));
  }
  return w;
}

void take_block(const HashConstants& constants,
                std::string_view block,
                Hash& hash) {
  const std::array<Word, 64> w = schedule(block);
  auto [a, b, c, d, e, f, g, h] = hash;
  for (std::size_t t = 0; t < w.size(); ++t) {
    const Word one = h +
                     (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                     ((e & f) ^ (~e & g)) + constants.rounds[t] + w[t];
    const Word two = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) +
                     ((a & b) ^ (a & c) ^ (b & c));
    h = g;
    g = f;
    f = e;
    e = d + one;
    d = c;
    c = b;
    b = a;
    a = one + two;
  }
  const Hash more{a, b, c, d, e, f, g, h};
  for (std::size_t k = 0; k < hash.size(); ++k) hash[k] += more[k];
}

/// The rest of the last block, a one bit, zeros, and the length in bits.
std::string padded_end(std::string_view bytes) {
  std::string end(bytes.substr(bytes.size() / block_bytes * block_bytes));
  end += '\x80';
  while (end.size() % block_bytes != block_bytes - 8) end += '\0';
  const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
  for (int shift = 56; shift >= 0; shift -= 8) {
    end += static_cast<char>((bits >> static_cast<unsigned>(shift)) & 0xFFU);
  }
  return end;
}

void take_blocks(const HashConstants& constants,
                 std::string_view bytes,
                 Hash& hash) {
  for (; bytes.size() >= block_bytes; bytes.remove_prefix(block_bytes)) {
    take_block(constants, bytes.substr(0, block_bytes), hash);
  }
}

}  // namespace

std::string sha256(std::string_view bytes) {
  const HashConstants constants = hash_constants();
  Hash hash = constants.start;
  take_blocks(constants, bytes, hash);
  take_blocks(constants, padded_end(bytes), hash);
  std::string text;
  for (const Word word : hash) text += fmt::format("{:08x}", word);
  return text;
}

}  // namespace tapfit::acquisition
