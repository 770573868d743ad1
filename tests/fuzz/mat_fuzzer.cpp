#include "acquisition/readers/mat_file.hpp"
#include "tests/fuzz/fuzz_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return tapfit::fuzz::read_as("data.mat", data, size, [](const auto& file) {
    (void)tapfit::acquisition::read_mat_arrays(file);
  });
}
