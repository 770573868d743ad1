// What is said of a clamped beam that was weighed, and of a mode that it has
// not.
#include "tests/updating/support/clamped_beam.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

bool says(const std::vector<std::string>& notes, const std::string& what) {
  return std::ranges::any_of(notes, [&what](const std::string& note) {
    return note.find(what) != std::string::npos;
  });
}

TEST(ModelWarnings, NameAnotherMassThanWasWeighed) {
  const std::vector<Dof> points = testing::beam_points();
  const double kg = 7850.0 * testing::beam_area;  // of 1 m
  for (const double share : {1.0, 1.03, 1.2, 1000.0}) {
    const tapfit::testing::TemporaryFolder folder;
    testing::write_modal_bundle(
        folder,
        testing::beam_text(),
        testing::clamped_beam(points),
        points,
        {},
        fmt::format(", \"weighed\": {{\"mass_kg\": {}}}", share * kg));
    Session session(folder.path());
    EXPECT_EQ(says(session.model_warnings(), "was weighed at"), share > 1.1)
        << share;
  }
}

TEST(ModelWarnings, NameAMeasuredModeThatTheModelHasNot) {
  const std::vector<Dof> points = testing::beam_points();
  testing::TrueModes truth = testing::clamped_beam(points);
  const tapfit::testing::TemporaryFolder folder;
  testing::write_modal_bundle(folder, testing::beam_text(), truth, points, {});
  EXPECT_TRUE(Session(folder.path()).comparison().pair_notes.empty());
  // Between the first two, with the shape of none.
  truth.hz.insert(truth.hz.begin() + 1, 12.0);
  Eigen::MatrixXd shape(truth.shape.rows(), truth.shape.cols() + 1);
  const Eigen::VectorXd odd =
      Eigen::VectorXd::Unit(truth.shape.rows(), 0).normalized();
  shape << truth.shape.col(0), odd, truth.shape.rightCols(4);
  truth.shape = shape;
  testing::write_modal_bundle(folder, testing::beam_text(), truth, points, {});
  EXPECT_TRUE(says(Session(folder.path()).comparison().pair_notes,
                   "no mode of the model is like measured mode 2"));
}

}  // namespace
}  // namespace tapfit::updating
