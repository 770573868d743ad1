// The matrices of a real bridge's model, through Matrix Market.
#include "tests/updating/support/mat_file.hpp"
#include "tests/updating/support/matrix_text.hpp"
#include "updating/structure/assembly/assemble.hpp"

namespace tapfit::structure {
namespace {

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
  const Deck deck =
      read_matrix_model(write_text("K.mtx", matrix_market(K)),
                        write_text("M.mtx", matrix_market(file.at("M0"))),
                        write_text("dofs.csv", dofs));
  const System system = assemble(deck);
  const std::vector<int> free = system.free_dofs();
  ASSERT_EQ(free.size(), 946U);
  const Eigen::VectorXd f =
      eigenmodes(extract(system.K, free), extract(system.M, free), 5)
          .frequency_hz;
  const std::vector<double> published{4.660, 4.875, 6.654, 9.901, 11.381};
  for (std::size_t i = 0; i < published.size(); ++i) {
    // Printed to three decimals.
    EXPECT_NEAR(f(static_cast<Eigen::Index>(i)), published[i], 6e-4);
  }
}

}  // namespace
}  // namespace tapfit::structure
