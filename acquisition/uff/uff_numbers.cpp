#include "acquisition/uff/uff_numbers.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace tapfit::acquisition {
namespace {

template <class Float, class Bits>
double from_bytes(const char* at, bool big_endian) {
  Bits bits = 0;
  for (std::size_t i = 0; i < sizeof(Bits); ++i) {
    const std::size_t place = big_endian ? sizeof(Bits) - 1 - i : i;
    bits |= static_cast<Bits>(
        static_cast<Bits>(static_cast<unsigned char>(at[i])) << (8 * place));
  }
  return static_cast<double>(std::bit_cast<Float>(bits));
}

}  // namespace

double uff_single(const char* at, bool big_endian) {
  return from_bytes<float, std::uint32_t>(at, big_endian);
}

double uff_double(const char* at, bool big_endian) {
  return from_bytes<double, std::uint64_t>(at, big_endian);
}

void take_uff_line(const UffDataset& dataset,
                   std::string_view line,
                   int number,
                   bool is_double,
                   std::vector<double>& values) {
  if (numbers(line, is_double ? 20 : 13, values)) return;
  throw InputError(fmt::format("\"{}\" is no line of numbers", line),
                   fmt::format("{}, data line {}", dataset.place, number),
                   "export the function anew");
}

InputError uff_cut_off(const UffDataset& dataset,
                       std::size_t there,
                       std::size_t wanted) {
  return {fmt::format("{} of {} numbers are there", there, wanted),
          dataset.place,
          "the file is cut off; export it anew"};
}

}  // namespace tapfit::acquisition
