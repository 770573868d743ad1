#include "updating/cache/content_digest.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

namespace tapfit::updating {
namespace {

// SMHasher's own check: keys {0}, {0,1}, ... with seeds 256, 255, ...; the
// digest of all these digests begins with the value its author publishes for
// MurmurHash3_x64_128.
TEST(ContentDigestTest, HasItsAuthorsVerificationValue) {
  std::vector<std::uint8_t> key(256);
  std::iota(key.begin(), key.end(), std::uint8_t{0});
  std::vector<Digest> digests;
  for (std::uint32_t length = 0; length < 256; ++length) {
    digests.push_back(
        digest_of(std::as_bytes(std::span(key).first(length)), 256 - length));
  }
  const Digest last = digest_of(std::as_bytes(std::span(digests)));
  EXPECT_EQ(last[0] & 0xffffffffU, 0x6384BA69U);
}

TEST(ContentDigestTest, KnowsWhereOneThingEndsAndTheNextBegins) {
  ContentDigest one;
  one.add("ab");
  one.add("c");
  ContentDigest other;
  other.add("a");
  other.add("bc");
  EXPECT_NE(one.digest(), other.digest());
  EXPECT_EQ(hexadecimal(one.digest()).size(), 32U);
}

TEST(ContentDigestTest, SeesTheLastBitOfAMatrixAndItsPlaces) {
  structure::SparseMatrix base(3, 3);
  base.insert(0, 0) = 1.0;
  base.insert(2, 1) = 2.0;
  base.makeCompressed();
  structure::SparseMatrix bit = base;
  bit.coeffRef(2, 1) = std::nextafter(2.0, 3.0);
  structure::SparseMatrix moved(3, 3);
  moved.insert(0, 0) = 1.0;
  moved.insert(1, 1) = 2.0;
  moved.makeCompressed();
  std::set<Digest> seen;
  for (const auto& matrix : {base, bit, moved}) {
    ContentDigest content;
    content.add(matrix);
    seen.insert(content.digest());
  }
  EXPECT_EQ(seen.size(), 3U);
}

}  // namespace
}  // namespace tapfit::updating
