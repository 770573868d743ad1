#include "updating/measurement/test_model.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/measurement/bundle_frfs.hpp"
#include "updating/measurement/bundle_modes.hpp"
#include "updating/measurement/named_grids.hpp"
#include "updating/measurement/place_points.hpp"
#include "updating/structure/assembly/multipoint_constraints.hpp"
#include "updating/structure/checks/unit_checks.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/readers/matrix_market.hpp"
#include "updating/structure/readers/scale_units.hpp"
#include "updating/structure/solve/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

void check_grid(const structure::Deck& deck,
                const Dof& dof,
                const std::string& place) {
  if (!deck.has_grid(dof.node)) {
    throw InputError(
        fmt::format("the model has no grid {}", node_name(dof.node)),
        place,
        fmt::format(
            "use a grid id of {}; where the test has points of its own, "
            "say with \"geometry\" in test.json where they lie",
            deck.path.filename().string()));
  }
}

// What the deck holds at zero, directly or through a rigid element.
class Held {
 public:
  explicit Held(const structure::Deck& deck)
      : deck_(&deck),
        axes_(structure::constraint_axes(deck)),
        T_(structure::multipoint_constraints(deck, axes_).transpose()) {
    if (!deck.given) return;
    const Eigen::VectorXd stiff = deck.given->K.diagonal();
    for (Eigen::Index u = 0; u < stiff.size(); ++u) {
      if (stiff(u) == 0.0) absent_.insert(u);
    }
  }

  [[nodiscard]] bool holds(const Dof& dof) const {
    const auto u = 6 * static_cast<Eigen::Index>(deck_->grid_index(dof.node)) +
                   dof.component - 1;
    // The test's own points have no row of their own and follow others.
    if (dof.node > 0 && absent_.contains(u)) return true;
    if (T_.size() == 0) return is_fixed(u);
    for (structure::SparseMatrix::InnerIterator it(T_, u); it; ++it) {
      if (std::abs(it.value()) > 1e-9 && !is_fixed(it.row())) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] bool is_fixed(Eigen::Index q) const {
    const auto held =
        axes_.held.find(deck_->grids[static_cast<std::size_t>(q / 6)].id);
    return held != axes_.held.end() &&
           held->second.find(static_cast<char>('1' + q % 6)) !=
               std::string::npos;
  }

  const structure::Deck* deck_;
  structure::ConstraintAxes axes_;
  structure::SparseMatrix T_;      // rows as columns
  std::set<Eigen::Index> absent_;  // without a row in given matrices
};

// A point of the test and where that says so.
struct Point {
  Dof dof;
  std::string place;
};

std::vector<Point> points_of(const acquisition::TestBundle& bundle) {
  std::vector<Point> points;
  if (bundle.frfs) {
    const std::string file = bundle.frfs->filename().string();
    for (const signal::Frf& frf : read_bundle_frfs(bundle).set.frfs) {
      points.push_back({frf.response, file});
      points.push_back({frf.reference, file});
    }
    return points;
  }
  if (bundle.modes) {
    const std::string file = bundle.modes->file.filename().string();
    for (const Dof& dof : read_bundle_modes(bundle).dofs) {
      points.push_back({dof, file});
    }
    return points;
  }
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const acquisition::Run& run = bundle.runs[r];
    points.push_back(
        {run.hammer.dof, fmt::format("test.json: runs[{}].hammer", r)});
    for (std::size_t k = 0; k < run.sensors.size(); ++k) {
      points.push_back({run.sensors[k].dof,
                        fmt::format("test.json: runs[{}].sensors[{}]", r, k)});
    }
  }
  return points;
}

// Labels of the test's own points that something is measured at.
std::set<int> own_labels(const std::vector<Point>& points) {
  std::set<int> labels;
  for (const Point& point : points) {
    if (point.dof.node < 0) labels.insert(-point.dof.node);
  }
  return labels;
}

// Also those at which the test has directions of its own.
std::set<int> grids_of(const std::vector<Point>& points,
                       const acquisition::TestBundle& bundle) {
  std::set<int> grids;
  for (const Point& point : points) {
    if (point.dof.node > 0) grids.insert(point.dof.node);
  }
  const std::set<int> own = own_labels(points);
  for (const acquisition::TestPoint& point : bundle.points) {
    if (point.node > 0 && own.contains(point.label)) grids.insert(point.node);
  }
  return grids;
}

// Each degree of freedom is named where it is first.
void check_points(const std::vector<Point>& points, structure::Deck& deck) {
  const Held held(deck);
  std::set<std::pair<int, int>> seen;
  for (const auto& [dof, place] : points) {
    if (!seen.emplace(dof.node, dof.component).second) continue;
    check_grid(deck, dof, place);
    if (!held.holds(dof)) continue;
    deck.warnings.push_back(fmt::format(
        "{}: the model holds {} at zero, so that it does not move there "
        "whatever was measured; move the point, or free the grid",
        place,
        name(dof)));
  }
}

void warn_of_turned_supports(structure::Deck& deck) {
  const structure::ConstraintAxes axes = structure::constraint_axes(deck);
  std::vector<int> grids;
  std::ranges::copy_if(axes.turned, std::back_inserter(grids), [&](int grid) {
    return axes.held.contains(grid);
  });
  if (grids.empty()) return;
  deck.warnings.push_back(
      fmt::format("GRID {} ({} in all) is held along turned axes (CD): the "
                  "effect soft-support leaves its support as it is; where that "
                  "may give, hold the grid along basic axes",
                  grids.front(),
                  grids.size()));
}

structure::Deck read_model(const acquisition::TestBundle& bundle) {
  if (bundle.deck) {
    return structure::read_deck(*bundle.deck, bundle.ignored_cards);
  }
  const acquisition::MatrixModel& files = *bundle.matrices;
  return structure::read_matrix_model(files.stiffness, files.mass, files.dofs);
}

}  // namespace

structure::Deck read_test_model(const acquisition::TestBundle& bundle) {
  if (!bundle.deck && !bundle.matrices) {
    throw InputError("the test has no model",
                     (bundle.folder / "test.json").string(),
                     "name a Nastran deck in the field \"model\"");
  }
  structure::Deck deck = read_model(bundle);
  structure::scale_to_si(deck, bundle.units);
  std::ranges::move(structure::unit_warnings(deck),
                    std::back_inserter(deck.warnings));
  if (!structure::can_refine(deck)) {
    deck.warnings.push_back(
        "solids and quadratic shells are not split: what the mesh does to the "
        "modes is not known, and the floor is the noise alone");
  }
  const std::vector<Point> points = points_of(bundle);
  check_named_grids(bundle, grids_of(points, bundle), deck);
  place_points(bundle, own_labels(points), deck);
  check_points(points, deck);
  warn_of_turned_supports(deck);
  return deck;
}

}  // namespace tapfit::updating
