#include "modal/poles/frf_matrix.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tapfit::modal {
namespace {

using RowKey = std::pair<Dof, std::size_t>;  // output, run or repetition
using Row = std::map<Dof, Eigen::Index>;     // reference -> FRF
using Rows = std::map<RowKey, Row>;

/// Sensors as references: one row per hit point and run.
Rows rows_per_run(const WeightedFrfs& curves) {
  Rows rows;
  for (std::size_t f = 0; f < curves.run.size(); ++f) {
    rows[{curves.reference[f], curves.run[f]}].emplace(
        curves.response[f], static_cast<Eigen::Index>(f));
  }
  return rows;
}

/// Hammers as references: one row per sensor point and repetition.
Rows rows_per_response(const WeightedFrfs& curves) {
  Rows rows;
  for (std::size_t f = 0; f < curves.run.size(); ++f) {
    for (std::size_t repetition = 0;; ++repetition) {
      Row& row = rows[{curves.response[f], repetition}];
      if (row.emplace(curves.reference[f], static_cast<Eigen::Index>(f))
              .second) {
        break;
      }
    }
  }
  return rows;
}

/// References in the order of how many rows have them, strongest first among
/// equals.
std::vector<Dof> by_frequency(const Rows& rows, const WeightedFrfs& curves) {
  std::map<Dof, std::pair<int, double>> seen;
  for (const auto& [key, row] : rows) {
    for (const auto& [dof, f] : row) {
      auto& [count, strength] = seen[dof];
      ++count;
      strength += curves.power(f);
    }
  }
  std::vector<Dof> order;
  for (const auto& [dof, value] : seen) order.push_back(dof);
  std::ranges::sort(order, [&](const Dof& a, const Dof& b) {
    return std::pair(seen[a].first, seen[a].second) >
           std::pair(seen[b].first, seen[b].second);
  });
  return order;
}

FrfMatrix complete_rows(const Rows& rows, const std::vector<Dof>& references) {
  FrfMatrix matrix;
  matrix.references = static_cast<Eigen::Index>(references.size());
  for (const auto& [key, row] : rows) {
    std::vector<Eigen::Index> complete;
    for (const Dof& dof : references) {
      const auto found = row.find(dof);
      if (found != row.end()) complete.push_back(found->second);
    }
    if (complete.size() == references.size()) matrix.rows.push_back(complete);
  }
  return matrix;
}

Eigen::Index covered(const FrfMatrix& matrix) {
  return static_cast<Eigen::Index>(matrix.rows.size()) * matrix.references;
}

/// The largest complete matrix of 2 to `most` references.
FrfMatrix best_matrix(const Rows& rows,
                      const WeightedFrfs& curves,
                      Eigen::Index most) {
  const std::vector<Dof> order = by_frequency(rows, curves);
  FrfMatrix best;
  const auto limit = std::min(static_cast<std::size_t>(most), order.size());
  for (std::size_t n = 2; n <= limit; ++n) {
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(n);
    const FrfMatrix matrix = complete_rows(rows, {order.begin(), end});
    if (covered(matrix) > covered(best)) best = matrix;
  }
  return best;
}

}  // namespace

FrfMatrix arrange_frfs(const WeightedFrfs& curves,
                       Eigen::Index most_references) {
  const FrfMatrix sensors =
      best_matrix(rows_per_run(curves), curves, most_references);
  const FrfMatrix hammers =
      best_matrix(rows_per_response(curves), curves, most_references);
  // The shorter side is the references: the outputs tell shapes apart.
  const bool as_many = covered(hammers) == covered(sensors);
  const bool by_hammers = as_many ? hammers.references < sensors.references
                                  : covered(hammers) > covered(sensors);
  const FrfMatrix& best = by_hammers ? hammers : sensors;
  // Half of the FRFs in a complete matrix of two or more references tell more
  // about close modes than all of them without.
  if (2 * covered(best) >= curves.count() && best.rows.size() > 1) return best;
  FrfMatrix single;
  for (Eigen::Index f = 0; f < curves.count(); ++f) single.rows.push_back({f});
  return single;
}

}  // namespace tapfit::modal
