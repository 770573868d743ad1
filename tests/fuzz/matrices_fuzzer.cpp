// A matrix, Matrix Market or OUTPUT4, where the first byte is even, the table
// of its degrees of freedom where it is odd.
#include "tests/fuzz/fuzz_file.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <fstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  using namespace tapfit;
  if (size == 0) return 0;
  const std::filesystem::path unit = fuzz::folder() / "unit.mtx";
  std::ofstream(unit) << "%%MatrixMarket matrix coordinate real symmetric\n"
                         "2 2 2\n1 1 1.0\n2 2 1.0\n";
  const std::filesystem::path dofs = fuzz::folder() / "two.csv";
  std::ofstream(dofs) << "1,Z\n2,Z\n";
  const bool table = data[0] % 2 != 0;
  const char* name = table ? "dofs.csv" : "K.mtx";
  return fuzz::read_as(name, data + 1, size - 1, [&](const auto& file) {
    const auto& stiffness = table ? unit : file;
    (void)structure::read_matrix_model(stiffness, unit, table ? file : dofs);
  });
}
