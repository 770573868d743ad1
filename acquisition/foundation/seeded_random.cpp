#include "acquisition/foundation/seeded_random.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

// FNV-1a, 64 bit: Fowler, Noll and Vo.
std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  for (int byte = 0; byte < 8; ++byte) {
    hash ^= (value >> (8 * byte)) & 0xffU;
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

SeededRandom::SeededRandom(std::uint64_t seed,
                           std::string_view purpose,
                           std::uint64_t index) {
  std::uint64_t hash = mix(0xcbf29ce484222325ULL, seed);
  for (const char letter : purpose) {
    hash = mix(hash, static_cast<unsigned char>(letter));
  }
  engine_.seed(mix(hash, index));
}

double SeededRandom::uniform(double low, double high) {
  const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
  return low + (high - low) * unit;
}

double SeededRandom::normal() {
  if (spare_) {
    const double value = *spare_;
    spare_.reset();
    return value;
  }
  double u = 0.0;
  double v = 0.0;
  double s = 0.0;
  do {
    u = uniform(-1.0, 1.0);
    v = uniform(-1.0, 1.0);
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = v * scale;
  return u * scale;
}

double SeededRandom::scatter(double sd) {
  return std::exp(sd * std::clamp(normal(), -2.5, 2.5));
}

}  // namespace tapfit::acquisition
