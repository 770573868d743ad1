// Samples as instruments store them, made doubles.
#pragma once

#include "acquisition/instruments/byte_cursor.hpp"

#include <cstddef>

namespace tapfit::acquisition {

enum class NumberType {
  Int8,
  Int16,
  Int32,
  Int64,
  Uint8,
  Uint16,
  Uint32,
  Uint64,
  Float32,
  Float64
};

/// Bytes of one number.
[[nodiscard]] std::size_t size_of(NumberType type);

/// @param bytes of the first number; `stride` bytes on is the next one
/// @param to `count` doubles
void decode(const char* bytes,
            std::size_t stride,
            NumberType type,
            ByteOrder order,
            std::size_t count,
            double* to);

}  // namespace tapfit::acquisition
