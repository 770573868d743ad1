#include "updating/cache/content_digest.hpp"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstring>

namespace tapfit::updating {
namespace {

constexpr std::uint64_t c1 = 0x87c37b91114253d5ULL;
constexpr std::uint64_t c2 = 0x4cf5ad432745937fULL;
constexpr std::size_t block = 16;

std::uint64_t scramble_one(std::uint64_t k) {
  return std::rotl(k * c1, 31) * c2;
}

std::uint64_t scramble_two(std::uint64_t k) {
  return std::rotl(k * c2, 33) * c1;
}

// Every bit of k moves half of the result's.
std::uint64_t avalanche(std::uint64_t k) {
  k = (k ^ (k >> 33U)) * 0xff51afd7ed558ccdULL;
  k = (k ^ (k >> 33U)) * 0xc4ceb9fe1a85ec53ULL;
  return k ^ (k >> 33U);
}

}  // namespace

Digest digest_of(std::span<const std::byte> bytes, std::uint32_t seed) {
  std::uint64_t h1 = seed;
  std::uint64_t h2 = seed;
  std::array<std::uint64_t, 2> k{};
  std::size_t at = 0;
  for (; at + block <= bytes.size(); at += block) {
    std::memcpy(k.data(), &bytes[at], block);
    h1 = (std::rotl(h1 ^ scramble_one(k[0]), 27) + h2) * 5 + 0x52dce729;
    h2 = (std::rotl(h2 ^ scramble_two(k[1]), 31) + h1) * 5 + 0x38495ab5;
  }
  k = {};
  if (at < bytes.size()) std::memcpy(k.data(), &bytes[at], bytes.size() - at);
  h2 ^= scramble_two(k[1]);
  h1 ^= scramble_one(k[0]);
  h1 ^= bytes.size();
  h2 ^= bytes.size();
  h1 += h2;
  h2 += h1;
  h1 = avalanche(h1);
  h2 = avalanche(h2);
  h1 += h2;
  h2 += h1;
  return {h1, h2};
}

std::string hexadecimal(const Digest& digest) {
  return fmt::format("{:016x}{:016x}", digest[0], digest[1]);
}

template <class T>
void ContentDigest::add_items(std::span<const T> items) {
  parts_.push_back(digest_of(std::as_bytes(items)));
}

void ContentDigest::add(std::string_view text) {
  add_items(std::span<const char>(text));
}

void ContentDigest::add(double number) {
  add_items(std::span<const double>(&number, 1));
}

void ContentDigest::add(const std::vector<int>& numbers) {
  add_items(std::span<const int>(numbers));
}

void ContentDigest::add(const std::vector<bool>& flags) {
  add(std::vector<int>(flags.begin(), flags.end()));
}

void ContentDigest::add(const structure::SparseMatrix& matrix) {
  assert(matrix.isCompressed());
  const auto count = static_cast<std::size_t>(matrix.nonZeros());
  const auto outer = static_cast<std::size_t>(matrix.outerSize()) + 1;
  add_items(std::span<const int>(matrix.outerIndexPtr(), outer));
  add_items(std::span<const int>(matrix.innerIndexPtr(), count));
  add_items(std::span<const double>(matrix.valuePtr(), count));
}

Digest ContentDigest::digest() const {
  return digest_of(std::as_bytes(std::span<const Digest>(parts_)));
}

}  // namespace tapfit::updating
