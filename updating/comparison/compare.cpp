#include "updating/comparison/compare.hpp"

#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/pairing.hpp"
#include "signal/checks/frac.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr int band_count = 6;

// MAC of shapes that have nothing in common is 1 / n over n values on average,
// and 1 for one value: over fewer it is no evidence.
constexpr std::size_t fewest_values = 3;

/// The degrees of freedom, in the base's coordinates.
MatrixXd rows_of(const FrfModel& model, const std::vector<Dof>& dofs) {
  MatrixXd rows(static_cast<Index>(dofs.size()), model.base().size());
  for (std::size_t k = 0; k < dofs.size(); ++k) {
    rows.row(static_cast<Index>(k)) =
        dofs[k].sign * model.row(dofs[k].node, dofs[k].component);
  }
  return rows;
}

/// @param at_dofs of all modes
ModelModes model_modes(const Fit& fit,
                       const BaseModes& full,
                       const MatrixXd& at_dofs) {
  const FrfModel& model = *fit.model;
  const double top = 2.0 * std::numbers::pi * 1.5 * model.context().high_hz;
  const Index count = std::max<Index>((full.omega.array() < top).count(),
                                      std::min<Index>(1, full.omega.size()));
  ModelModes modes;
  modes.frequency_hz = full.omega.head(count) / (2.0 * std::numbers::pi);
  const MatrixXd phi = full.phi.leftCols(count);
  modes.at_dofs = at_dofs.leftCols(count);
  const auto grids = static_cast<Index>(model.context().deck->grids.size());
  modes.at_grids.resize(3 * grids, count);
  const MatrixXd motion = model.base().rows * phi;
  for (Index g = 0; g < grids; ++g) {
    modes.at_grids.middleRows(3 * g, 3) = motion.middleRows(6 * g, 3);
  }
  const structure::Deck& deck = *model.context().deck;
  for (const structure::MeasuringPoint& point : deck.measuring) {
    const auto g = static_cast<Index>(deck.grid_index(point.grid));
    modes.at_grids.middleRows(3 * g, 3) =
        (point.axes * modes.at_grids.middleRows(3 * g, 3)).eval();
  }
  return modes;
}

MatrixXcd measured_shapes(const modal::ModeSet& modes) {
  MatrixXcd shapes(static_cast<Index>(modes.dofs.size()),
                   static_cast<Index>(modes.modes.size()));
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    shapes.col(static_cast<Index>(k)) = modes.modes[k].shape;
  }
  return shapes;
}

void pair_up(const modal::ModeSet& modes,
             const std::vector<PairByHand>& by_hand,
             const MatrixXd& mass,
             Comparison& c) {
  const MatrixXcd measured = measured_shapes(modes);
  const MatrixXcd model = c.modes.at_dofs.cast<std::complex<double>>();
  c.mac = modal::mac(measured, model);
  c.weighted_mac = modes.dofs.empty()
                       ? c.mac
                       : modal::mass_weighted_mac(measured, model, mass);
  Eigen::VectorXd measured_hz(measured.cols());
  for (Index k = 0; k < measured.cols(); ++k) {
    measured_hz(k) = modes.modes[static_cast<std::size_t>(k)].frequency_hz;
  }
  const std::vector<modal::Pair> fixed =
      pairs_by_index(by_hand, measured_hz, model.cols(), c.pair_notes);
  const std::vector<modal::Pair> pairs = modal::pair_modes(
      measured, measured_hz, model, c.modes.frequency_hz, {}, fixed);
  MatrixXcd left(measured.rows(), static_cast<Index>(pairs.size()));
  MatrixXcd right = left;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    ModePair p;
    p.measured = static_cast<int>(pairs[k].measured);
    p.model = static_cast<int>(pairs[k].model);
    p.measured_hz = measured_hz(p.measured);
    p.model_hz = c.modes.frequency_hz(p.model);
    p.error_percent = 100.0 * (p.model_hz - p.measured_hz) / p.measured_hz;
    p.has_shape = modes.dofs.size() >= fewest_values &&
                  !measured.col(p.measured).isZero(0.0);
    p.mac = c.mac(p.measured, p.model);
    p.weighted_mac = c.weighted_mac(p.measured, p.model);
    p.by_hand = std::ranges::any_of(
        fixed, [&p](const modal::Pair& f) { return f.measured == p.measured; });
    left.col(static_cast<Index>(k)) = measured.col(p.measured);
    right.col(static_cast<Index>(k)) = model.col(p.model);
    c.pairs.push_back(p);
  }
  c.comac = modal::comac(modal::in_scale_of(left, right), right);
  if (!modes.dofs.empty() && modes.dofs.size() < fewest_values) {
    c.pair_notes.push_back(fmt::format(
        "no MAC: measured shapes of {} value{} are like many of the model's",
        modes.dofs.size(),
        modes.dofs.size() == 1 ? "" : "s"));
  }
}

// Pairs alone would not show that the model has nothing like them.
std::string unpaired_text(const modal::ModeSet& modes,
                          const std::vector<ModePair>& pairs) {
  std::vector<std::string> left;
  for (std::size_t k = 0; k < modes.modes.size(); ++k) {
    if (std::ranges::count(pairs, static_cast<int>(k), &ModePair::measured)) {
      continue;
    }
    left.push_back(
        fmt::format("{} ({:.4g} Hz)", k + 1, modes.modes[k].frequency_hz));
  }
  if (left.empty()) return {};
  return fmt::format("no mode of the model is like measured mode{} {}",
                     left.size() > 1 ? "s" : "",
                     fmt::join(left, ", "));
}

void errors(const Target& target,
            const MatrixXcd& H,
            const signal::FrfSet& frfs,
            const effects::TestContext& context,
            Comparison& c) {
  c.error = relative_error(target, H);
  const Index lines = target.s.size();
  const double low = std::log(std::max(context.low_hz, 1e-6));
  const double width = (std::log(context.high_hz) - low) / band_count;
  Index first = 0;
  std::vector<std::pair<Index, Index>> ranges;
  for (int b = 0; b < band_count; ++b) {
    const double top = std::exp(low + width * (b + 1));
    Index last = first;
    while (last < lines &&
           (b + 1 == band_count ||
            target.s(last).imag() < 2.0 * std::numbers::pi * top)) {
      ++last;
    }
    if (last > first) {
      c.bands.push_back(
          {std::exp(low + width * b),
           top,
           block_error(target, H, first, last - first, 0, H.cols())});
      ranges.emplace_back(first, last - first);
    }
    first = last;
  }
  c.frf_band_error.resize(H.cols(), static_cast<Index>(ranges.size()));
  std::map<int, std::pair<double, int>> by_point;
  for (Index f = 0; f < H.cols(); ++f) {
    const double e = frf_error(target, H, f);
    c.frf_error.push_back(e);
    c.frac.push_back(signal::frac(target.H.col(f), H.col(f)));
    for (std::size_t b = 0; b < ranges.size(); ++b) {
      c.frf_band_error(f, static_cast<Index>(b)) =
          block_error(target, H, ranges[b].first, ranges[b].second, f, 1);
    }
    const signal::Frf& frf = frfs.frfs[static_cast<std::size_t>(f)];
    for (const int node : {frf.response.node, frf.reference.node}) {
      by_point[node].first += e * e;
      by_point[node].second += 1;
    }
  }
  for (const auto& [node, sum] : by_point) {
    c.point_error[node] = std::sqrt(sum.first / sum.second);
  }
}

}  // namespace

Comparison compare(const Fit& fit,
                   const Target& target,
                   const signal::FrfSet& frfs,
                   const modal::ModeSet& modes,
                   const std::vector<PairByHand>& by_hand) {
  Comparison c;
  const ModelState& state = fit.result.state;
  const ModelResponse at_target = fit.model->respond(state, target.s, false);
  if (target.is_modal()) {
    c.error = relative_error(target, at_target.H);
  } else {
    errors(target, at_target.H, frfs, fit.model->context(), c);
    const ModelResponse shown = fit.model->respond(state, frfs.s, false);
    for (Index f = 0; f < shown.H.cols(); ++f) {
      c.model_frfs.emplace_back(shown.H.col(f));
    }
  }
  const BaseModes all = fit.model->full_modes(state);
  const MatrixXd at_dofs = rows_of(*fit.model, modes.dofs) * all.phi;
  c.modes = model_modes(fit, all, at_dofs);
  if (!modes.modes.empty()) {
    const MatrixXd mass = modes.dofs.empty()
                              ? MatrixXd()
                              : modal::condensed_mass(at_dofs, all.omega);
    pair_up(modes, by_hand, mass, c);
    std::string unpaired = unpaired_text(modes, c.pairs);
    if (!unpaired.empty()) c.pair_notes.push_back(std::move(unpaired));
  }
  return c;
}

void limit_form(Comparison& c, double form_error) {
  c.floor_form = std::min(c.floor_form, form_error);
  c.floor = std::hypot(c.floor_noise, c.floor_mesh, c.floor_form);
}

bool hides_errors(double floor) {
  constexpr double high = 0.3;
  return floor > high;
}

std::string floor_warning(const Comparison& c) {
  if (!hides_errors(c.floor)) return {};
  return fmt::format(
      "the floor is {:.0f} %, so that only effects that change the FRFs more "
      "can be told: {}",
      100.0 * c.floor,
      c.floor_noise > c.floor_mesh
          ? "the hits scatter that much, or the FRFs are mostly noise in parts "
            "of the band; narrow `band_hz` or measure again"
          : "splitting the mesh changes the model that much; refine the model "
            "or lower the end of `band_hz`");
}

}  // namespace tapfit::updating
