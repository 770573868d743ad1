#include "updating/measurement/named_grids.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/bundle/uff_points.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "updating/places/point_on_mesh.hpp"
#include "updating/places/rigid_fit.hpp"

#include <Eigen/Core>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

std::filesystem::path file_of_points(const acquisition::TestBundle& bundle) {
  if (bundle.frfs) return *bundle.frfs;
  return bundle.modes ? bundle.modes->file : std::filesystem::path();
}

// By which coordinates are off that are in mm, cm, inches or feet.
bool is_a_unit(double scale) {
  constexpr std::array<double, 4> units{1000.0, 100.0, 39.3701, 3.28084};
  constexpr double close = 0.01;
  return std::ranges::any_of(units, [scale](double unit) {
    return std::abs(scale * unit - 1.0) < close ||
           std::abs(scale / unit - 1.0) < close;
  });
}

// What the coordinates are to be multiplied by; 1 where they are in the model's
// unit, or in none.
double unit_of(const Matrix3Xd& points, const Matrix3Xd& grids) {
  if (points.cols() < 2) return 1.0;
  const double scale = fit_pairs(points, grids).scale;
  return is_a_unit(scale) ? scale : 1.0;
}

// The points as they lie in the model, so far as axes may be others.
Matrix3Xd in_the_model(const Matrix3Xd& scaled,
                       const Matrix3Xd& grids,
                       const MeshSurface& surface) {
  const bool few = scaled.cols() < 3 || on_a_line(scaled);
  if (few || as_they_are(scaled, surface)) return scaled;
  const RigidFit moved = fit_pairs(scaled, grids);
  return (moved.rotation * scaled).colwise() + moved.translation;
}

}  // namespace

void check_named_grids(const acquisition::TestBundle& bundle,
                       const std::set<int>& used,
                       structure::Deck& deck) {
  const std::filesystem::path file = file_of_points(bundle);
  if (bundle.geometry || file.empty() || !acquisition::is_uff(file)) return;
  const acquisition::UffFile uff = acquisition::open_uff(file);
  const acquisition::UffMesh mesh = uff.bytes.reading(
      [&uff] { return acquisition::read_uff_mesh(uff.datasets); });
  std::vector<int> labels;
  for (const int label : used) {
    if (mesh.geometry.nodes.contains(label) && deck.has_grid(label)) {
      labels.push_back(label);
    }
  }
  if (labels.empty()) return;
  const auto n = std::ssize(labels);
  Matrix3Xd points(3, n);
  Matrix3Xd grids(3, n);
  for (Index k = 0; k < n; ++k) {
    const int label = labels[static_cast<std::size_t>(k)];
    points.col(k) =
        mesh.length_m * acquisition::position_of(mesh.geometry, label);
    grids.col(k) = deck.grids[deck.grid_index(label)].position;
  }
  const MeshSurface surface(deck);
  const double unit = unit_of(points, grids);
  const Eigen::RowVectorXd off =
      (in_the_model(unit * points, grids, surface) - grids).colwise().norm();
  if (unit != 1.0) {
    deck.warnings.push_back(fmt::format(
        "{}: its coordinates are {:.4g} times the model's and count "
        "as another unit's; correct the unit of the file (dataset "
        "164), or \"units\" of the deck in test.json, where that "
        "is not so",
        file.filename().string(),
        1.0 / unit));
  }
  Index worst = 0;
  Index elsewhere = 0;
  for (Index k = 0; k < n; ++k) {
    const auto place = surface.nearest(grids.col(k));
    if (!place || place->size == 0.0 || off(k) <= place->size) continue;
    ++elsewhere;
    if (off(k) > off(worst)) worst = k;
  }
  if (elsewhere == 0) return;
  const int label = labels[static_cast<std::size_t>(worst)];
  deck.warnings.push_back(fmt::format(
      "{0}: by the file's own coordinates point {1} lies {2:.3g} m from grid "
      "{1} of the model ({3} of {4} points lie elsewhere): its numbers count "
      "as "
      "the model's grids; where they are the test's own, say so with "
      "\"geometry\": \"{0}\" in test.json, where two are exchanged, correct "
      "them",
      file.filename().string(),
      label,
      off(worst),
      elsewhere,
      n));
}

}  // namespace tapfit::updating
