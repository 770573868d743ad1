#include "modal/mode_set/read_modes_uff.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/uff/uff_datasets.hpp"
#include "acquisition/uff/uff_shapes.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "modal/mode_set/complexity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using acquisition::UffDataset;
using acquisition::UffShape;

constexpr int normal = 2;          // analysis types
constexpr int complex_first = 3;   // of first order
constexpr int complex_second = 7;  // of second order

/// One mode as it stands in the file.
struct Raw {
  Complex pole;
  Complex modal_a;  ///< 0 where the file gives no scale
  std::map<Dof, Complex> shape;
};

/// Why a dataset holds no mode; empty where it does.
std::string fault(const UffShape& shape) {
  if (shape.analysis != normal && shape.analysis != complex_first &&
      shape.analysis != complex_second) {
    return fmt::format("analysis type {} is no mode", shape.analysis);
  }
  if (shape.data_type != 8 && shape.data_type != 12 && shape.data_type != 11) {
    return fmt::format("data type {} is no motion", shape.data_type);
  }
  for (const auto& [node, values] : shape.values) {
    if (values.size() != 3 && values.size() != 6) {
      return fmt::format("{} values per node are no motion", values.size());
    }
  }
  return {};
}

Raw raw_from(const UffShape& shape, const acquisition::UffGeometry& geometry) {
  Raw raw;
  const double omega = two_pi * shape.frequency_hz;
  const double zeta = shape.damping_ratio;
  const double damped = omega * std::sqrt(std::max(0.0, 1.0 - zeta * zeta));
  raw.pole = {-zeta * omega, damped};
  raw.modal_a = shape.analysis == normal
                    ? Complex(0.0, 2.0 * damped * shape.modal_mass)
                    : shape.modal_a;
  if (shape.eigenvalue != Complex(0.0)) {
    raw.pole = {shape.eigenvalue.real(), std::abs(shape.eigenvalue.imag())};
  }
  for (const auto& [node, values] : shape.values) {
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      Dof dof = turned(geometry, {node, static_cast<int>(k) + 1, 1});
      const double sign = dof.sign;
      dof.sign = 1;
      raw.shape[dof] = sign * values(k);
    }
  }
  return raw;
}

/// The mode of a dataset, or why it holds none.
std::optional<Raw> read_mode(const UffDataset& dataset,
                             const acquisition::UffGeometry& geometry,
                             std::string& why) {
  if (!acquisition::stands_at_nodes(dataset)) {
    why = "its data are not at nodes";
    return std::nullopt;
  }
  const UffShape shape = acquisition::read_shape(dataset);
  why = fault(shape);
  if (!why.empty()) return std::nullopt;
  return raw_from(shape, geometry);
}

bool has_all(const std::vector<Raw>& raws, const Dof& dof) {
  return std::ranges::all_of(
      raws, [&dof](const Raw& raw) { return raw.shape.contains(dof); });
}

/// All modes on the degrees of freedom at which one of them moves. A mode
/// without a value at one of them was not measured there, which is no zero.
/// @param skipped takes those that some mode has no value at
ModeSet collect(std::vector<Raw>& raws, std::vector<std::string>& skipped) {
  ModeSet set;
  std::ranges::stable_sort(
      raws, {}, [](const Raw& raw) { return std::abs(raw.pole); });
  std::map<Dof, bool> moves;
  for (const Raw& raw : raws) {
    for (const auto& [dof, value] : raw.shape) {
      moves[dof] = moves[dof] || value != Complex(0.0);
    }
  }
  std::vector<std::string> partly;
  for (const auto& [dof, moving] : moves) {
    if (!moving) continue;
    if (has_all(raws, dof)) {
      set.dofs.push_back(dof);
    } else {
      partly.push_back(name(dof));
    }
  }
  if (!partly.empty()) {
    skipped.push_back(fmt::format(
        "{} of the shapes' points ({}, ...) are left out: not every mode has a "
        "value there",
        partly.size(),
        partly.front()));
  }
  set.scaled = std::ranges::all_of(raws, [](const Raw& raw) {
    return std::abs(raw.modal_a) > 0.0 && raw.pole.imag() > 0.0;
  });
  for (const Raw& raw : raws) {
    Mode mode;
    mode.pole = raw.pole;
    const double omega = std::abs(raw.pole);
    mode.frequency_hz = omega / two_pi;
    mode.damping_ratio = omega > 0.0 ? -raw.pole.real() / omega : 0.0;
    mode.shape.resize(static_cast<Eigen::Index>(set.dofs.size()));
    // phi phi' / A is what stays when both are scaled.
    const Complex factor =
        set.scaled
            ? std::sqrt(Complex(0.0, 2.0 * raw.pole.imag()) / raw.modal_a)
            : Complex(1.0);
    for (std::size_t k = 0; k < set.dofs.size(); ++k) {
      mode.shape(static_cast<Eigen::Index>(k)) =
          factor * raw.shape.at(set.dofs[k]);
    }
    mode.mpc = phase_collinearity(mode.shape);
    mode.mpd_deg = mean_phase_deviation(mode.shape);
    set.modes.push_back(std::move(mode));
  }
  return set;
}

}  // namespace

UffModes read_modes_uff_text(const std::string& text, const std::string& name) {
  UffModes result;
  std::vector<Raw> raws;
  const std::vector<UffDataset> datasets = acquisition::split_uff(text, name);
  const acquisition::UffGeometry geometry =
      acquisition::read_geometry(datasets);
  for (const UffDataset& dataset : datasets) {
    if (dataset.type != 55 && dataset.type != 2414) continue;
    std::string why;
    std::optional<Raw> raw = read_mode(dataset, geometry, why);
    if (raw) {
      raws.push_back(std::move(*raw));
    } else {
      result.skipped.push_back(
          fmt::format("{}: dataset {}: {}", dataset.place, dataset.type, why));
    }
  }
  if (raws.empty()) {
    throw InputError(result.skipped.empty()
                         ? std::string("no dataset 55 or 2414 in the file")
                         : "no mode in the file: " + result.skipped.front(),
                     name,
                     "export modes (dataset 55 or 2414, at nodes)");
  }
  result.set = collect(raws, result.skipped);
  return result;
}

UffModes read_modes_uff(const std::filesystem::path& file) {
  std::ifstream in =
      acquisition::open_input(file, acquisition::most_text_bytes);
  if (!in) {
    throw InputError("cannot be read", file.string(), "check its name");
  }
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  return read_modes_uff_text(text, file.string());
}

}  // namespace tapfit::modal
