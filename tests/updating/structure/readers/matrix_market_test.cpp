#include "updating/structure/readers/matrix_market.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/readers/scale_units.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::structure {
namespace {

const std::string stiffness =
    "%%MatrixMarket matrix coordinate real symmetric\n% two springs\n"
    "2 2 3\n1 1 300.\n2 1 -100.\n2 2 100.\n";
const std::string mass =
    "%%MatrixMarket matrix array real general\n2 2\n2.\n0.\n0.\n1.\n";

TEST(MatrixMarket, PlacesRowsByTheTable) {
  const Deck deck = read_matrix_model(write_text("K.mtx", stiffness),
                                      write_text("M.mtx", mass),
                                      write_text("dofs.csv",
                                                 "node,component,x,y,z\n"
                                                 "7,Z,0.1,0,0\n3,3,0.2,0,0\n"));
  EXPECT_EQ(deck.grids[0].id, 7);
  EXPECT_EQ(deck.grids[1].position.x(), 0.2);
  const System system = assemble(deck);
  EXPECT_EQ(system.K.coeff(8, 2), -100.0);
  const std::vector<int> free = system.free_dofs();
  EXPECT_EQ(free, (std::vector<int>{2, 8}));
  const Eigen::VectorXd f =
      eigenmodes(extract(system.K, free), extract(system.M, free), 2)
          .frequency_hz;
  // det(K - l M) = 2 l^2 - 500 l + 20000.
  EXPECT_NEAR(f(0), std::sqrt(50.0) / (2 * M_PI), 1e-9);
  EXPECT_NEAR(f(1), std::sqrt(200.0) / (2 * M_PI), 1e-9);
}

// x, y of a structure in a plane; once for a node is enough.
TEST(MatrixMarket, TakesWhatCoordinatesThereAre) {
  const auto read = [](const std::string& table) {
    return read_matrix_model(write_text("K.mtx", stiffness),
                             write_text("M.mtx", mass),
                             write_text("dofs.csv", table));
  };
  const Deck plane = read("node,component,x,y\n7,Z,0.1,0.3\n3,3,0.2,0.4\n");
  EXPECT_EQ(plane.grids[0].position, Eigen::Vector3d(0.1, 0.3, 0.0));
  EXPECT_EQ(plane.grids[1].position, Eigen::Vector3d(0.2, 0.4, 0.0));
  const Deck once = read("7,X\n7,Y,0.1,0.3,0.2\n");
  ASSERT_EQ(once.grids.size(), 1U);
  EXPECT_EQ(once.grids[0].position, Eigen::Vector3d(0.1, 0.3, 0.2));
  EXPECT_EQ(read("7,X,,,\n3,Y,,,\n").grids[0].position.norm(), 0.0);
  EXPECT_THROW(read("7,X,0,0,0\n7,Y,0,0,1\n"), InputError);
  EXPECT_THROW(read("7,X,0,0,0,1\n3,X,0,0,0\n"), InputError);
}

TEST(MatrixMarket, IsNoDeck) {
  try {
    static_cast<void>(read_deck(write_text("K.mtx", stiffness)));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_THAT(what, HasSubstr("not a Nastran deck"));
    EXPECT_THAT(what, HasSubstr("\"stiffness\""));
  }
}

// The same two springs in millimetres and tonnes, one of them against a turn.
TEST(MatrixMarket, IsScaledToSi) {
  const std::filesystem::path table = write_text("dofs.csv", "1,X\n1,RZ\n");
  const std::filesystem::path M = write_text("M.mtx", mass);
  Deck si =
      read_matrix_model(write_text("K.mtx",
                                   "%%MatrixMarket matrix array real general\n"
                                   "2 2\n300.\n-4.\n-4.\n0.5\n"),
                        M,
                        table);
  Deck mm =
      read_matrix_model(write_text("K_mm.mtx",
                                   "%%MatrixMarket matrix array real general\n"
                                   "2 2\n0.3\n-4.\n-4.\n500.\n"),
                        M,
                        table);
  scale_to_si(si, "SI");
  scale_to_si(mm, "mm-t-s");
  // Rounding.
  EXPECT_LT(
      (Eigen::MatrixXd(si.given->K) - Eigen::MatrixXd(mm.given->K)).norm(),
      1e-12 * 300.0);
  EXPECT_NEAR(mm.given->M.coeff(0, 0), 2.0 * 1e3, 1e-9);
  EXPECT_NEAR(mm.given->M.coeff(5, 5), 1.0 * 1e-3, 1e-15);
}

TEST(MatrixMarket, RefusesWhatItCannotUse) {
  const std::filesystem::path M = write_text("M.mtx", mass);
  const std::filesystem::path table = write_text("dofs.csv", "1,1\n1,2\n");
  const auto refused = [&](const std::string& text) {
    const std::filesystem::path K = write_text("K.mtx", text);
    EXPECT_THROW(static_cast<void>(read_matrix_model(K, M, table)), InputError)
        << text;
  };
  refused("not a matrix\n");
  refused("%%MatrixMarket matrix coordinate complex symmetric\n1 1 0\n");
  refused("%%MatrixMarket matrix coordinate real general\n2 3 0\n");
  refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n3 1 1.\n");
  refused("%%MatrixMarket matrix coordinate real general\n2 2 2\n1 1 1.\n");
  refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 1 nan\n");
  refused("%%MatrixMarket matrix coordinate real general\n2 2 1\n1 2 5.\n");
  refused("%%MatrixMarket matrix coordinate real general\n3 3 0\n");
  // Both triangles of a symmetric matrix; more entries than are counted; sizes
  // beyond all memory.
  refused(
      "%%MatrixMarket matrix coordinate real symmetric\n"
      "2 2 4\n1 1 3.\n2 1 -1.\n1 2 -1.\n2 2 1.\n");
  refused(
      "%%MatrixMarket matrix coordinate real symmetric\n"
      "2 2 1\n1 1 3.\n2 2 1.\n");
  refused("%%MatrixMarket matrix coordinate real general\n3+9 3+9 0\n");
  refused("%%MatrixMarket matrix array real general\n1+300 1+300\n");
  const std::filesystem::path K = write_text("K.mtx", stiffness);
  for (const char* bad : {"1,1\n1,1\n", "1,1\n", "1,1\n1,9\n", "1,1\nx,2\n"}) {
    EXPECT_THROW(
        static_cast<void>(read_matrix_model(K, M, write_text("dofs.csv", bad))),
        InputError)
        << bad;
  }
}

TEST(MatrixMarket, NamesTheRowBelowZero) {
  const std::filesystem::path K =
      write_text("K.mtx",
                 "%%MatrixMarket matrix coordinate real symmetric\n"
                 "2 2 2\n1 1 300.\n2 2 -5.\n");
  const std::filesystem::path M = write_text("M.mtx", mass);
  const std::filesystem::path table = write_text("dofs.csv", "7,1\n9,2\n");
  EXPECT_THAT(
      [&] { static_cast<void>(read_matrix_model(K, M, table)); },
      Throws<InputError>(AllOf(
          Property(&InputError::where, "K.mtx"),
          Property(&InputError::what, HasSubstr("node 9, component 2")))));
}

TEST(ScaleUnits, MillimetresAndTonnesGiveTheSameFrequencies) {
  const auto elements = [](const std::string& offset) {
    return "CQUAD4,1,1,1,2,3,4\nCBAR,2,1,1,2,0.,0.,1.\n,,,0.,0.," + offset +
           "\nSPC1,1,123456,1\n";
  };
  const Deck si = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,.1,0.,0.\nGRID,3,,.1,.1,0.\n"
      "GRID,4,,0.,.1,0.\nPSHELL,1,1,.002,1,,1,,1.5\nMAT1,1,7.+10,,.3,2700.\n"
      "PBARL,1,1,,BAR\n,.01,.005\nCONM2,9,3,,.05,,,.01\n,1.-5,,1.-5,,,1.-5\n"
      "CELAS2,10,1.+5,4,3\nCELAS2,11,50.,4,4\n" +
      elements(".005"));
  Deck mm = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,100.,0.,0.\nGRID,3,,100.,100.,0.\n"
      "GRID,4,,0.,100.,0.\nPSHELL,1,1,2.,1,,1,,1.5-9\n"
      "MAT1,1,7.+4,,.3,2.7-9\n"
      "PBARL,1,1,,BAR\n,10.,5.\nCONM2,9,3,,5.-5,,,10.\n,1.-2,,1.-2,,,1.-2\n"
      "CELAS2,10,100.,4,3\nCELAS2,11,5.+4,4,4\n" +
      elements("5."));
  scale_to_si(mm, "mm-t-s");
  const Eigen::VectorXd a = modes_of(si, 8).frequency_hz;
  const Eigen::VectorXd b = modes_of(mm, 8).frequency_hz;
  EXPECT_LT((a - b).norm(), 1e-8 * a.norm());  // rounding
  EXPECT_NEAR(total_mass(mm, assemble(mm)), total_mass(si, assemble(si)), 1e-9);
  EXPECT_THROW(scale_to_si(mm, "inch"), InputError);
}

}  // namespace
}  // namespace tapfit::structure
