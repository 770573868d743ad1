// Modes as JSON, table or universal file, by the first byte.
#include "modal/mode_set/read_modes_file.hpp"
#include "tests/fuzz/fuzz_file.hpp"

#include <array>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  constexpr std::array names = {"modes.json", "modes.csv", "modes.uff"};
  if (size == 0) return 0;
  const char* name = names.at(data[0] % names.size());
  return tapfit::fuzz::read_as(name, data + 1, size - 1, [](const auto& file) {
    const auto set = tapfit::modal::read_modes_file(file);
    tapfit::modal::check_measured(set, file.string());
  });
}
