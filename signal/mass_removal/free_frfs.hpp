// The room signal/mass_removal. FRFs freed of the sensors' mass.
// In:  FRFs and masses, by name or by point.
// Out: The same FRFs without the masses, each with how it was freed or why not.
// May include: its row in CONTRIBUTING.md.
//
// A whole set of FRFs freed of the sensors' mass.
//
// A mass at the points T is taken off A_ij with A_iT, A_Tj and A_TT of the same
// set-up (signal/mass_removal/mass_removal.hpp). Each of these is taken from
// measurement: directly, or by reciprocity A_ab = A_ba. A_TT is known where the
// hammer hit the sensor's own place. What was not measured may come from a
// model, such as the identified modes.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::signal {

/// A mass to take off; what it weighs may be known only so well.
struct KnownMass {
  std::string name;  ///< for messages
  double kg = 0.0;
  double sd_kg = 0.0;
};

/// One direction in which a mass moves along with the structure.
struct Load {
  std::size_t mass = 0;  ///< index into LoadedTest::masses
  Dof dof;               ///< sign +1
};

/// Which masses sat where.
struct LoadedTest {
  std::vector<KnownMass> masses;
  std::vector<std::size_t> set_up;       ///< per FRF
  std::vector<std::vector<Load>> loads;  ///< per set-up
};

/// An accelerance that was not measured, on the set's lines, for +1 signs.
struct ModelledFrf {
  Eigen::VectorXcd H;        ///< [(m/s^2)/N]
  Eigen::VectorXd variance;  ///< E|dH|^2
};

/// Accelerance of the structure as loaded in a set-up; empty if unknown.
using FrfModel = std::function<std::optional<ModelledFrf>(
    std::size_t set_up, const Dof& response, const Dof& reference)>;

enum class FreedBy {
  Measurement,
  Model,
  NoNeed,   ///< none of the masses was on the structure
  NotFreed  ///< the FRF is as measured, for the reason given
};

struct FreedNote {
  FreedBy by = FreedBy::NotFreed;
  std::string reason;  ///< of Model and NotFreed
};

struct FreedFrfs {
  FrfSet frfs;                   ///< in the order given
  std::vector<FreedNote> notes;  ///< per FRF
};

/// Takes the masses off every FRF that allows it. The variance of a freed FRF
/// holds what the removal adds.
///
/// @param loaded one set-up per FRF
/// @param model asked for what was not measured; may be empty
[[nodiscard]] FreedFrfs free_frfs(const FrfSet& frfs,
                                  const LoadedTest& loaded,
                                  const FrfModel& model,
                                  const Progress& progress = {});

}  // namespace tapfit::signal
