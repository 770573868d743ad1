// Damaged files: copies of good ones with bytes changed, cut, doubled or
// exchanged for numbers that readers trip over.
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace tapfit::testing {

/// One to six random changes of a text.
inline std::string mutated(std::string text, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  static const std::array<std::string, 10> awkward{"-1",
                                                   "nan",
                                                   "1e999",
                                                   "99999999999",
                                                   "-2147483648",
                                                   "\n",
                                                   "    -1\n",
                                                   std::string(4, '\xff'),
                                                   std::string(4, '\0'),
                                                   "\x7f\xff\xff\xff"};
  for (std::size_t k = 1 + below(6); k > 0 && !text.empty(); --k) {
    const std::size_t at = below(text.size());
    const std::size_t length = std::min(text.size() - at, 1 + below(40));
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, text.substr(at, length));
        break;
      case 3:
        text.resize(at);
        break;
      default: {
        const std::string& number = awkward[below(awkward.size())];
        text.replace(at, std::min(length, number.size()), number);
      }
    }
  }
  return text;
}

/// How often to try: TAPFIT_FUZZ_ROUNDS times, or a few where it is not set.
inline int fuzz_rounds(int usual) {
  const char* asked = std::getenv("TAPFIT_FUZZ_ROUNDS");
  return asked == nullptr ? usual : std::atoi(asked);
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace tapfit::testing
