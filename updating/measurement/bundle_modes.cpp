#include "updating/measurement/bundle_modes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/read_modes_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

// Nodes of the test's own mesh become its points.
void put_on_geometry(const acquisition::TestBundle& bundle,
                     modal::ModeSet& modes) {
  if (!bundle.geometry) return;
  const acquisition::TestGeometry& geometry = *bundle.geometry;
  for (std::size_t k = 0; k < modes.dofs.size(); ++k) {
    Dof& dof = modes.dofs[k];
    if (!geometry.nodes.contains(std::abs(dof.node))) {
      throw InputError(
          fmt::format("the test's geometry has no point {}", dof.node),
          bundle.modes->file.filename().string(),
          fmt::format("export {} with all points of the shapes",
                      geometry.file.filename().string()));
    }
    if (dof.node < 0) continue;
    dof = acquisition::at_own_point(geometry, dof);
    for (modal::Mode& mode : modes.modes) {
      mode.shape(static_cast<Eigen::Index>(k)) *= dof.sign;
    }
    dof.sign = 1;
  }
}

void leave_out(const acquisition::TestBundle& bundle, modal::ModeSet& modes) {
  const std::array<double, 2> band =
      bundle.band_hz.value_or(std::array{0.0, HUGE_VAL});
  std::erase_if(modes.modes, [&](const modal::Mode& mode) {
    const double f = mode.frequency_hz;
    const char* why = f <= 0.0                     ? "a rigid mode"
                      : f < band[0] || f > band[1] ? "outside band_hz"
                                                   : nullptr;
    if (why == nullptr) return false;
    modes.warnings.push_back(
        fmt::format("the mode at {:.6g} Hz is left out: {}", f, why));
    return true;
  });
  if (!modes.modes.empty()) return;
  throw InputError("no mode is left to compare with",
                   bundle.modes->file.filename().string(),
                   "give modes above 0 Hz and within band_hz");
}

// The model's shapes are real: of a measured one the nearest real shape counts.
void warn_of_complex(modal::ModeSet& modes) {
  for (const modal::Mode& mode : modes.modes) {
    if (mode.shape.size() <= 2 || mode.shape.isZero(0.0) ||
        mode.mpc >= modal::in_phase_mpc)
      continue;
    modes.warnings.push_back(
        fmt::format("the points of the mode at {:.6g} Hz do not move in phase "
                    "(MPC {:.2f}): "
                    "of its shape the real part alone is compared",
                    mode.frequency_hz,
                    mode.mpc));
  }
}

void fill_deviations(const acquisition::ReadyModes& told,
                     modal::ModeSet& modes) {
  int frequencies = 0;
  int shapes = 0;
  for (modal::Mode& mode : modes.modes) {
    if (mode.frequency_sd_hz <= 0.0) {
      mode.frequency_sd_hz =
          0.01 * told.frequency_sd_percent * mode.frequency_hz;
      ++frequencies;
    }
    const Eigen::Index n = mode.shape.size();
    if (n == 0) continue;
    if (mode.shape.isZero(0.0)) {
      mode.shape_sd.setOnes(n);  // never asked for
      modes.warnings.push_back(
          fmt::format("the shape of the mode at {:.6g} Hz is zero at all "
                      "points: its frequency counts alone",
                      mode.frequency_hz));
      continue;
    }
    const double own = 0.01 * told.shape_sd_percent * mode.shape.norm() /
                       std::sqrt(static_cast<double>(n));
    const bool unknown = mode.shape_sd.size() != n;
    if (unknown) mode.shape_sd.setZero(n);
    if (!(mode.shape_sd.array() > 0.0).all()) ++shapes;
    mode.shape_sd = (mode.shape_sd.array() > 0.0).select(mode.shape_sd, own);
  }
  if (frequencies > 0) {
    modes.warnings.push_back(fmt::format(
        "{} of {} frequencies came without a standard deviation: {:.3g} % is "
        "taken (modes.frequency_sd_percent in test.json)",
        frequencies,
        modes.modes.size(),
        told.frequency_sd_percent));
  }
  if (shapes > 0) {
    modes.warnings.push_back(fmt::format(
        "{} of {} shapes came without standard deviations: {:.3g} % of their "
        "root mean square is taken (modes.shape_sd_percent in test.json)",
        shapes,
        modes.modes.size(),
        told.shape_sd_percent));
  }
}

}  // namespace

modal::ModeSet read_bundle_modes(const acquisition::TestBundle& bundle) {
  modal::ModeSet modes = modal::read_modes_file(bundle.modes->file);
  modal::check_measured(modes, bundle.modes->file.filename().string());
  put_on_geometry(bundle, modes);
  leave_out(bundle, modes);
  warn_of_complex(modes);
  fill_deviations(*bundle.modes, modes);
  return modes;
}

}  // namespace tapfit::updating
