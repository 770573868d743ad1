#include "modal/identify/identify_modes.hpp"

#include "acquisition/foundation/constants.hpp"
#include "modal/fit/fit_residual.hpp"
#include "modal/fit/modal_fit.hpp"
#include "modal/fit/pole_covariance.hpp"
#include "modal/fit/shape_uncertainty.hpp"
#include "modal/fit/shapes.hpp"
#include "modal/identify/mode_warnings.hpp"
#include "modal/mass_loading/multi_setup_identification.hpp"
#include "modal/mass_loading/sensor_shifts.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/poles/frf_matrix.hpp"
#include "modal/poles/lines_in_band.hpp"
#include "modal/poles/plscf.hpp"
#include "modal/poles/pole_clusters.hpp"
#include "modal/poles/stabilisation.hpp"
#include "modal/poles/weighted_frfs.hpp"
#include "modal/select/edit_poles.hpp"
#include "modal/select/out_of_band_modes.hpp"
#include "modal/select/repeated_poles.hpp"
#include "modal/select/select_from_orders.hpp"
#include "modal/select/unrefined_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

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
      std::sqrt(std::max(0.0, to_size.dot(covariance * to_size))) / two_pi;
  mode.damping_sd = std::sqrt(std::max(0.0, to_zeta.dot(covariance * to_zeta)));
}

Mode make_mode(const Complex& pole,
               const Eigen::Matrix2d& covariance,
               const Eigen::VectorXcd& shape) {
  Mode mode;
  mode.pole = pole;
  mode.frequency_hz = std::abs(pole) / two_pi;
  mode.damping_ratio = -pole.real() / std::abs(pole);
  mode.shape = shape;
  mode.mpc = phase_collinearity(shape);
  mode.mpd_deg = mean_phase_deviation(shape);
  fill_uncertainty(covariance, mode);
  return mode;
}

/// The fit on the lines and with the sign of each FRF given.
std::vector<Eigen::VectorXcd> fitted_frfs(const signal::FrfSet& frfs,
                                          const WeightedFrfs& curves,
                                          const Eigen::MatrixXcd& H) {
  std::vector<Eigen::VectorXcd> fitted(frfs.frfs.size(),
                                       Eigen::VectorXcd::Zero(frfs.lines()));
  Index first = 0;
  (frfs.s.array() - curves.s(0)).abs().minCoeff(&first);
  for (Index f = 0; f < curves.count(); ++f) {
    const std::size_t source = curves.source[static_cast<std::size_t>(f)];
    const signal::Frf& frf = frfs.frfs[source];
    const double sign = frf.response.sign * frf.reference.sign;
    fitted[source].segment(first, curves.lines()) = sign * H.col(f);
  }
  return fitted;
}

/// What was found, by poles common to all FRFs or of each set-up's own.
struct Identified {
  ModalFit fit;
  Eigen::MatrixXcd H;          ///< fitted, n_lines x n_frfs
  Eigen::MatrixXd covariance;  ///< of the poles, 2 n_modes square
  Eigen::MatrixXd residue_variance;
  std::vector<SetUpPoles> set_ups;  ///< none where poles are common
};

/// The entries given by index of each set-up's poles.
std::vector<SetUpPoles> keep(const std::vector<SetUpPoles>& all,
                             const std::vector<Index>& kept) {
  std::vector<SetUpPoles> result;
  for (const SetUpPoles& own : all) {
    result.push_back({own.set_up, own.poles(kept), own.log_sd(kept)});
  }
  return result;
}

/// Fills all that comes from the fit; poles beside the band are left out.
void add_modes(const WeightedFrfs& curves,
               const ShapeGraph& graph,
               const Identified& found,
               ModeSet& set) {
  const ModalFit& fit = found.fit;
  const Eigen::MatrixXcd shapes =
      mode_shapes(graph, fit.residues, fit.poles, fit.frf_weight);
  const Eigen::MatrixXd deviations = shape_deviations(
      graph, fit.residues, found.residue_variance, fit.poles, shapes);
  const double low = curves.s(0).imag();
  const double high = curves.s(curves.lines() - 1).imag();
  std::vector<Index> kept;
  for (Index r = 0; r < fit.poles.size(); ++r) {
    const double omega = std::abs(fit.poles(r));
    if (omega < low || omega > high) continue;
    kept.push_back(r);
    set.modes.push_back(make_mode(fit.poles(r),
                                  found.covariance.block<2, 2>(2 * r, 2 * r),
                                  shapes.col(r)));
    set.modes.back().shape_sd = deviations.col(r);
    warn_about(set.modes.back(), set.warnings);
    warn_about_resolution(curves, set.modes.back(), set.warnings);
  }
  set.set_ups = keep(found.set_ups, kept);
}

/// Whether poles of each set-up's own leave clearly less than common ones, or
/// as little with fewer of them: common poles can follow moving ones only by
/// being many. Every value counts by its own weight here, also on the flanks
/// of one FRF's resonance where others are large.
bool is_better(const WeightedFrfs& curves,
               const MultiSetupModes& own,
               const ModalFit& common) {
  const auto left = [&curves](const Eigen::MatrixXcd& H) {
    return curves.weight.cwiseProduct(curves.H - H).norm();
  };
  const bool found = common.poles.size() > 0;
  const double together = found ? left(fitted_accelerance(curves, common))
                                : curves.weight.cwiseProduct(curves.H).norm();
  const double apart = left(own.H);
  const bool fewer = own.poles.size() < common.poles.size();
  return apart <= 0.5 * together || (fewer && apart < 2.0 * together);
}

Identified of_set_ups(const MultiSetupModes& runs) {
  Identified found;
  found.fit.poles = runs.poles;
  found.fit.residues = runs.residues;
  found.H = runs.H;
  found.fit.frf_weight = runs.frf_weight;
  found.residue_variance = runs.residue_variance;
  found.set_ups = runs.set_ups;
  const Index modes = runs.poles.size();
  found.covariance = Eigen::MatrixXd::Zero(2 * modes, 2 * modes);
  for (Index r = 0; r < modes; ++r) {
    found.covariance(2 * r, 2 * r) = std::pow(runs.scatter(r).real(), 2);
    found.covariance(2 * r + 1, 2 * r + 1) =
        std::pow(runs.scatter(r).imag(), 2);
  }
  return found;
}

/// Poles in order of frequency, equal ones once: two columns must not coincide.
Eigen::VectorXcd distinct(const Eigen::VectorXcd& poles) {
  std::vector<Complex> kept;
  for (const Complex& pole : poles) {
    if (std::ranges::find(kept, pole) == kept.end()) kept.push_back(pole);
  }
  return Eigen::Map<Eigen::VectorXcd>(kept.data(),
                                      static_cast<Index>(kept.size()));
}

/// Puts in place of each pole the modes that its residues hold.
void take_apart(const WeightedFrfs& curves,
                bool scaled,
                const IdentifyOptions& options,
                Identified& found,
                std::vector<std::string>& warnings) {
  struct Part {
    Complex pole;
    Index source;
    double variance;  // more than the source's
    Eigen::VectorXcd residues;
  };
  std::vector<Part> parts;
  for (Index r = 0; r < found.fit.poles.size(); ++r) {
    const ModesOfPole own =
        modes_of_pole(curves, found.fit, r, scaled, options);
    for (Index k = 0; k < own.poles.size(); ++k) {
      parts.push_back({own.poles(k),
                       r,
                       own.deviation * own.deviation,
                       own.residues.col(k)});
    }
    warn_about_shared(own, warnings);
  }
  std::ranges::stable_sort(
      parts, {}, [](const Part& part) { return std::abs(part.pole); });
  Identified result = found;
  const auto count = static_cast<Index>(parts.size());
  result.fit.poles.resize(count);
  result.fit.residues.resize(curves.count(), count);
  result.residue_variance.resize(curves.count(), count);
  result.covariance = Eigen::MatrixXd::Zero(2 * count, 2 * count);
  for (Index k = 0; k < count; ++k) {
    const Part& part = parts[static_cast<std::size_t>(k)];
    result.fit.poles(k) = part.pole;
    result.fit.residues.col(k) = part.residues;
    result.residue_variance.col(k) = found.residue_variance.col(part.source);
    result.covariance.block<2, 2>(2 * k, 2 * k) =
        found.covariance.block<2, 2>(2 * part.source, 2 * part.source) +
        0.5 * part.variance * Eigen::Matrix2d::Identity();
  }
  if (count > found.fit.poles.size()) {
    result.H = fitted_accelerance(
        curves, fit_residues(curves, distinct(result.fit.poles)));
  }
  found = std::move(result);
}

void add_clusters(const std::vector<Track>& tracks, ModeSet& set) {
  for (Mode& mode : set.modes) {
    const std::optional<std::size_t> track = nearest_track(tracks, mode.pole);
    if (track) mode.cluster = cluster_of(tracks[*track]);
  }
}

/// Each set-up's own poles, which the sensors move.
Identified identified_by_set_up(const MultiSetupModes& runs, ModeSet& set) {
  if (runs.poles.size() > 0) {
    set.warnings.push_back(fmt::format(
        "frequencies move by up to {:.2g} % between set-ups of the sensors; "
        "each was fitted by itself, and the standard deviations are the "
        "scatter over them",
        100.0 * runs.frequency_range.maxCoeff()));
  }
  return of_set_ups(runs);
}

/// Poles that all FRFs have in common.
Identified identified_in_common(const WeightedFrfs& curves,
                                Selection selection,
                                const IdentifyOptions& options,
                                ModeSet& set) {
  Identified found;
  found.fit = std::move(selection.fit);
  {
    const Noise noise = weighted_noise(curves, found.fit, NoiseFrom::AllLines);
    found.covariance = pole_covariance(curves, found.fit, noise);
    found.residue_variance = residue_variance(curves, found.fit, noise);
  }
  found.H = fitted_accelerance(curves, found.fit);
  take_apart(curves, set.scaled, options, found, set.warnings);
  warn_about_unresolved(selection.unresolved, set.warnings);
  warn_about_shifting(selection.shifting, set.warnings);
  set.unresolved = selection.unresolved;
  warn_about_complex(selection.out_of_phase, options, set.warnings);
  return found;
}

std::string why_none(const IdentifyOptions& options) {
  if (!options.edits.empty()) return "no mode left: all were dropped by hand";
  const IdentifyOptions usual;
  if (options.least_damping_ratio > usual.least_damping_ratio ||
      options.max_damping_ratio < usual.max_damping_ratio) {
    return fmt::format(
        "no mode found with a damping from {:.3g} to {:.3g} %, as was asked "
        "for; widen these limits",
        100.0 * options.least_damping_ratio,
        100.0 * options.max_damping_ratio);
  }
  return "no mode found: no pole returns over the model orders; look at the "
         "FRFs and the band";
}

}  // namespace

ModeSet identify_modes(const signal::FrfSet& frfs,
                       const IdentifyOptions& options,
                       const Progress& progress) {
  ModeSet set;
  const WeightedFrfs curves = prepare_frfs(
      options.band_hz ? lines_in_band(frfs, *options.band_hz) : frfs,
      set.warnings);
  const ShapeGraph graph = shape_graph(curves, set.warnings);
  set.dofs = graph.dofs;
  set.scaled = graph.scaled;
  const FrfMatrix matrix = arrange_frfs(curves);
  const std::vector<OrderPoles> orders =
      plscf_poles(curves, matrix, options.max_order, progress);
  const Stabilisation stabilisation = stabilise(
      orders, curves.s(0).imag(), curves.s(curves.lines() - 1).imag(), options);
  set.diagram = stabilisation.diagram;
  Selection selection = select_from_orders(
      curves, matrix, orders, stabilisation.tracks, options, progress);
  std::optional<MultiSetupModes> runs =
      identify_per_set_up(curves, options, progress);
  const bool by_set_up =
      runs && sensors_rove(curves) && is_better(curves, *runs, selection.fit);
  if (by_set_up) {
    runs = edited(curves, options.edits, *runs);
  } else {
    edit_poles(curves, stabilisation.tracks, options.edits, selection.fit);
  }
  if (runs) set.shifts = sensor_shifts(frfs, curves, graph, *runs);
  const Identified found =
      by_set_up
          ? identified_by_set_up(*runs, set)
          : identified_in_common(curves, std::move(selection), options, set);
  if (found.fit.poles.size() > 0) {
    add_modes(curves, graph, found, set);
    set.synthesis_error = relative_misfit(curves, found.H);
    warn_about_misfit(set.synthesis_error, set.warnings);
    add_clusters(stabilisation.tracks, set);
    set.unrefined_error = relative_misfit(
        curves,
        !by_set_up
            ? unrefined_fit(curves, stabilisation.tracks, found.fit.poles)
            : runs->unrefined_H);
    set.fitted = fitted_frfs(frfs, curves, found.H);
  } else {
    set.synthesis_error = 1.0;
    set.unrefined_error = 1.0;
  }
  if (set.modes.empty()) set.warnings.push_back(why_none(options));
  return set;
}

}  // namespace tapfit::modal
