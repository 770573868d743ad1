#include "updating/frf_model/form_entries.hpp"

#include <algorithm>
#include <cstddef>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<FormEntry> form_entries(const VectorXd& omega,
                                    const Eigen::MatrixXd& at_points,
                                    double lowest,
                                    Index modes) {
  constexpr std::size_t neighbours = 5;
  constexpr double hidden = 1e-3;  // of what shows most
  const VectorXd shown = at_points.colwise().norm().transpose();
  const double most = modes > 0 ? shown.head(modes).maxCoeff() : 0.0;
  std::vector<Index> visible;
  for (Index i = 0; i < omega.size(); ++i) {
    if (omega(i) > lowest && shown(i) > hidden * most) visible.push_back(i);
  }
  std::vector<FormEntry> entries;
  for (std::size_t a = 0; a < visible.size() && visible[a] < modes; ++a) {
    const std::size_t last = std::min(visible.size(), a + neighbours + 1);
    for (std::size_t b = a; b < last; ++b) {
      entries.push_back({visible[a], visible[b]});
    }
  }
  return entries;
}

}  // namespace tapfit::updating
