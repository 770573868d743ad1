// Numbers as a reader wants them: as many digits as they deserve, their
// uncertainty, their unit. Never "nan", never wider than needed.
#pragma once

#include "updating/fit/estimate.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

/// `digits` significant digits, plain from 1e-4 up to 1e6: "0.3142", "123500",
/// "1.235e+06"; "–" for what is no finite number.
[[nodiscard]] std::string number(double value, int digits = 4);

/// Fixed decimals; "–" for what is no finite number, 1e+12 beyond 1e7.
[[nodiscard]] std::string fixed(double value, int decimals);

/// A positive number as precisely as that many cells allow, at most two
/// decimals, never cut: 15.27 in three cells is "15", 12345 in four "12k".
/// @param width 3 at least
[[nodiscard]] std::string fitted(double value, int width);

/// 0.388 to "38.8 %"; below 0.95 % with two decimals.
[[nodiscard]] std::string percent(double fraction);

/// 0.983 to "98.3 %"; "<0.1 %" for what is small but not impossible.
[[nodiscard]] std::string probability(double share);

/// "1 effect", "2 effects".
[[nodiscard]] std::string effects_text(std::size_t count);

/// "2.27100 ± 0.00040", "119000 ± 12000": the deviation with two digits (or
/// one), the value to match. A deviation that is zero or not finite is left
/// away.
[[nodiscard]] std::string with_sd(double value, double sd, int digits = 2);

/// An estimate's value and its interval, both to the place of the deviation's
/// second digit, and plain or with a power of ten alike.
struct Spread {
  std::string value;     ///< "119000 ± 12000"
  std::string interval;  ///< "97000 … 146000"
};
[[nodiscard]] Spread spread(const updating::Estimate& estimate);

/// "mass_kg" to {"mass", "kg"}; "E:1" to {"E:1", "Pa"}.
struct NameAndUnit {
  std::string name;
  std::string unit;
};
[[nodiscard]] NameAndUnit split_unit(std::string_view name);

/// "E:1" to "E (MAT1 1)", "mesh size" to "mesh correction (size)"; others by
/// their name without its unit.
[[nodiscard]] std::string parameter_words(std::string_view name);

/// As updating::describe, the variant first, where a narrow column does not
/// cut it off: "rotation, 19 nodes (1 ... 38)".
[[nodiscard]] std::string place(const updating::Location& where);

/// "0.0785 ± 0.0006 kg". What the data do not tell from nothing, or would have
/// beyond its bound, is given by the end of its interval: "at most 0.75 kg".
[[nodiscard]] std::string size_words(const updating::Estimate& estimate);

/// Whether it is given by the ends of its interval alone.
[[nodiscard]] bool is_open(const updating::Estimate& estimate);

/// A parameter's name among those it was identified with: what is shared out
/// over no length, as at one grid, is no size per metre but that of its total.
[[nodiscard]] std::string told_name(const std::string& name,
                                    const std::vector<updating::Estimate>& all);

/// Those worth telling: without what would stand there twice then.
[[nodiscard]] std::vector<updating::Estimate> told(
    std::vector<updating::Estimate> estimates);

/// "mass 0.0785 ± 0.0006 kg".
[[nodiscard]] std::string describe(const updating::Estimate& estimate);

}  // namespace tapfit::tui
