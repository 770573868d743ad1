#include "modal/mode_set/uff55.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"

#include <sstream>

namespace tapfit::modal {
namespace {

ModeSet one_mode() {
  ModeSet set;
  set.dofs = {{4, 3, 1}, {9, 1, 1}, {9, 3, 1}};
  set.scaled = true;
  Mode mode;
  mode.pole = {-2.0, 125.0};
  mode.frequency_hz = 19.9;
  mode.damping_ratio = 0.016;
  mode.shape.resize(3);
  mode.shape << std::complex<double>(0.5, 0.25), -1.5, 2.0;
  set.modes.push_back(mode);
  return set;
}

TEST(Uff55, HasItsNumbersInTheColumnsOfTheFormat) {
  const std::string text = modes_as_uff(one_mode(), "A plate");
  const std::size_t start = text.find("    -1\n    55\n");
  ASSERT_NE(start, std::string::npos);
  std::istringstream lines(text.substr(start));
  std::vector<std::string> line;
  for (std::string next; std::getline(lines, next);) line.push_back(next);
  ASSERT_EQ(line.size(), 15U);
  EXPECT_EQ(line[2], "A plate");
  EXPECT_EQ(line[7],
            "         1         3         2         8         5         3");
  EXPECT_EQ(line[8], "         2         6         1         1");
  EXPECT_EQ(line[9].substr(0, 26), " -2.00000E+00  1.25000E+02");
  EXPECT_EQ(line[10], "         4");
  EXPECT_EQ(line[11].substr(52), "  5.00000E-01  2.50000E-01");
  EXPECT_EQ(line[12], "         9");
  EXPECT_EQ(line[13].substr(0, 13), " -1.50000E+00");
  EXPECT_EQ(line[14], "    -1");
}

TEST(Uff55, ModalBIsMinusPoleTimesModalA) {
  const std::string text = modes_as_uff(one_mode(), "A plate");
  // a = 250 j, b = -(-2 + 125 j) 250 j = 31250 + 500 j
  EXPECT_THAT(
      text, HasSubstr("  0.00000E+00  2.50000E+02  3.12500E+04  5.00000E+02"));
}

TEST(Uff55, SaysWhenItCannotBeWritten) {
  EXPECT_THROW(
      write_modes_uff(one_mode(), "A plate", "/nonexistent-folder/x.uff", {}),
      InputError);
}

}  // namespace
}  // namespace tapfit::modal
