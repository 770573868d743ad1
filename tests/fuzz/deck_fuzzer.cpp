// Nastran bulk data where the first byte is even, a deck of Abaqus or CalculiX
// where it is odd.
#include "tests/fuzz/fuzz_file.hpp"
#include "updating/structure/deck/deck.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0) return 0;
  const char* name = data[0] % 2 == 0 ? "model.bdf" : "model.inp";
  return tapfit::fuzz::read_as(name, data + 1, size - 1, [](const auto& file) {
    (void)tapfit::structure::read_deck(file);
  });
}
