// A stiffness written as DMIG comes back as it was.
#include "updating/structure/edit/direct_matrix.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <gtest/gtest.h>

namespace tapfit::structure {
namespace {

constexpr const char* deck_text =
    "SOL 103\nCEND\nBEGIN BULK\n"
    "GRID,1,,0.,0.,0.\nGRID,2,,0.2,0.,0.\nGRID,7,,0.4,0.,0.\n"
    "CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,7,0.,0.,1.\n"
    "PBAR,1,1,2.4-4,1.28-9,1.8-8,4.3-9\nMAT1,1,2.1+11,,0.3,7850.\n"
    "SPC1,1,123456,1\n";

std::string with(const std::vector<std::string>& cards) {
  std::string text = deck_text;
  for (const std::string& card : cards) text += card + "\n";
  return text + "ENDDATA\n";
}

Eigen::MatrixXd some_stiffness() {
  Eigen::MatrixXd half = Eigen::MatrixXd::Zero(18, 4);
  half.col(0) << 0, 0, 3, 0, -1, 0, 0, 0, -3, 0, -2, 0, 0, 0, 0, 0, 0, 0;
  half.col(1) << 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0, -2, 0, 0, 0, 0.5;
  half.col(2)(14) = 7.0;
  return 1e3 * half * half.transpose();
}

TEST(DirectMatrix, IsReadBack) {
  const Deck deck = deck_of(with({}));
  const Eigen::MatrixXd K = some_stiffness();
  const std::vector<std::string> cards =
      direct_stiffness_cards(deck, "K2GG", sparse(K));
  ASSERT_GT(cards.size(), 1U);
  const Deck read = deck_of(with(cards));
  const Eigen::MatrixXd added = assemble(read).K - assemble(deck).K;
  // Numbers of 7 digits.
  EXPECT_LT((added - K).norm(), 1e-6 * K.norm());
}

TEST(DirectMatrix, IsInTheUnitsOfTheFile) {
  Deck deck = deck_of(with({}));
  deck.file_length_m = 1e-3;
  deck.file_mass_kg = 1e3;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(18, 18);
  K(8, 8) = 5e3;    // N/m: 5 N/mm
  K(10, 10) = 2.0;  // N m: 2000 N mm
  const auto cards = direct_stiffness_cards(deck, "K2GG", sparse(K));
  ASSERT_EQ(cards.size(), 3U);
  EXPECT_EQ(cards[1], "DMIG,K2GG,2,3,,2,3,5.000000");
  EXPECT_EQ(cards[2], "DMIG,K2GG,2,5,,2,5,2000.000");
}

TEST(DirectMatrix, GridsWithAxesOfTheirOwnAreLeft) {
  Deck deck = deck_of(with({}));
  deck.grids[1].axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_TRUE(
      direct_stiffness_cards(deck, "K2GG", sparse(some_stiffness())).empty());
}

TEST(DirectMatrix, IsNamedInTheCaseControlOnce) {
  const auto named = [](const std::vector<std::string>& lines) {
    EditedDeck deck{lines, {}};
    name_direct_stiffness("K2GG", deck);
    return deck.text();
  };
  const std::vector<std::string> once =
      named({"SOL 103", "CEND", "BEGIN BULK", "ENDDATA"});
  ASSERT_EQ(once.size(), 5U);
  EXPECT_EQ(once[2], "K2GG = K2GG");
  EXPECT_EQ(named(once), once);
  // Beside what the deck takes itself.
  const std::vector<std::string> beside =
      named({"CEND", "K2GG = KX", "BEGIN BULK", "ENDDATA"});
  EXPECT_EQ(beside[1], "K2GG = KX,K2GG");
  EXPECT_EQ(named(beside), beside);
}

}  // namespace
}  // namespace tapfit::structure
