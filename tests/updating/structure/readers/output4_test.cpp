// OUTPUT4 as text: dense columns, strings of both kinds, against the matrix.
#include "updating/structure/readers/output4.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace tapfit::structure {
namespace {

const std::string dense =
    "       2       2       6       2KAA     1P,3E23.16\n"
    "       1       1       2\n"
    " 2.0000000000000000E+00-1.0000000000000000E+00\n"
    "       2       1       2\n"
    "-1.0000000000000000E+00 3.0000000000000000E+00\n"
    "       3       1       1\n"
    " 1.0000000000000000E+00\n";
// Row and length in one number: 1 + 65536 * 3.
const std::string strings =
    "       2       2       6       2MAA     1P,3E23.16\n"
    "       1       0       3\n"
    "  196609\n"
    " 4.0000000000000000E+00\n"
    "       2       0       3\n"
    "       3       2\n"
    " 5.0000000000000000E+00\n"
    "       3       1       1\n"
    " 1.0000000000000000E+00\n";

TEST(Output4, DenseAndSparseColumns) {
  const std::filesystem::path both = write_text("km.op4", dense + strings);
  ASSERT_TRUE(is_output4(both));
  Eigen::Matrix2d K;
  K << 2, -1, -1, 3;
  Eigen::Matrix2d M;
  M << 4, 0, 0, 5;
  EXPECT_EQ(Eigen::Matrix2d(read_output4(both, 'K')), K);
  EXPECT_EQ(Eigen::Matrix2d(read_output4(both, 'M')), M);
  const Deck deck = read_matrix_model(
      both, both, write_text("dofs.csv", "1,X,0,0,0\n2,X,1,0,0\n"));
  EXPECT_EQ(deck.given->K.coeff(0, 6), -1.0);
  EXPECT_EQ(deck.given->M.coeff(6, 6), 5.0);
}

// Bytes as Fortran writes them, by the format's definition.
class BinaryOp4 {
 public:
  explicit BinaryOp4(bool big) : big_(big) {}

  template <typename Number>
  BinaryOp4& add(Number number) {
    std::array<char, sizeof number> raw{};
    std::memcpy(raw.data(), &number, raw.size());
    if (big_ == (std::endian::native == std::endian::little)) {
      std::ranges::reverse(raw);
    }
    record_.append(raw.begin(), raw.end());
    return *this;
  }
  BinaryOp4& name(const std::string& text) {
    record_ += text;
    return *this;
  }
  void end() {
    const std::string record = std::exchange(record_, "");
    const auto length = static_cast<std::int32_t>(record.size());
    text += std::exchange(add(length).record_, "") + record;
    text += std::exchange(add(length).record_, "");
  }
  void head(std::int32_t rows, std::int32_t type, const std::string& text8) {
    add(2).add(rows).add(6).add(type).name(text8).end();
  }

  std::string text;

 private:
  bool big_;
  std::string record_;
};

// Dense doubles, strings of single numbers with one word and with two.
TEST(Output4, BinaryOfBothOrdersOfBytes) {
  Eigen::Matrix2d K;
  K << 2, -1, -1, 3;
  Eigen::Matrix2d M;
  M << 4, 0, 0, 5;
  for (const bool big : {false, true}) {
    BinaryOp4 file(big);
    file.head(2, 2, "KAA     ");
    file.add(1).add(1).add(4).add(2.0).add(-1.0).end();
    file.add(2).add(1).add(4).add(-1.0).add(3.0).end();
    file.add(3).add(1).add(2).add(1.0).end();
    for (const bool wide : {false, true}) {
      file.head(wide ? -2 : 2, 1, "MAA     ");
      for (const std::int32_t k : {1, 2}) {
        file.add(k).add(0).add(wide ? 3 : 2);
        if (wide) {
          file.add(2).add(k);
        } else {
          file.add(k + 65536 * 2);
        }
        file.add(3.0F + static_cast<float>(k)).end();
      }
      file.add(3).add(1).add(1).add(1.0F).end();
      const std::filesystem::path path = write_text("km.op4", file.text);
      ASSERT_TRUE(is_output4(path));
      EXPECT_EQ(Eigen::Matrix2d(read_output4(path, 'K')), K);
      EXPECT_EQ(Eigen::Matrix2d(read_output4(path, 'M')), M);
      // What is cut off is no matrix.
      const auto cut =
          write_text("cut.op4", file.text.substr(0, file.text.size() / 3));
      EXPECT_THROW(static_cast<void>(read_output4(cut, 'M')), InputError);
      // The next round has this one's mass alone.
      file.text.resize(file.text.find("MAA") - 20);
    }
  }
}

TEST(Output4, FaultsAreNamed) {
  const auto expect = [](const std::string& text, const std::string& what) {
    EXPECT_THAT(
        [&] {
          static_cast<void>(read_output4(write_text("bad.op4", text), 'K'));
        },
        Throws<InputError>(
            AllOf(Property(&InputError::what, HasSubstr(what)),
                  Property(&InputError::where, HasSubstr("bad.op4")))))
        << what;
  };
  expect(dense.substr(0, dense.find("       2       1")), "ends too soon");
  expect("       2       3       2       2KAA     1P,3E23.16\n", "no square");
  expect("       2       2       6       4KAA     1P,3E23.16\n", "complex");
  expect(strings + "       1" + strings.substr(8), "no square");
}

}  // namespace
}  // namespace tapfit::structure
