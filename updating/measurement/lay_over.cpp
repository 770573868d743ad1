#include "updating/measurement/lay_over.hpp"

#include "acquisition/foundation/finding.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/places/rigid_fit.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <string>

namespace tapfit::updating {
namespace {

using acquisition::NamedPair;
using acquisition::TestGeometry;
using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr const char* in_test_json = "test.json: geometry";
constexpr const char* check_the_unit =
    "check the unit of the test's coordinates (dataset 164; of a table it "
    "is the model's)";

Vector3d place_of_pair(const NamedPair& pair,
                       std::size_t number,
                       const structure::Deck& deck) {
  if (pair.grid == 0) return pair.at;
  if (!deck.has_grid(pair.grid)) {
    throw InputError(
        fmt::format("the model has no grid {}", pair.grid),
        fmt::format("{}.pairs[{}]", in_test_json, number),
        fmt::format("use a grid id of {}", deck.path.filename().string()));
  }
  return deck.grids[deck.grid_index(pair.grid)].position;
}

// A pair that misses by more than the mesh is named wrongly.
void check_pairs(const RigidFit& fit,
                 const TestGeometry& geometry,
                 const Matrix3Xd& from,
                 const Matrix3Xd& to,
                 const MeshSurface& surface) {
  if (!fit.determined) {
    throw InputError(
        "the pairs lie on a line, which leaves the turn about it "
        "open",
        fmt::format("{}.pairs", in_test_json),
        "name three pairs or more that span a triangle");
  }
  // Alike but for its size: a unit. Else a pair is wrong.
  constexpr double odd = 0.1;
  if (std::abs(fit.scale - 1.0) > odd && fit.scaled_rms < odd * fit.rms) {
    throw InputError(
        fmt::format("the model's distances are {:.4g} times those of {}",
                    fit.scale,
                    geometry.file.filename().string()),
        fmt::format("{}.pairs", in_test_json),
        std::string(check_the_unit) + ", or the pairs");
  }
  const Eigen::RowVectorXd off =
      (((fit.rotation * from).colwise() + fit.translation) - to)
          .colwise()
          .norm();
  Index worst = 0;
  const double most = off.maxCoeff(&worst);
  const auto place = surface.nearest(to.col(worst));
  if (!place || most <= place->size || place->size == 0.0) return;
  throw InputError(
      fmt::format("point {} comes to lie {:.3g} m from its place, farther than "
                  "the mesh is wide ({:.3g} m)",
                  geometry.pairs[static_cast<std::size_t>(worst)].label,
                  most,
                  place->size),
      fmt::format("{}.pairs[{}]", in_test_json, worst),
      "correct the pair; no rigid motion brings all of them together");
}

structure::LaidOver by_pairs(const TestGeometry& geometry,
                             const structure::Deck& deck,
                             const MeshSurface& surface) {
  const auto n = static_cast<Index>(geometry.pairs.size());
  Matrix3Xd from(3, n);
  Matrix3Xd to(3, n);
  for (Index k = 0; k < n; ++k) {
    const auto number = static_cast<std::size_t>(k);
    const NamedPair& pair = geometry.pairs[number];
    from.col(k) = geometry.nodes.at(pair.label);
    to.col(k) = place_of_pair(pair, number, deck);
  }
  const RigidFit fit = fit_pairs(from, to);
  check_pairs(fit, geometry, from, to, surface);
  return {fit.rotation, fit.translation, geometry.pairs.size(), fit.rms};
}

Matrix3Xd places_of(const structure::Deck& deck) {
  Matrix3Xd grids(3, static_cast<Index>(deck.grids.size()));
  for (Index k = 0; k < grids.cols(); ++k) {
    grids.col(k) = deck.grids[static_cast<std::size_t>(k)].position;
  }
  return grids;
}

// The farthest of the points from their mean [m].
double reach_of(const Matrix3Xd& points) {
  const Vector3d mean = points.rowwise().mean();
  return (points.colwise() - mean).colwise().norm().maxCoeff();
}

// Points that reach farther than the whole model lie on none of its places: no
// two of the model's are more than twice its reach apart.
void check_size(const Matrix3Xd& measured,
                const TestGeometry& geometry,
                const structure::Deck& deck) {
  const double here = reach_of(measured);
  const double there = reach_of(places_of(deck));
  if (here <= 2.2 * there) return;
  throw InputError(
      fmt::format("the points of {} reach {:.3g} m to either side, the model "
                  "{:.3g} m: about {} times as far",
                  geometry.file.filename().string(),
                  here,
                  there,
                  in_digits(here / there, 2)),
      in_test_json,
      check_the_unit);
}

// Of a mesh so small that it would lie anywhere.
std::string smallness(double here, double there) {
  if (10.0 * here > there) return {};
  return fmt::format(
      "; its points reach {:.2g} m to either side, the model {:.2g} m: check "
      "the unit, too",
      here,
      there);
}

InputError open_fit(const std::string& why) {
  return {why,
          in_test_json,
          "name three pairs of a point and a grid that do not lie on a line: "
          "\"pairs\": [[1, 101], [5, 140], [9, 7]]"};
}

structure::LaidOver by_best_fit(const TestGeometry& geometry,
                                const std::set<int>& used,
                                const structure::Deck& deck,
                                const MeshSurface& surface) {
  Matrix3Xd all(3, static_cast<Index>(geometry.nodes.size()));
  Matrix3Xd measured = all;
  Index nodes = 0;
  Index count = 0;
  for (const auto& [label, x] : geometry.nodes) {
    all.col(nodes++) = x;
    if (used.contains(label)) measured.col(count++) = x;
  }
  // A few may lie on the mesh by chance, all of them lie there in its axes.
  if (const auto fit = as_they_are(all, surface)) {
    return {fit->rotation, fit->translation, 0, fit->rms};
  }
  measured.conservativeResize(3, count);
  if (on_a_line(measured)) {
    throw open_fit(
        "the points that are measured lie on a line, which leaves the turn of "
        "the test's mesh about it open");
  }
  check_size(measured, geometry, deck);
  const std::vector<RigidFit> ways = fit_to_mesh(measured, deck, surface);
  assert(!ways.empty());
  if (ways.size() > 1) {
    throw open_fit(
        fmt::format("the test's mesh fits the model in {} ways, to {:.2g} m, "
                    "as symmetric structures do",
                    ways.size(),
                    ways.back().rms) +
        smallness(reach_of(measured), reach_of(places_of(deck))));
  }
  return {ways.front().rotation, ways.front().translation, 0, ways.front().rms};
}

}  // namespace

structure::LaidOver lay_over(const TestGeometry& geometry,
                             const std::set<int>& used,
                             const structure::Deck& deck,
                             const MeshSurface& surface) {
  return geometry.pairs.empty() ? by_best_fit(geometry, used, deck, surface)
                                : by_pairs(geometry, deck, surface);
}

}  // namespace tapfit::updating
