// OUTPUT4 as text: dense columns, strings of both kinds, against the matrix.
#include "updating/structure/readers/output4.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <Eigen/Core>

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
