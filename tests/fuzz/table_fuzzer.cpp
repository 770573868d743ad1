// CSV where the first byte is even, SEP-005 where it is odd.
#include "acquisition/import/read_time_table.hpp"
#include "tests/fuzz/fuzz_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0) return 0;
  const char* name = data[0] % 2 == 0 ? "data.csv" : "data.json";
  return tapfit::fuzz::read_as(name, data + 1, size - 1, [](const auto& file) {
    (void)tapfit::acquisition::read_time_table(file, {"h", "2"}, {});
  });
}
