// Tests of structures that exist only in memory, given by their modes: a plate
// that is clamped along one edge and narrows, so that no two of its grids are
// alike, and a beam.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "acquisition/foundation/seeded_random.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

struct PlateOptions {
  double e = 70e9;       ///< [Pa]
  double e_inner = 0.0;  ///< of the patch; 0: as elsewhere
  std::string clamp = "123456";
  std::vector<std::string> cards = {};  ///< besides
};

constexpr int plate_nx = 10;
constexpr int plate_ny = 5;

/// Grid in row i from the clamp, j across, from 0.
inline int plate_grid(int i, int j) { return 1 + i * (plate_ny + 1) + j; }

/// 0.5 m x 0.3 m x 3 mm of aluminium; the free end is 0.2 m wide. The patch are
/// the elements 13 and 14.
inline std::string plate_text(const PlateOptions& options) {
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= plate_nx; ++i) {
    for (int j = 0; j <= plate_ny; ++j) {
      const double x = 0.5 * i / plate_nx;
      const double y = (0.3 - 0.2 * x) * j / plate_ny;
      text +=
          fmt::format("GRID,{},,{:.5f},{:.5f},0.\n", plate_grid(i, j), x, y);
    }
  }
  int id = 0;
  for (int i = 0; i < plate_nx; ++i) {
    for (int j = 0; j < plate_ny; ++j) {
      ++id;
      const bool inner = options.e_inner > 0.0 && (id == 13 || id == 14);
      text += fmt::format("CQUAD4,{},{},{},{},{},{}\n",
                          id,
                          inner ? 2 : 1,
                          plate_grid(i, j),
                          plate_grid(i + 1, j),
                          plate_grid(i + 1, j + 1),
                          plate_grid(i, j + 1));
    }
  }
  text += "PSHELL,1,1,.003,1,,1\n";
  text += fmt::format("MAT1,1,{:.6e},,.33,2700.\n", options.e);
  if (options.e_inner > 0.0) {
    text += "PSHELL,2,2,.003,2,,2\n";
    text += fmt::format("MAT1,2,{:.6e},,.33,2700.\n", options.e_inner);
  }
  text += fmt::format(
      "SPC1,1,{},1,THRU,{}\n", options.clamp, plate_grid(0, plate_ny));
  for (const std::string& card : options.cards) text += card + "\n";
  return text + "ENDDATA\n";
}

/// 16 points all over the plate, across it.
inline std::vector<Dof> plate_points() {
  std::vector<Dof> points;
  for (const int i : {2, 5, 8, 10}) {
    for (const int j : {0, 2, 3, 5}) points.push_back({plate_grid(i, j), 3, 1});
  }
  return points;
}

struct TrueModes {
  std::vector<double> hz;
  Eigen::MatrixXd shape;  ///< points x modes, of unit length
};

/// Of the deck with every element split once, as the model is solved.
inline TrueModes true_modes(const std::string& deck_text,
                            const std::vector<Dof>& points,
                            int count) {
  const structure::Deck deck = structure::deck_of(deck_text);
  const structure::Deck fine = structure::refine_mesh(deck).deck;
  const structure::System system = structure::assemble(fine);
  const structure::FreeMotions motions = structure::free_motions(system);
  const structure::Eigenmodes modes = structure::eigenmodes(
      motions.reduce(system.K), motions.reduce(system.M), count);
  const Eigen::MatrixXd u = motions.expand(modes.phi);
  TrueModes result;
  result.shape.resize(static_cast<Eigen::Index>(points.size()), count);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto grid =
        static_cast<Eigen::Index>(fine.grid_index(points[k].node));
    result.shape.row(static_cast<Eigen::Index>(k)) =
        u.row(6 * grid + points[k].component - 1);
  }
  for (int r = 0; r < count; ++r) {
    result.hz.push_back(modes.frequency_hz(r));
    if (!points.empty()) result.shape.col(r).normalize();
  }
  return result;
}

struct Scatter {
  double frequency_percent = 0.1;
  double shape_percent = 2.0;  ///< of the root mean square
  unsigned seed = 1;
};

/// Writes model.bdf, modes.csv and test.json.
/// @param more fields of test.json, each with a comma in front
inline void write_modal_bundle(const tapfit::testing::TemporaryFolder& folder,
                               const std::string& model_text,
                               const TrueModes& truth,
                               const std::vector<Dof>& points,
                               const Scatter& scatter,
                               const std::string& more = "") {
  acquisition::SeededRandom random(scatter.seed, "modes");
  std::string csv = "frequency_hz,frequency_sd_percent,damping_percent";
  for (const Dof& dof : points) {
    csv += fmt::format(",{0},{0} sd", name(dof));
  }
  csv += "\n";
  const double sd = points.empty() ? 0.0
                                   : 0.01 * scatter.shape_percent /
                                         std::sqrt(double(points.size()));
  for (std::size_t r = 0; r < truth.hz.size(); ++r) {
    const double off = 0.01 * scatter.frequency_percent * random.normal();
    csv += fmt::format(
        "{:.8g},{},1.0", truth.hz[r] * (1.0 + off), scatter.frequency_percent);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double value = truth.shape(static_cast<Eigen::Index>(k),
                                       static_cast<Eigen::Index>(r));
      csv += fmt::format(",{:.8g},{:.8g}", value + sd * random.normal(), sd);
    }
    csv += "\n";
  }
  folder.write("modes.csv", csv);
  folder.write("model.bdf", model_text);
  folder.write("test.json",
               "{\"tapfit\": 1, \"model\": \"model.bdf\", "
               "\"modes\": \"modes.csv\"" +
                   more + "}");
}

}  // namespace tapfit::updating::testing
