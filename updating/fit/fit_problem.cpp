#include "updating/fit/fit_problem.hpp"

#include "acquisition/samples/statistics.hpp"
#include "signal/frf_set/kept_lines.hpp"
#include "updating/measurement/bundle_modes.hpp"
#include "updating/measurement/damped_line.hpp"
#include "updating/measurement/place_points.hpp"
#include "updating/properties/uncertain_property.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace tapfit::updating {
namespace {

// From peaks wide enough for 6 % of frequency error down to the line on which
// errors are reported.
constexpr double wide_delta = 0.06;
constexpr double report_delta = 0.03;

double median_damping(const modal::ModeSet& modes) {
  std::vector<double> ratios;
  for (const modal::Mode& mode : modes.modes) {
    ratios.push_back(mode.damping_ratio);
  }
  if (ratios.empty()) return FitProblem{}.damping_ratio;
  return std::clamp(acquisition::median(ratios), 1e-4, 0.2);
}

// Where something was measured: by sensors, or at the points of shapes.
std::vector<Dof> sensed_dofs(const acquisition::TestBundle& bundle) {
  if (bundle.modes) return read_bundle_modes(bundle).dofs;
  std::vector<Dof> dofs;
  for (const acquisition::Run& run : bundle.runs) {
    for (const acquisition::Placement& p : run.sensors) dofs.push_back(p.dof);
  }
  return dofs;
}

// The axis across which a plate, a frame or a wing is thin: its first modes
// move along it.
int thinnest_axis(const structure::Deck& deck) {
  Eigen::AlignedBox3d box;
  for (const structure::Grid& grid : deck.grids) {
    if (!grid.scalar) box.extend(grid.position);
  }
  Eigen::Index axis = 2;
  if (!box.isEmpty()) box.sizes().minCoeff(&axis);
  return static_cast<int>(axis) + 1;
}

// What of a test modes alone do not tell.
constexpr const char* untold_by_modes =
    "the test consists of modes: gains, delays and polarities of channels, "
    "noise, dampers, absorbers and non-linearity cannot be told from them, nor "
    "stiffness and mass that grow together";

// Of the first elastic mode, what rigid-body ones on their suspension reach:
// Ewins, Modal Testing, 2nd ed., section 3.2.
constexpr double usual_suspension = 0.2;

std::string assumed_suspension(double hz) {
  return fmt::format(
      "the structure hangs free and no rigid-body mode was measured: these are "
      "taken to lie below {:.3g} Hz, a fifth of the first elastic one, and "
      "springs to ground to be no stiffer (suspension_hz in test.json)",
      hz);
}

std::string data_in_words(const modal::ModeSet& modes) {
  if (modes.dofs.size() < 2) {
    return fmt::format("{} frequencies, no shapes", modes.modes.size());
  }
  return fmt::format("{} frequencies and shapes at {} points",
                     modes.modes.size(),
                     modes.dofs.size());
}

// The basic axis that a measured translation is mostly along, 1..3.
int basic_component(const structure::Deck& deck, const Dof& dof) {
  Eigen::Index axis = 0;
  direction_of(deck, dof).cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis) + 1;
}

}  // namespace

int measured_component(const acquisition::TestBundle& bundle,
                       const structure::Deck& deck) {
  std::array<int, 4> votes{};
  const std::vector<Dof> sensed = sensed_dofs(bundle);
  if (sensed.empty()) return thinnest_axis(deck);
  for (const Dof& dof : sensed) {
    if (dof.component > 3) continue;
    ++votes.at(static_cast<std::size_t>(basic_component(deck, dof)));
  }
  return static_cast<int>(std::max_element(votes.begin() + 1, votes.end()) -
                          votes.begin());
}

std::vector<int> tested_components(const acquisition::TestBundle& bundle,
                                   const structure::Deck& deck) {
  std::set<int> found;
  const auto take = [&](const Dof& dof) {
    if (dof.component >= 1 && dof.component <= 3) {
      found.insert(basic_component(deck, dof));
    }
  };
  for (const acquisition::Run& run : bundle.runs) take(run.hammer.dof);
  for (const Dof& dof : sensed_dofs(bundle)) take(dof);
  // Frequencies alone see what moves along any axis.
  if (found.empty() && bundle.modes) return {1, 2, 3};
  return {found.begin(), found.end()};
}

std::vector<PropertyName> property_names(const acquisition::TestBundle& bundle,
                                         const structure::Deck& deck) {
  std::vector<PropertyName> names;
  for (std::size_t k = 0; k < bundle.uncertain.size(); ++k) {
    const PropertyLaw law = property_law(
        deck, bundle.uncertain[k], fmt::format("test.json: uncertain[{}]", k));
    const double sd = bundle.uncertain[k].sd_percent / 100.0;
    names.push_back({law.name, law.unit, law.nominal, sd});
  }
  return names;
}

std::shared_ptr<const effects::Suspension> suspension_of(
    const acquisition::TestBundle& bundle,
    const modal::ModeSet& modes,
    const BaseBuilder& builder) {
  if (!builder.is_free()) return nullptr;
  double highest = usual_suspension * builder.elastic_hz();
  if (bundle.suspension_hz) {
    highest = *bundle.suspension_hz;
  } else if (!bundle.modes || modes.modes.empty() ||
             modes.modes.front().frequency_hz <= highest) {
    return nullptr;
  }
  return std::make_shared<const effects::Suspension>(
      effects::Suspension{highest, builder.rigid_modes()});
}

FitProblem fit_problem(const MeasuredTest& test,
                       const BaseBuilder& builder,
                       const Progress& progress) {
  FitProblem fit;
  fit.context = test.context;
  fit.damping_ratio = median_damping(test.modes);
  const acquisition::TestBundle& bundle = *test.context.bundle;
  for (const acquisition::UncertainProperty& u : bundle.uncertain) {
    fit.uncertain_sd.push_back(u.sd_percent / 100.0);
  }
  if (bundle.weighed) fit.weighed = known_mass(*bundle.weighed);
  std::array<double, 2> band = {test.context.low_hz, test.context.high_hz};
  fit.context.suspension = suspension_of(bundle, test.modes, builder);
  if (builder.is_free() && !test.modes.modes.empty()) {
    const double first = test.modes.modes.front().frequency_hz;
    band[0] = std::max(band[0], std::min(0.8 * first, 0.5 * band[1]));
  }
  // What effects may be is scaled by the lines that they are seen on.
  fit.context.low_hz = band[0];
  if (bundle.modes) {
    fit.modes = std::make_shared<const ModalData>(modal_data(test.modes));
    fit.targets.push_back(make_target(*fit.modes));
    fit.contour = data_in_words(test.modes);
    fit.measured.statements = test.modes.warnings;
    fit.measured.statements.emplace_back(untold_by_modes);
    if (fit.context.suspension && !bundle.suspension_hz) {
      fit.measured.statements.push_back(
          assumed_suspension(fit.context.suspension->highest_hz));
    }
    return fit;
  }
  std::vector<std::size_t> foreign;
  if (!bundle.frfs) {
    fit.foreign = modal::foreign_runs(test.frfs, test.modes);
    std::ranges::transform(
        fit.foreign, std::back_inserter(foreign), &modal::ForeignRun::run);
  }
  const double block_s = test.measurement.block_s();
  for (const double delta : {wide_delta, report_delta}) {
    DampedLineOptions options;
    options.delta = delta;
    const Eigen::VectorXcd s = damped_line(band, block_s, options);
    progress("comparison: damped lines", 0.0);
    fit.measured = test.measurement.frfs_on(s, progress);
    const std::string noisy = signal::leave_out_noisy_lines(fit.measured);
    if (!noisy.empty()) fit.measured.statements.push_back(noisy);
    fit.targets.push_back(make_target(fit.measured));
    leave_out(foreign, fit.targets.back());
    fit.targets.back().modes_in_band =
        std::max(1, static_cast<int>(test.modes.modes.size()));
    fit.context.low_hz =
        noisy.empty() ? band[0] : fit.measured.frequency_hz()(0);
    fit.contour =
        describe_line({fit.context.low_hz, band[1]}, fit.measured.s, options);
  }
  return fit;
}

}  // namespace tapfit::updating
