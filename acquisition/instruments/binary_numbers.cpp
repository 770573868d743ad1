#include "acquisition/instruments/binary_numbers.hpp"

#include <cstdint>

namespace tapfit::acquisition {
namespace {

// Calls `use` with a number of the type.
template <class Use>
auto with_number(NumberType type, Use use) {
  switch (type) {
    case NumberType::Int8:
      return use(std::int8_t{});
    case NumberType::Int16:
      return use(std::int16_t{});
    case NumberType::Int32:
      return use(std::int32_t{});
    case NumberType::Int64:
      return use(std::int64_t{});
    case NumberType::Uint8:
      return use(std::uint8_t{});
    case NumberType::Uint16:
      return use(std::uint16_t{});
    case NumberType::Uint32:
      return use(std::uint32_t{});
    case NumberType::Uint64:
      return use(std::uint64_t{});
    case NumberType::Float32:
      return use(float{});
    case NumberType::Float64:
      return use(double{});
  }
  return use(double{});
}

}  // namespace

std::size_t size_of(NumberType type) {
  return with_number(type, [](auto number) { return sizeof number; });
}

void decode(const char* bytes,
            std::size_t stride,
            NumberType type,
            ByteOrder order,
            std::size_t count,
            double* to) {
  with_number(type, [&](auto number) {
    for (std::size_t k = 0; k < count; ++k) {
      to[k] = static_cast<double>(
          number_at<decltype(number)>(bytes + k * stride, order));
    }
  });
}

}  // namespace tapfit::acquisition
