// What a deck is wrong by in form, as a finding: what it leaves out that is
// missing in every structure, and the data show. It is fitted along with what
// is uncertain in every model, so that no effect stands in for it; it is no
// part of the verdict.
//
// Of a factor f with ln f ~ N(t_0, sd_0^2) before the data and N(t, sd^2) after
// them, the data speak for f against the deck's own 1 by
//
//   p(0) / p(0 | data) = sd / sd_0 exp(t^2 / (2 sd^2) - t_0^2 / (2 sd_0^2))
//
// Source: J. M. Dickey, "The Weighted Likelihood Ratio, Linear Hypotheses on
// Normal Location Parameters", Ann. Math. Statist. 42 (1971) (Savage's ratio).
#pragma once

#include "updating/fit/estimate.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {
struct Deck;
}

namespace tapfit::updating {

struct Fit;

struct ModelForm {
  std::string form;                ///< "section-shear", "line-mass", ...
  int property = 0;                ///< of the bars that do not shear
  std::vector<int> elements = {};  ///< at the corners
  Estimate share = {};             ///< 0: the deck's; 1: see deck_forms.hpp
  double probability = 0.0;        ///< against the deck as it stands
  double error = 0.0;              ///< that is left with it
  std::string card = {};  ///< mended, in the file's units: "PBAR,1,..."
};

/// One for each card or form, where the evidence is strong.
[[nodiscard]] std::vector<ModelForm> model_form(const Fit& fit,
                                                const structure::Deck& deck);

/// What is wrong, by how much and how surely, as a sentence.
[[nodiscard]] std::string statement(const ModelForm& form);

}  // namespace tapfit::updating
