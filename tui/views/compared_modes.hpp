// Modes of measurement and model side by side, with those that have no partner.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/table.hpp"
#include "tui/widgets/wireframe.hpp"
#include "updating/comparison/comparison.hpp"

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// What the Compare screen is drawn from.
struct CompareInput {
  const updating::Comparison& comparison;
  const signal::FrfSet& frfs;
  const Wireframe* wire = nullptr;
  /// For those without a partner, once they are at hand.
  const modal::ModeSet* modes = nullptr;
};

/// A pair, or a mode of one side alone, whose other members are NaN.
struct ComparedMode {
  double measured_hz = std::numeric_limits<double>::quiet_NaN();
  double model_hz = std::numeric_limits<double>::quiet_NaN();
  double error_percent = std::numeric_limits<double>::quiet_NaN();
  double mac = std::numeric_limits<double>::quiet_NaN();

  /// The measured frequency, or else the model's.
  [[nodiscard]] double hz() const;
};

/// By their frequency; of the model's own those within the lines of the FRFs.
[[nodiscard]] std::vector<ComparedMode> compared_modes(
    const CompareInput& input);

/// A "–" where there is no partner.
[[nodiscard]] Table compared_table(const std::vector<ComparedMode>& modes);

/// The measured modes that are paired with one of the model, or of one of two
/// models; "–" where they are not with that one.
/// @param after null where there is one model
[[nodiscard]] Table pair_table(const updating::Comparison& before,
                               const updating::Comparison* after);

/// "1.23 %", the mean of the pairs' frequency errors.
/// @pre there is a pair
[[nodiscard]] std::string mean_error_words(const updating::Comparison& c);

/// Of each measured mode, NaN where it is not known.
[[nodiscard]] std::vector<double> measured_hz(const CompareInput& input);

}  // namespace tapfit::tui
