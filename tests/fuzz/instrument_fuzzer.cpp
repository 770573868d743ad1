// TDMS, numpy's arrays and archives, HDF5: told apart by how they begin.
#include "acquisition/instruments/instrument_file.hpp"
#include "tests/fuzz/fuzz_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  return tapfit::fuzz::read_as("data", data, size, [](const auto& file) {
    if (!tapfit::acquisition::is_instrument_file(file)) return;
    (void)tapfit::acquisition::read_instrument_file(file);
  });
}
