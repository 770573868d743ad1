#include "tests/fuzz/fuzz_file.hpp"
#include "updating/session/saved_session.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return tapfit::fuzz::read_as(
      "session.json", data, size, [](const auto& file) {
        (void)tapfit::updating::read_saved_session(file);
      });
}
