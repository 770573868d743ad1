// What FRFs are held against without a model: driving points, and pairs
// measured both ways (signal/checks/frf_checks.hpp), as a list with the curves.
#pragma once

#include "signal/checks/frf_checks.hpp"
#include "tui/screen/screen.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// "mass of 2.1 kg", "stiffness of 3e4 N/m", "-".
[[nodiscard]] std::string low_line(const signal::DrivingPoint& point);
/// "fair", "polarity turned", "another point?", "not passive".
[[nodiscard]] std::string verdict(const signal::DrivingPoint& point);

/// Driving points first, then pairs.
[[nodiscard]] Table check_table(const signal::FrfSet& frfs,
                                const signal::FrfChecks& checks);

/// What was found of one, in a sentence.
[[nodiscard]] std::string finding(const signal::DrivingPoint& point);
[[nodiscard]] std::string finding(const signal::Reciprocal& pair);

/// The FRF of a row of the table; of a pair, the first.
[[nodiscard]] std::optional<std::size_t> checked_frf(
    const signal::FrfChecks& checks, std::size_t row);

/// The list above, then what was found of the selected one; below, of a driving
/// point its imaginary part, whose peaks must all point upwards, of a pair both
/// magnitudes and phases.
void draw_checks(Screen& screen,
                 const Rect& rect,
                 const signal::FrfSet& frfs,
                 const signal::FrfChecks& checks,
                 const ListState& list,
                 const PlotRange& range);

/// The FRF measured the other way round.
[[nodiscard]] std::optional<std::size_t> other_way(const signal::FrfSet& frfs,
                                                   std::size_t frf);

}  // namespace tapfit::tui
