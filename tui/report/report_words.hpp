// How a report names effects, their places and what was identified: for readers
// who do not know the program's own names.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/localisation/signature_laws.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// "soft-support" to "support that gives"; of a group "a|b" both with "or", of
/// a verdict "a+b" with "and".
[[nodiscard]] std::string effect_words(const std::string& effect);

/// "19 nodes, 1 … 38; rotation"; empty for everywhere.
[[nodiscard]] std::string place_words(const updating::Location& where);

/// "mass of the sensors (acc1, acc2)"; of a group "a (place) or b".
[[nodiscard]] std::string found_words(const std::string& effect,
                                      const updating::Location& where);

/// "an added mass (node 5)" of found_words().
[[nodiscard]] std::string with_article(const std::string& found);

/// A parameter in the unit that its size asks for: g, GPa, ms.
struct Quantity {
  std::string name;      ///< "mass"
  std::string value;     ///< "20.04 ± 0.16"; "not determined"
  std::string interval;  ///< "19.72 … 20.36"
  std::string unit;
};
/// @param estimate its name without the effect's
[[nodiscard]] Quantity quantity(const updating::Estimate& estimate);

/// "70.7 GPa": a value alone as quantity() would write it.
[[nodiscard]] std::string value_words(const updating::Estimate& like,
                                      double value);

/// "to separate A from B: hit 144Z+ with acc1 at 146Z+ …".
[[nodiscard]] std::string next_words(const updating::NextMeasurement& next,
                                     double floor);

/// "noise 1.0 %, mesh 3.0 %, form 0.9 %": what the floor is made of; the form's
/// share where something was fitted.
[[nodiscard]] std::string floor_words(const updating::Comparison& comparison);

/// Comparison::contour as "evaluated at 136 frequencies, 1–55 Hz, with 3 %
/// added damping".
[[nodiscard]] std::string contour_words(const std::string& contour);

/// The same as the end of a sentence: "on 50 lines" where it is another line.
[[nodiscard]] std::string on_contour(const std::string& contour);

/// "error 12.3 % without it, 0.36 % with it".
[[nodiscard]] std::string drop_words(double without, double with);

/// "8.000", "36.70", "317.0": the same digits of all that stand together.
[[nodiscard]] std::string four_digits(double value);

/// "+1.91", "0.00", "−0.01".
[[nodiscard]] std::string signed_words(double value);

/// "+1.91 %", "0.00 %".
[[nodiscard]] std::string signed_percent_words(double percent);

/// With a capital letter in front.
[[nodiscard]] std::string capitalised(std::string text);

/// "A, B and C".
[[nodiscard]] std::string enumerated(const std::vector<std::string>& items);

/// Texts of other rooms as they are printed: ± and … in one character, a minus
/// and powers of ten as such, m/s² with its power, no backticks.
[[nodiscard]] std::string typeset(std::string text);

/// "a pure mass", "a spring", "a dashpot", "an absorber".
[[nodiscard]] std::string law_name(const updating::SignatureLaw& law);

}  // namespace tapfit::tui
