#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "tests/fuzz/fuzz_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return tapfit::fuzz::read_as("test.json", data, size, [](const auto& file) {
    (void)tapfit::acquisition::read_test_bundle(file.parent_path());
  });
}
