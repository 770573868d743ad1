// A pole taken out or put in by hand.
#pragma once

namespace tapfit::modal {

struct PoleEdit {
  enum class What {
    Drop,  ///< the mode nearest to the frequency
    Add,   ///< the steadiest pole of the diagram near there
  };

  What what = What::Drop;
  double hz = 0.0;

  bool operator==(const PoleEdit&) const = default;
};

}  // namespace tapfit::modal
