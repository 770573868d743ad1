#include "modal/identify_modes.hpp"

#include "modal/curves.hpp"
#include "modal/frf_matrix.hpp"
#include "modal/modal_fit.hpp"
#include "modal/plscf.hpp"
#include "modal/run_modes.hpp"
#include "modal/select_modes.hpp"
#include "modal/shapes.hpp"
#include "modal/stabilisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Standard deviations of |lambda| and of damping from the covariance of
/// (Re, Im) lambda.
void fill_uncertainty(const Eigen::Matrix2d& covariance, Mode& mode) {
  const double size = std::abs(mode.pole);
  const double re = mode.pole.real();
  const double im = mode.pole.imag();
  const Eigen::Vector2d to_size(re / size, im / size);
  const double cube = size * size * size;
  const Eigen::Vector2d to_zeta(-im * im / cube, re * im / cube);
  mode.frequency_sd_hz =
      std::sqrt(std::max(0.0, to_size.dot(covariance * to_size))) / kTwoPi;
  mode.damping_sd = std::sqrt(std::max(0.0, to_zeta.dot(covariance * to_zeta)));
}

Mode make_mode(const Complex& pole,
               const Eigen::Matrix2d& covariance,
               const Eigen::VectorXcd& shape) {
  Mode mode;
  mode.pole = pole;
  mode.frequency_hz = std::abs(pole) / kTwoPi;
  mode.damping_ratio = -pole.real() / std::abs(pole);
  mode.shape = shape;
  mode.mpc = phase_collinearity(shape);
  fill_uncertainty(covariance, mode);
  return mode;
}

double synthesis_error(const Curves& curves, const Eigen::MatrixXcd& H) {
  const Eigen::VectorXd level = curves.H.cwiseAbs2().rowwise().mean();
  const Eigen::VectorXd left = (curves.H - H).cwiseAbs2().rowwise().mean();
  double sum = 0.0;
  for (Index k = 0; k < level.size(); ++k) {
    if (level(k) > 0.0) sum += left(k) / level(k);
  }
  return std::sqrt(sum / static_cast<double>(level.size()));
}

void warn_about(const Mode& mode, std::vector<std::string>& warnings) {
  if (mode.damping_ratio < 3.0 * mode.damping_sd) {
    warnings.push_back(fmt::format(
        "mode at {:.4g} Hz: damping {:.2g} is not resolved (sd {:.1g}); a "
        "longer block would help",
        mode.frequency_hz,
        mode.damping_ratio,
        mode.damping_sd));
  }
  if (mode.mpc < 0.7 && mode.shape.size() > 2) {
    warnings.push_back(fmt::format(
        "mode at {:.4g} Hz: points do not move in phase (MPC {:.2f})",
        mode.frequency_hz,
        mode.mpc));
  }
}

void warn_about_unresolved(const std::vector<Complex>& poles,
                           std::vector<std::string>& warnings) {
  for (const Complex& pole : poles) {
    warnings.push_back(fmt::format(
        "a pole at {:.4g} Hz was left out: its damping cannot be told from "
        "none (hum, or a block too short for it)",
        std::abs(pole) / kTwoPi));
  }
}

/// The fit on the lines and with the sign of each FRF given.
std::vector<Eigen::VectorXcd> fitted_frfs(const signal::FrfSet& frfs,
                                          const Curves& curves,
                                          const Eigen::MatrixXcd& H) {
  std::vector<Eigen::VectorXcd> fitted(frfs.frfs.size(),
                                       Eigen::VectorXcd::Zero(frfs.lines()));
  for (Index f = 0; f < curves.count(); ++f) {
    const std::size_t source = curves.source[static_cast<std::size_t>(f)];
    const signal::Frf& frf = frfs.frfs[source];
    const double sign = frf.response.sign * frf.reference.sign;
    fitted[source].tail(curves.lines()) = sign * H.col(f);
  }
  return fitted;
}

/// Fills all that comes from the fit; poles beside the band are left out.
void add_modes(const Curves& curves,
               const ShapeGraph& graph,
               const ModalFit& fit,
               const Eigen::MatrixXd& covariance,
               ModeSet& set) {
  const Eigen::MatrixXcd shapes =
      mode_shapes(graph, fit.residues, fit.poles, fit.frf_weight);
  const double low = curves.s(0).imag();
  const double high = curves.s(curves.lines() - 1).imag();
  for (Index r = 0; r < fit.poles.size(); ++r) {
    const double omega = std::abs(fit.poles(r));
    if (omega < low || omega > high) continue;
    set.modes.push_back(make_mode(
        fit.poles(r), covariance.block<2, 2>(2 * r, 2 * r), shapes.col(r)));
    warn_about(set.modes.back(), set.warnings);
  }
}

/// Replaces a fit of common poles by one of each run's own, when that leaves
/// clearly less or needs fewer modes: the sensors' mass moves the modes.
bool fit_each_run(const Curves& curves,
                  const IdentifyOptions& options,
                  const Progress& progress,
                  ModalFit& fit,
                  Eigen::MatrixXd& covariance,
                  std::vector<std::string>& warnings) {
  if (!sensors_rove(curves)) return false;
  const bool found = fit.poles.size() > 0;
  const double common = found ? synthesis_error(curves, fit.H) : 1.0;
  const std::optional<RunModes> runs =
      identify_per_run(curves, options, progress);
  if (!runs) return false;
  // Common poles can follow moving ones only by being many.
  const double apart = synthesis_error(curves, runs->H);
  const bool fewer = runs->poles.size() < fit.poles.size();
  if (apart > 0.5 * common && !(fewer && apart < 2.0 * common)) return false;
  if (!found) fit = fit_residues(curves, runs->poles);
  fit.poles = runs->poles;
  fit.residues = runs->residues;
  fit.H = runs->H;
  const Index modes = fit.poles.size();
  covariance = Eigen::MatrixXd::Zero(2 * modes, 2 * modes);
  for (Index r = 0; r < modes; ++r) {
    covariance(2 * r, 2 * r) = std::pow(runs->scatter(r).real(), 2);
    covariance(2 * r + 1, 2 * r + 1) = std::pow(runs->scatter(r).imag(), 2);
  }
  warnings.push_back(fmt::format(
      "frequencies move by up to {:.2g} % with the sensors: their mass loads "
      "the structure; each run was fitted by itself, and the standard "
      "deviations are the scatter over runs",
      100.0 * runs->frequency_range.maxCoeff()));
  return true;
}

}  // namespace

ModeSet identify_modes(const signal::FrfSet& frfs,
                       const IdentifyOptions& options,
                       const Progress& progress) {
  ModeSet set;
  const Curves curves = prepare_curves(frfs, set.warnings);
  const ShapeGraph graph = shape_graph(curves, set.warnings);
  set.dofs = graph.dofs;
  set.scaled = graph.scaled;
  const FrfMatrix matrix = arrange_frfs(curves);
  const std::vector<OrderPoles> orders =
      plscf_poles(curves, matrix, options.max_order, progress);
  const Stabilisation stabilisation = stabilise(
      orders, curves.s(0).imag(), curves.s(curves.lines() - 1).imag(), options);
  set.diagram = stabilisation.diagram;
  Selection selection = select_modes(
      curves, stabilisation.tracks, orders.size(), options, progress);
  ModalFit& fit = selection.fit;
  Eigen::MatrixXd covariance;
  if (!fit_each_run(curves, options, progress, fit, covariance, set.warnings)) {
    covariance = pole_covariance(curves, fit);
    warn_about_unresolved(selection.unresolved, set.warnings);
  }
  if (fit.poles.size() > 0) {
    add_modes(curves, graph, fit, covariance, set);
    set.fitted = fitted_frfs(frfs, curves, fit.H);
    set.synthesis_error = synthesis_error(curves, fit.H);
  } else {
    set.synthesis_error = 1.0;
  }
  if (set.modes.empty()) {
    set.warnings.emplace_back(
        "no mode found: no pole returns over the model orders; look at the "
        "FRFs and the band");
  }
  return set;
}

}  // namespace tapfit::modal
