// A small cantilevered plate with a made-up hammer test, for tests of the
// updating folder: FRFs come straight from the model, with nothing measured.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "updating/effects/effect.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/deck/deck.hpp"

namespace tapfit::support {

/// 0.30 m x 0.12 m x 3 mm aluminium, 10 x 4 shells, clamped along x = 0 where
/// `clamped`; grid ids 1 + i + 11 j, i along x (0..10), j along y (0..4).
[[nodiscard]] structure::Deck plate_deck(bool clamped);

/// Two accelerometers at grids 11 and 36, six hit points, one run each.
[[nodiscard]] acquisition::TestBundle plate_bundle();

[[nodiscard]] effects::TestContext plate_context(
    const acquisition::TestBundle& bundle, const structure::Deck& deck);

/// A base of the plate's own mesh to 400 Hz, at the points of the bundle.
[[nodiscard]] updating::BaseOptions plate_base(
    const acquisition::TestBundle& bundle, const structure::Deck& deck);

/// The pairs of the bundle on the lines given, FRFs still zero.
[[nodiscard]] signal::FrfSet plate_pairs(const acquisition::TestBundle& bundle,
                                         const Eigen::VectorXcd& s);

/// The plate, clamped or free, with its test and its base; one stiffness is
/// uncertain.
class BasedPlate {
 public:
  BasedPlate(const BasedPlate&) = delete;
  BasedPlate& operator=(const BasedPlate&) = delete;
  BasedPlate(BasedPlate&&) = delete;
  BasedPlate& operator=(BasedPlate&&) = delete;

 protected:
  explicit BasedPlate(bool clamped = true) : deck_(plate_deck(clamped)) {}
  ~BasedPlate() = default;

  structure::Deck deck_;
  acquisition::TestBundle bundle_ = plate_bundle();
  effects::TestContext context_ = plate_context(bundle_, deck_);
  updating::BaseBuilder builder_{
      deck_, bundle_.uncertain, plate_base(bundle_, deck_), Progress{}};
};

}  // namespace tapfit::support
