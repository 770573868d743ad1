#include "acquisition/instruments/byte_cursor.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

namespace tapfit::acquisition {

std::string_view ByteCursor::bytes(std::uint64_t count) {
  if (count > left()) {
    throw InputError(
        fmt::format(
            "ends early: {} bytes are announced, {} are there", count, left()),
        fmt::format("{}, byte {}", file_->string(), at_),
        "copy the file again, or save it anew");
  }
  const std::string_view taken =
      bytes_.substr(at_, static_cast<std::size_t>(count));
  at_ += taken.size();
  return taken;
}

void ByteCursor::go_to(std::uint64_t at) {
  at_ = 0;
  (void)bytes(at);
}

}  // namespace tapfit::acquisition
