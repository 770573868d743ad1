// The matrices of a real bridge's model, through Matrix Market.
#include "tests/updating/structure/deck_support.hpp"
#include "tests/updating/structure/mat_file.hpp"
#include "updating/structure/matrix_market.hpp"

namespace tapfit::structure {
namespace {

std::string matrix_market(const Eigen::MatrixXd& A) {
  std::string entries;
  int count = 0;
  for (Eigen::Index j = 0; j < A.cols(); ++j) {
    for (Eigen::Index i = j; i < A.rows(); ++i) {
      if (A(i, j) == 0.0) continue;
      entries += fmt::format("{} {} {}\n", i + 1, j + 1, A(i, j));
      ++count;
    }
  }
  return fmt::format(
      "%%MatrixMarket matrix coordinate real symmetric\n{} {} {}\n{}",
      A.rows(),
      A.cols(),
      count,
      entries);
}

TEST(PedestrianBridge, HasItsAuthorsFrequencies) {
  const std::filesystem::path path = TAPFIT_SOURCE_DIR
      "/../shared/data/pedestrian-bridge/SteelPedestrianBridgeExp.mat";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const MatFile file(path);
  const Eigen::MatrixXd& K = file.at("K_whole");
  std::string dofs;
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    dofs += fmt::format("{},Z\n", i + 1);
  }
  const MatrixModel model =
      read_matrix_system(write_text("K.mtx", matrix_market(K)),
                         write_text("M.mtx", matrix_market(file.at("M0"))),
                         write_text("dofs.csv", dofs));
  const std::vector<int> free = model.system.free_dofs();
  ASSERT_EQ(free.size(), 946U);
  const Eigen::VectorXd f =
      eigenmodes(
          extract(model.system.K, free), extract(model.system.M, free), 5)
          .frequency_hz;
  const std::vector<double> published{4.660, 4.875, 6.654, 9.901, 11.381};
  for (std::size_t i = 0; i < published.size(); ++i) {
    // Printed to three decimals.
    EXPECT_NEAR(f(static_cast<Eigen::Index>(i)), published[i], 6e-4);
  }
}

}  // namespace
}  // namespace tapfit::structure
