#include "updating/prediction/confirmation.hpp"

#include "modal/mode_set/pairing.hpp"
#include "signal/statistics/tail_probability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

constexpr double half_width = 1.96;  // of a 95 % interval, in deviations

// As elsewhere: MAC of fewer values is no evidence.
constexpr std::size_t fewest_points = 3;

// z with P(|Z| > z) = chance, by bisection.
double normal_limit(double chance) {
  double low = 0.0;
  double high = 40.0;
  while (high - low > 1e-9) {
    const double z = 0.5 * (low + high);
    (signal::chi_squared_tail(z * z, 1.0) > chance ? low : high) = z;
  }
  return low;
}

/// The rows of measured shapes that the deck has, and the model's there.
struct SharedShapes {
  MatrixXcd measured;
  MatrixXcd predicted;
};

SharedShapes shared_shapes(const Prediction& prediction,
                           const modal::ModeSet& after) {
  const FrfModel& model = *prediction.model;
  std::vector<std::size_t> shared;
  for (std::size_t k = 0; k < after.dofs.size(); ++k) {
    if (model.context().deck->has_grid(after.dofs[k].node)) shared.push_back(k);
  }
  const auto rows = static_cast<Index>(shared.size());
  SharedShapes shapes{MatrixXcd(rows, static_cast<Index>(after.modes.size())),
                      MatrixXcd(rows, std::ssize(prediction.modes))};
  for (Index r = 0; r < rows; ++r) {
    const auto k = shared[static_cast<std::size_t>(r)];
    const Dof& dof = after.dofs[k];
    const Eigen::RowVectorXd at = dof.sign * model.row(dof.node, dof.component);
    for (Index m = 0; m < shapes.measured.cols(); ++m) {
      shapes.measured(r, m) =
          after.modes[static_cast<std::size_t>(m)].shape(static_cast<Index>(k));
    }
    for (Index m = 0; m < shapes.predicted.cols(); ++m) {
      shapes.predicted(r, m) =
          at.dot(prediction.modes[static_cast<std::size_t>(m)].phi);
    }
  }
  return shapes;
}

// Of whole predictions: the worst of the modes seen decides.
Finding95 finding_of(const Confirmation& c) {
  if (c.modes.empty()) return Finding95::Undecided;
  const bool holds = std::ranges::all_of(c.modes, [&c](const auto& mode) {
    return std::abs(mode.deviation) <= c.limit;
  });
  return holds ? Finding95::Confirmed : Finding95::Refuted;
}

}  // namespace

Confirmation confirm(const Prediction& prediction,
                     const modal::ModeSet& after,
                     double repeatability) {
  const SharedShapes shapes = shared_shapes(prediction, after);
  Eigen::VectorXd measured_hz(shapes.measured.cols());
  for (Index m = 0; m < measured_hz.size(); ++m) {
    measured_hz(m) = after.modes[static_cast<std::size_t>(m)].frequency_hz;
  }
  Eigen::VectorXd predicted_hz(shapes.predicted.cols());
  for (Index m = 0; m < predicted_hz.size(); ++m) {
    predicted_hz(m) =
        prediction.modes[static_cast<std::size_t>(m)].frequency_hz.value;
  }
  const auto pairs = modal::pair_modes(
      shapes.measured, measured_hz, shapes.predicted, predicted_hz);
  Confirmation result;
  for (const modal::Pair& pair : pairs) {
    const auto& mode = prediction.modes[static_cast<std::size_t>(pair.model)];
    const auto& seen = after.modes[static_cast<std::size_t>(pair.measured)];
    const double sd = std::hypot(mode.frequency_hz.sd,
                                 seen.frequency_sd_hz,
                                 repeatability * mode.frequency_hz.value);
    const double off = seen.frequency_hz - mode.frequency_hz.value;
    result.modes.push_back(
        {static_cast<int>(pair.model),
         static_cast<int>(pair.measured),
         seen.frequency_hz,
         seen.frequency_sd_hz,
         off / std::max(half_width * sd, 1e-12 * seen.frequency_hz),
         pair.mac,
         static_cast<std::size_t>(shapes.measured.rows()) >= fewest_points});
  }
  for (int m = 0; m < std::ssize(prediction.modes); ++m) {
    if (std::ranges::find(result.modes, m, &ConfirmedMode::predicted) ==
        result.modes.end()) {
      result.unseen.push_back(m);
    }
  }
  if (!result.modes.empty()) {
    result.limit =
        normal_limit(0.05 / static_cast<double>(result.modes.size())) /
        half_width;
  }
  result.finding = finding_of(result);
  return result;
}

std::string statement(const Confirmation& confirmation,
                      const Prediction& prediction) {
  if (confirmation.modes.empty()) {
    return "undecided: no measured mode is like one of those predicted";
  }
  const ConfirmedMode& worst = *std::ranges::max_element(
      confirmation.modes, {}, [](const ConfirmedMode& mode) {
        return std::abs(mode.deviation);
      });
  const std::size_t count = confirmation.modes.size();
  const std::string which = count == 1
                                ? "the one mode seen"
                                : fmt::format("the worst of {} modes", count);
  return fmt::format(
      "{}: {}, measured at {:.6g} Hz and predicted at {:.6g} Hz, is "
      "{:.3g} half widths of its 95 % interval off (limit {:.2g})",
      confirmation.finding == Finding95::Confirmed ? "confirmed" : "refuted",
      which,
      worst.measured_hz,
      prediction.modes[static_cast<std::size_t>(worst.predicted)]
          .frequency_hz.value,
      std::abs(worst.deviation),
      confirmation.limit);
}

}  // namespace tapfit::updating
